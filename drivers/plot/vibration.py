#!/usr/bin/python3
"""Draws the coordinates of a probe over time, one panel per coordinate. It compares several runs, such as free
vibrations with different damping or schemes."""
import curves
import options
import style
from results import ResultsError, Run, common
from style import plt

EPILOG = """Examples:
  vibration.py damping/Newmark-* --output damping               x and z of the only probe
  vibration.py ball.results --probe Top --components xy --time 0,1

The position of the probe at rest is read from effective.xml. A cross marks where a run diverged; the limits of the axes
fit the other runs."""


def place(run, probe):
    """A probe's place in the undeformed body, by effective.xml."""
    value = run.setting(f"Output/Probes/{probe}/Point")
    try:
        return dict(zip("xyz", [float(word) for word in (value or "").strip("{} ").split(",")]))
    except ValueError:
        raise ResultsError(f"{run.folder / 'effective.xml'} has no position of the probe '{probe}'") from None


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folders", nargs="+", metavar="FOLDER",
                        help="a results folder (with history.csv, effective.xml)")
    parser.add_argument("--probe", metavar="PROBE", help="name of the probe (default: edge, or the only one)")
    parser.add_argument("--components", metavar="xyz",
                        help="coordinates to draw (default: x and the one normal to the wall)")
    parser.add_argument("--time", type=options.interval, metavar="FROM,TO", help="times to draw (default: all)")
    parser.add_argument("--output", metavar="NAME", help="output file, without ending (default: vibration, in "
                        "FOLDER or, for several runs, in the working folder)")
    parser.add_figure()
    parser.add_si()
    arguments = parser.parse_args()

    runs = [Run(folder, arguments.time) for folder in arguments.folders]
    curves.dress(runs)
    probe = runs[0].probe("u", arguments.probe)
    components = "x" + runs[0].up if arguments.components is None else arguments.components
    if not components or set(components) - set("xyz"[:runs[0].dimension]):
        parser.error(f"--components: '{components}' may only contain the letters {'xyz'[:runs[0].dimension]}")
    figure, grid = plt.subplots(len(components), 1, sharex=True, squeeze=False, layout="constrained",
                                figsize=(7.2, 0.9 + 2.3 * len(components)))
    for axes, component in zip(grid[:, 0], components):
        histories = [(run, place(run, probe)[component] * run.factor("length") + run[f"{probe}_u{component}"]) for run in runs]
        for run, values in histories:
            curves.draw_line(axes, run, values, run.color)
        curves.fit(axes, histories)
        axes.set_ylabel(f"{component} of {probe} {style.unit('length', runs[0].dimension)}")
    grid[-1, 0].set_xlabel(f"time {style.unit('time', runs[0].dimension)}")
    figure.align_ylabels()
    handles = [plt.Line2D([], [], color=run.color, linewidth=1.6) for run in runs]
    style.legend(figure, handles, [run.label for run in runs], common(runs) if len(runs) > 1 else None)
    usual = "vibration" if len(runs) > 1 else runs[0].folder / "vibration"
    style.save(figure, arguments.output or usual, arguments.format)


if __name__ == "__main__":
    options.run(main)
