#!/usr/bin/python3
# %% [markdown]
# # A strip peels off, with three strengths of adhesion
#
# This script is a notebook: Jupyter and most editors run its cells one by one. It needs the module `ixos`, NumPy and
# matplotlib. `peel_strip.py --small` runs a coarse mesh in a few seconds; the tests do so.
#
# The wall holds a strip of 200 nm x 10 nm along the left 150 nm of its lower side. A rig lifts the right edge at
# 1 nm/ns. The scene is `xml/strip.xml`; the script changes only how strongly the wall attracts.

# %%
import argparse
import pathlib
import sys

import ixos
import matplotlib

if "ipykernel" not in sys.modules:  # a notebook shows the picture itself
    matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("--small", action="store_true", help="a coarse mesh, long steps, the first 60 ns")
parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("peel-strip"), help="folder of the results")
arguments, _ = parser.parse_known_args()  # a notebook has arguments of its own
here = pathlib.Path(globals().get("__file__", "docs/examples/peel_strip.py")).resolve()
SCENE = next(folder / "xml/strip.xml" for folder in here.parents if (folder / "xml/strip.xml").exists())

# %% [markdown]
# ## The scene
#
# Lists and parameters of a scene are attributes; completion shows their names. `gamma_w` is the ratio of the strip's
# stiffness to the wall's energy density: a small ratio is a strong wall.


# %%
def strip(gamma):
    """Returns the scene of the strip before a wall of that ratio gamma_W."""
    scene = ixos.Scene(SCENE)
    scene.interactions.Wall.gamma_w = gamma
    scene.output.fields_time_interval = None  # no fields.e
    if arguments.small:
        scene.mesh.box.divisions = [80, 4]
        scene.time_integrator.time_step_control.time_step = 0.5
        scene.time_integrator.time_step_control.final_time = 60
    return scene


# %% [markdown]
# ## The work of adhesion
#
# Separating a unit area costs W = 15^(1/3) pi/(8 gamma_W gamma_L), see docs/theory.md. At the start 150 nm of the strip
# stand at the distance of least energy, so the energy of the contact is -150 W. One look at the simulation, before any
# step, confirms it.


# %%
def work_of_adhesion(gamma_w, gamma_l=2.5):
    return 15 ** (1 / 3) * np.pi / (8 * gamma_w * gamma_l)


at_start = strip(25).simulation()
print(f"contact energy {at_start.energies['contact_energy']:.4f}, -150 W = {-150 * work_of_adhesion(25):.4f} E0 L0^2")

# %% [markdown]
# ## The runs
#
# An observer is called after each accepted step. It reads the simulation: here, how far the contact has opened. The
# arrays `u`, `points` and `gaps` need no copy; what is kept beyond the step is one number.


# %%
class Crack:
    """Records the place up to which the strip sticks: its rightmost node with a gap below half a nanometre."""

    def __init__(self):
        self.times, self.places = [], []

    def __call__(self, simulation):
        sticks = np.nan_to_num(simulation.gaps, nan=np.inf) < 0.5
        self.times.append(simulation.time)
        self.places.append(simulation.points[sticks, 0].max(initial=0))


runs = {}
for gamma in (20, 25, 50):
    crack = Crack()
    done = strip(gamma).run(arguments.output / f"gamma-{gamma}", overwrite=True, observer=crack)
    runs[gamma] = done, crack
    print(f"gamma_W = {gamma}: {done.status} at {done.end_time:.4g} ns after {done.steps} steps, energy error "
          f"{done.max_energy_error / done.largest_energy:.1e} of the largest energy")

# %% [markdown]
# ## The pictures
#
# Results are columns of `history.csv` as arrays. The scheme's reactions are means over a step, so they belong to its
# middle. In plane strain forces are per depth; E0 L0 = 2 GPa nm = 2 N/m.

# %%
figure, (force, front) = plt.subplots(2, 1, sharex=True, figsize=(7, 6), layout="constrained")
for gamma, (done, crack) in runs.items():
    results = done.results
    middle = results["time"] - results["time_step"] / 2
    force.plot(middle[1:], 2 * results["reaction_right_y"][1:], label=f"$\\gamma_W$ = {gamma}")
    front.plot(crack.times, crack.places)
force.set_ylabel("force on the edge [N/m]")
force.legend()
front.set_ylabel("the strip sticks up to [nm]")
front.set_xlabel("time [ns]")
figure.savefig(arguments.output / "peel-strip.png", dpi=150)

# %% [markdown]
# ## The numbers
#
# A stronger wall needs a larger force, and the front moves later.

# %%
for gamma, (done, crack) in runs.items():
    print(f"gamma_W = {gamma}: W = {work_of_adhesion(gamma):.5f} E0 L0, largest force "
          f"{2 * done.max_forces['reaction_right_y']:.4f} N/m, sticks up to {crack.places[-1]:.1f} nm at the end")
