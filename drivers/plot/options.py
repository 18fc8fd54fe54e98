"""One command line for all scripts: types of options, complaints on one line with exit status 2."""
import argparse
import pathlib
import re
import sys

import style
import units
from results import ResultsError

FORMATS = ("png", "svg", "pdf", "eps")


def formats(text):
    """The type of --format."""
    words = text.split(",")
    for word in words:
        if word not in FORMATS:
            raise argparse.ArgumentTypeError(f"unknown format '{word}'; allowed: {', '.join(FORMATS)}, or several: png,svg")
    return words


def width(text):
    """The type of --width: a length in mm, cm or in. Returns inches."""
    match = re.fullmatch(r"([0-9.]+) ?(mm|cm|in)", text)
    try:
        value = float(match[1]) / {"mm": 25.4, "cm": 2.54, "in": 1.0}[match[2]] if match else 0.0
    except ValueError:
        value = 0.0
    if not 0.5 <= value <= 100:
        raise argparse.ArgumentTypeError(f"'{text}' is not a width of half an inch or more such as 86mm, 8.6cm or 3.4in")
    return value


def scale(text):
    """The type of --relative: 'initial' or a number above zero."""
    try:
        if text == "initial" or float(text) > 0:
            return text if text == "initial" else float(text)
    except ValueError:
        pass
    raise argparse.ArgumentTypeError(f"'{text}' is neither initial nor a number greater than 0")


def positive(text):
    """The type of options that take a number above zero."""
    value = numbers(text)
    if len(value) != 1 or not value[0] > 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number greater than 0")
    return value[0]


def numbers(text):
    """The type of options that take numbers separated by commas."""
    try:
        values = [float(word) for word in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a list of numbers such as 0,0.5,1") from None
    return values


def count(text):
    """The type of options that take a whole number above zero."""
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number greater than 0")
    return int(text)


def interval(text):
    """The type of options that take two rising numbers."""
    values = numbers(text)
    if len(values) != 2 or not values[1] > values[0]:
        raise argparse.ArgumentTypeError(f"'{text}' is not an interval FROM,TO such as 0,0.5")
    return values


def direction(text):
    """The type of --view: three numbers, not all zero; from straight above or below no picture stands upright."""
    values = numbers(text)
    if len(values) != 3 or not any(values[:2]):
        raise argparse.ArgumentTypeError(f"'{text}' is not a direction X,Y,Z such as 0.6,-1,0.4, or it is vertical")
    return values


def scaled_unit(text):
    """The type of --unit: a number above zero and a name."""
    factor, _, name = text.partition(",")
    if not name:
        raise argparse.ArgumentTypeError(f"'{text}' is not a factor and a name such as 2,nN")
    return positive(factor), name


def zoom(text):
    """The type of --zoom: an interval, and perhaps that of the ordinate."""
    values = numbers(text)
    if len(values) not in (2, 4) or not all(low < high for low, high in zip(values[::2], values[1::2])):
        raise argparse.ArgumentTypeError(f"'{text}' is neither an interval such as 30,50 nor two such as 30,50,0,0.2")
    return values


def oscillation(text):
    """The type of --oscillation: an interval and a width above zero."""
    values = numbers(text)
    if len(values) != 3 or not values[1] > values[0] or not values[2] > 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not an interval and a window such as 60,100,5")
    return values[:2], values[2]


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """Writes the titles with capitals, as the programs do: help2man looks for these."""

    def add_usage(self, usage, actions, groups, prefix=None):
        super().add_usage(usage, actions, groups, prefix or "Usage: ")

    def start_section(self, heading):
        super().start_section(heading.capitalize())


class Parser(argparse.ArgumentParser):
    """A parser whose complaints take one line."""

    def __init__(self, description, epilog):
        super().__init__(description=description, epilog=epilog, formatter_class=HelpFormatter)

    def add_si(self):
        """Adds --si; parse_args() carries it out."""
        self.add_argument("--si", action="store_true", help="draw in SI units; numbers of other options are in the "
                          "units of the axes then (default: L0, E0 and T0 of the scene)")

    def add_along(self):
        """Adds the options of curves along a surface."""
        self.add_argument("--field", type=lambda text: text.split(","), metavar="NAME,...",
                          help="fields of nodes, or components such as interaction_tractionY (default: those of "
                          "surfaces that the file has)")
        self.add_argument("--times", type=numbers, metavar="T1,T2,...",
                          help="times of the curves (default: four, one of them that of the largest force)")

    def add_figure(self):
        """Adds the options of a figure's files; parse_args() carries them out, and `format` has the formats."""
        group = self.add_argument_group("figure")
        group.add_argument("--format", type=formats, default=None, metavar="FORMAT",
                           help="png, svg, pdf or eps, or several as png,pdf (default: png)")
        group.add_argument("--pdf", action="store_true", help="write NAME.pdf; fonts are embedded")
        group.add_argument("--eps", action="store_true", help="write NAME.eps; fonts are embedded")
        group.add_argument("--dpi", type=count, help=f"pixels an inch of PNG (default: {style.DPI})")
        group.add_argument("--width", type=width, metavar="WIDTH", help="width of the figure, such as 86mm or 3.4in")
        group.add_argument("--data", action="store_true",
                           help=f"write NAME{style.DATA}, too, with the points of all lines and the cells")

    def parse_args(self, *arguments, **keywords):
        """Parses as argparse does. --si takes effect with the units of the first results folder."""
        parsed = super().parse_args(*arguments, **keywords)
        if hasattr(parsed, "pdf"):
            more = [name for name in ("pdf", "eps") if getattr(parsed, name)]
            parsed.format = list(dict.fromkeys((parsed.format or ([] if more else ["png"])) + more))
            style.output = style.Output(parsed.dpi or style.DPI, parsed.width, parsed.data)
        if getattr(parsed, "si", False):
            units.use_si(parsed.folder if hasattr(parsed, "folder") else parsed.folders[0])
        return parsed

    def error(self, message):
        self.exit(2, f"{self.prog}: {message} (--help lists the options)\n")


def run(main):
    """Runs a script: a ResultsError becomes one line and exit status 2."""
    try:
        main()
    except ResultsError as error:
        print(f"{pathlib.Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        sys.exit(2)
