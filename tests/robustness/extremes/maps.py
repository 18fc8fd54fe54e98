"""Maps of outcomes: schemes over a parameter, coloured by the energy error."""
import numpy as np

from runs import SCHEMES, number  # adds the folder of style to the path

import style

FAILED, REFUSED, WRONG = "#BDBDBD", "#FFFFFF", "#D62728"


def cell(outcome):
    """Value of a map and of a table: log10 of the energy error, or a letter."""
    if outcome.kind == "completed":
        return float(np.log10(max(outcome.energy_error(), 1e-16)))
    return {"failed": "F", "refused": "R"}.get(outcome.kind, "!")


def word(outcome):
    """The same for a table."""
    if outcome.kind == "completed":
        return number(outcome.energy_error(), 1)
    if outcome.kind == "failed":
        return f'fails at {number(outcome.run["time"][-1], 2)}'
    return outcome.kind


def draw(axes, outcomes, names, values, label):
    """outcomes[row][column] in a grid of colours; returns the image for a colour bar."""
    cells = [[cell(outcome) for outcome in row] for row in outcomes]
    colours = np.array([[value if isinstance(value, float) else np.nan for value in row] for row in cells])
    image = axes.imshow(colours, aspect="auto", cmap="viridis", vmin=-15, vmax=0, interpolation="nearest")
    fills = {"F": FAILED, "R": REFUSED, "!": WRONG}
    for i, row in enumerate(cells):
        for j, value in enumerate(row):
            if isinstance(value, float):
                continue
            axes.add_patch(style.plt.Rectangle((j - 0.5, i - 0.5), 1, 1, color=fills[value], linewidth=0))
            axes.text(j, i, {"F": "×", "R": "–", "!": "!"}[value], ha="center", va="center", fontsize=7)
    axes.set_xticks(range(len(values)), [power(value) for value in values])
    axes.set_yticks(range(len(names)), names)
    axes.set_xlabel(label)
    axes.grid(False)
    axes.tick_params(length=0)
    return image


def power(value):
    """A tick's label: powers of ten as such."""
    exponent = np.log10(value)
    return f"$10^{{{round(exponent)}}}$" if abs(exponent - round(exponent)) < 1e-9 else f"{value:g}"


def picture(panels, path, names=tuple(SCHEMES), columns=1):
    """Panels (title, outcomes, values, label) below or beside each other with one colour bar."""
    style.use_style()
    rows = -(-len(panels) // columns)
    width = max(len(panel[2]) for panel in panels) * 0.36 + 1.4
    figure, axes = style.plt.subplots(rows, columns, figsize=(columns * width + 0.8, rows * (0.24 * len(names) + 0.75)),
                                      squeeze=False, layout="constrained", sharey=columns > 1)
    for axis, (title, outcomes, values, label) in zip(axes.flat, panels):
        image = draw(axis, outcomes, names, values, label)
        axis.set_title(title, fontsize=8.5)
    bar = figure.colorbar(image, ax=axes, ticks=[-15, -10, -5, 0], pad=0.02, shrink=0.9)
    bar.set_ticklabels(["$10^{-15}$", "$10^{-10}$", "$10^{-5}$", "1"])
    bar.set_label("energy error\n(× failed)", fontsize=8)
    style.save(figure, str(path), ["png"])
    style.plt.close(figure)


def rows(outcomes, names, values):
    """Rows of a table with a column a value."""
    return [[name, *map(word, row)] for name, row in zip(names, outcomes)]


def messages(outcomes):
    """What users see: each kind of message once, numbers as #, with how often."""
    import re
    seen = {}
    for row in outcomes:
        for outcome in row:
            if outcome.kind != "completed":
                text = re.sub(r"-?\d[\d,.]*(e[+-]?\d+)?", "#", outcome.message)
                seen.setdefault(text, []).append(outcome)
    return [f'- {len(found)} times, exit status {found[0].status}: "{text}"' for text, found in seen.items()]
