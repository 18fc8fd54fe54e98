"""The table of docs/python.md: the time that a call from Python adds to a step."""
import re

from ..table import Column, Table

LINE = re.compile(r"^(.*?)\s+(-?[\d.]+) us$", re.MULTILINE)


def measure(context):
    output = context.run_text("tests/bench/python_overhead.py", variables={"PYTHONPATH": str(context.build / "python")})
    times = {what: float(time) for what, time in LINE.findall(output)}
    step = times["a step, looped in C++"]
    return [{"call": what, "to such a step": time / step, "µs": time} for what, time in times.items()]


TABLES = [
    Table("python-calls", "docs/python.md",
          [Column("call"), Column("to such a step", "{:.2f}"), Column("µs", "{:.1f}")], measure,
          ("python", "lib/time"), ("ixos_python",), minutes=0.3),
]
