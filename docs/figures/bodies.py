"""Bodies of a chosen size before anything peels, and what a Newton iteration of a run takes."""
from .runs import FINAL_TIME, TIME_STEP
from .table import Column

# On these folders depends what a run computes, and how fast.
MECHANICS = ("lib/balance", "lib/discretization", "lib/element", "lib/fem", "lib/geometry", "lib/interaction",
             "lib/material", "lib/mesh", "lib/model", "lib/rule", "lib/solve", "lib/state", "lib/term",
             "lib/time")
PHASES = ("residual", "tangent", "factorization", "linear solve")
COLUMNS = [Column("Newton iterations a step", "{:.2f}", "Newton"),
           Column("CG iterations a Newton iteration", "{:.1f}", "CG"),
           Column("s a Newton iteration", "{:.3g}", "seconds"), *(Column(phase, "{:.3g}") for phase in PHASES),
           Column("memory, GB", "{:.2f}", "memory")]


def divisions(*counts):
    """Returns the setting of a box with so many cells along its edges."""
    return f"Mesh/Box/Divisions={{{', '.join(map(str, counts))}}}"


def steps(count, step=0.5):
    """Returns the settings of so many steps, of `step` T0 each."""
    return [f"{TIME_STEP}={step}", f"{FINAL_TIME}={count * step}"]


def spatula(cells, count):
    """Returns scene and settings of so many steps of the spatula on about so many hexahedra, while its pull rises."""
    return "spatula-stiff", [f"Mesh/Spatula/Target Cells={cells}", f"Histories/Pull/Rate Ramp/Length={0.5 * count}",
                             *steps(count)]


def block(edges, count, step=0.5):
    """Returns scene and settings of so many steps of the block on the wall, of so many unit cubes along its edges."""
    lengths = ", ".join(map(str, edges))
    return "block-on-wall", [divisions(*edges), f"Mesh/Box/Lengths={{{lengths}}}",
                             f"Histories/Pull/Rate Ramp/Length={min(count * step, 2)}", *steps(count, step)]


def iterative(preconditioner, operator="", solver=""):
    """Returns the settings of CG with a preconditioner; operator: Matrix-Free or Assembled; solver: of Direct."""
    settings = ["Linear Solver Type=Belos", f"Preconditioner Type={preconditioner}"]
    if operator:
        settings.append(f"Operator={operator}")
    if solver:
        settings.append(f"Preconditioner Types/Direct/Solver Type={solver}")
    return [f"Linear Solver/{setting}" for setting in settings]


def per_iteration(summary):
    """Returns the numbers of COLUMNS, of a run's summary; times are seconds of the wall clock."""
    newton = max(summary["newton_iterations"], 1)
    return {"Newton": newton / summary["steps"], "CG": summary["linear_iterations"] / newton,
            "seconds": summary["wall_seconds"] / newton, "memory": summary["peak_memory_bytes"] / 1e9,
            **{phase: summary["seconds"].get(phase, 0.0) / newton for phase in PHASES}}
