#!/usr/bin/python3
"""Animates the run of a plane body as a GIF or MP4: the body coloured by stress, and beside it the energies over time."""
import pathlib

import numpy as np
from matplotlib import colormaps
from matplotlib.animation import FFMpegWriter, PillowWriter
from matplotlib.colors import to_rgb
from PIL import Image

import options
import style
import units
from exodus import Fields
from fields import draw_body
from results import ResultsError, Run, flat_wall, within
from style import plt

EPILOG = """Examples:
  animate.py ball.results                            at most 250 frames -> ball.results/animation.gif
  animate.py ball.results --every 4 --fps 20 --output ball.gif
  animate.py ball.results --time 0,1                 only these times
  animate.py ball.results --output ball.mp4          a movie; needs ffmpeg

The folder must contain fields.e (or its series of one file per rank) and, for the energies, history.csv. The GIF has
640 x 400 pixels and stores only the changes from frame to frame. Stresses beyond the ends of the colour bar have the
colour of the ends."""

LINES = style.COLORS[:3] + ["#000000"]


def palette():
    """The colours of all frames: shades of stress, plain and on their way to a cell's edge; of the lines; greys."""
    def blend(color, other, weight):
        return (1 - weight) * np.array(to_rgb(color)) + weight * np.array(to_rgb(other))
    shades = [colormaps["RdBu_r"](x)[:3] for x in np.linspace(0, 1, 80)]
    colors = shades + [blend(shade, style.INK, 0.45) for shade in shades[::2]]
    colors += [blend(color, "white", k / 8) for color in LINES[:3] for k in range(8)]
    colors += [(x, x, x) for x in np.linspace(0, 1, 64)]
    return (np.array(colors) * 255).round().astype("u1")


def nearest_table(colors):
    """The number of the nearest colour for each red, green and blue of 64 levels."""
    levels = np.linspace(0, 255, 64)
    squares = [(levels[:, None] - colors[:, part]) ** 2 for part in range(3)]
    plane = squares[1][:, None] + squares[2][None]
    return np.array([(red + plane).argmin(axis=2) for red in squares[0]], dtype="u1")


class SmallGifWriter(PillowWriter):
    """A writer of small files: one palette for all frames, transparent where nothing changed."""

    def finish(self):
        colors = palette()
        table, clear = nearest_table(colors), np.uint8(len(colors))
        before, frames = None, []
        for picture in self._frames:
            pixels = table[tuple(np.moveaxis(np.array(picture.convert("RGB")) >> 2, 2, 0))]
            frames.append(Image.fromarray(pixels if before is None else np.where(pixels == before, clear, pixels)))
            frames[-1].putpalette(colors.tobytes() + b"\xff\xff\xff")
            before = pixels
        frames[0].save(self.outfile, save_all=True, append_images=frames[1:], duration=round(1000 / self.fps), loop=0,
                       transparency=int(clear), disposal=1, optimize=False)


def writer_of(target, fps):
    """The writer of a file by its ending."""
    if target.endswith(".gif"):
        return SmallGifWriter(fps=fps)
    if not target.endswith(".mp4"):
        raise ResultsError(f"{target}: a movie ends in .gif or .mp4")
    if not FFMpegWriter.isAvailable():
        raise ResultsError(f"{target}: the program ffmpeg writes mp4, and it is not installed; write a .gif")
    return FFMpegWriter(fps=fps, extra_args=["-pix_fmt", "yuv420p"])  # which all players know


def draw_energies(axes, run, times):
    """Axes and empty lines of the energies. Returns (line, point, values) of each."""
    curves = []
    for kind, color in zip(("kinetic", "elastic", "contact", "total"), LINES):
        if not run.has(f"{kind}_energy"):
            continue
        values = run[f"{kind}_energy"]
        line, = axes.plot([], [], color=color, label=kind, linewidth=0.8)
        point, = axes.plot([], [], "o", color=color, markersize=3)
        curves.append((line, point, values))
    low, high = min(np.nanmin(v) for *_, v in curves), max(np.nanmax(v) for *_, v in curves)
    margin = 0.06 * (high - low or 1)
    axes.set(xlim=(times[0], times[-1]), ylim=(low - margin, high + margin), xlabel=f"time {style.unit('time', 2)}",
             ylabel=f"energy {style.unit('energy', run.body_dimension)}")
    axes.legend(ncol=2, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2, handlelength=1.4)
    return curves


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folder", metavar="FOLDER", help="a results folder (with fields.e)")
    parser.add_argument("--fps", type=options.count, default=25, help="frames per second (default: 25)")
    parser.add_argument("--every", type=options.count, metavar="K",
                        help="take every K-th frame of the run (default: the smallest K that gives at most 250 frames)")
    parser.add_argument("--time", type=options.interval, metavar="FROM,TO", help="times to show (default: all)")
    parser.add_argument("--output", metavar="NAME", help="output file, .gif or .mp4 (default: FOLDER/animation.gif)")
    parser.add_si()
    arguments = parser.parse_args()

    target = arguments.output or str(pathlib.Path(arguments.folder) / "animation.gif")
    writer = writer_of(target, arguments.fps)  # refuses before anything is drawn
    fields = Fields(arguments.folder, "first_stress_invariant")
    if fields.dimension != 2:
        raise ResultsError(f"{fields.path}: the body is not plane; fields.py renders bodies in space")
    run = Run(arguments.folder, arguments.time)
    inside = np.flatnonzero(within(fields.times, arguments.time or fields.times[[0, -1]]))
    frames = inside[::arguments.every or -(-len(inside) // 250) or 1]
    if len(frames) < 2:
        raise ResultsError(f"{fields.path} has fewer than two frames to show")

    values = [fields.of_wholes(fields.element("first_stress_invariant", frame), frame) for frame in frames]
    every = np.concatenate(values)
    outlines = [fields.polygons(frame) for frame in frames]
    # One rare peak would pale all else: the colours end at the stress that a cell in a thousand exceeds.
    bound = float(np.quantile(np.abs(every), 0.999))
    noise = style.is_noise("first_stress_invariant", every) or not bound
    colors = style.color_scale("first_stress_invariant", every, None if noise else (-bound, bound))
    wall = flat_wall(arguments.folder)
    limits = style.box(np.concatenate([polygon for frame in outlines for polygon in frame]), wall)

    figure, (left, right) = plt.subplots(1, 2, figsize=(6.4, 4.0), layout="constrained", width_ratios=[1.15, 1])
    body = draw_body(left, outlines[0], values[0], colors, limits, wall)
    left.set(xlabel=f"x {style.unit('length', 2)}", ylabel=f"y {style.unit('length', 2)}")
    left.tick_params(direction="out")
    clock = left.set_title(f"t = 0.00 {units.name('time', 2)}")
    bar = figure.colorbar(body, ax=left, location="bottom", aspect=30, shrink=0.9, extend="both",
                          label=style.FIELD_LABELS["first_stress_invariant"].replace("\n", " "))
    bar.outline.set_linewidth(0.5)
    curves = draw_energies(right, run, fields.times[frames]) if run.has("kinetic_energy") else []
    right.set_visible(bool(curves))
    figure.canvas.draw()
    figure.set_layout_engine("none")  # settled: nothing may move from frame to frame

    try:
        with writer.saving(figure, str(target), dpi=100):
            for frame, polygons, value in zip(frames, outlines, values):
                time = fields.times[frame]
                body.set_verts(polygons)
                body.set_array(value)
                clock.set_text(f"t = {time:.2f} {units.name('time', 2)}")
                rows = np.searchsorted(run["time"], time * (1 + 1e-12), side="right")
                for line, point, energy in curves:
                    line.set_data(run["time"][:rows], energy[:rows])
                    point.set_data(run["time"][rows - 1:rows], energy[rows - 1:rows])
                writer.grab_frame()
    except (OSError, ValueError) as error:
        raise ResultsError(f"{target} cannot be written: {error}") from None
    print(target)


if __name__ == "__main__":
    options.run(main)
