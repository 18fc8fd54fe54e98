#!/usr/bin/python3
"""The spatula as a beam in the plane: peak forces from its shape, in three seconds each, not from finite elements.

A chain of segments that stretch and of hinges that bend follows the centreline from the shaft's end to the tip. Widths
and thicknesses are those of Mesh/Type Spatula. The wall acts on the pad with the default law, without friction. Each
step raises the shaft's end, and Newton's method finds the minimum of the energy. A small viscosity leads over snaps.
The beam has no shear, no inertia and a straight front.

    docs/cookbook/spatula/reference.py > docs/cookbook/spatula/reference.csv      # shapes
    docs/cookbook/spatula/reference.py --parameters > docs/cookbook/spatula/parameters.csv
                               # the shape of xml/spatula.xml with one parameter 20 per cent smaller or larger"""
import pathlib
import sys

import numpy as np
from scipy import sparse
from scipy.integrate import trapezoid
from scipy.sparse.linalg import splu

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import recipe  # noqa: E402

# The defaults of Mesh/Type Spatula, shapes on the way to that of xml/spatula.xml, and the latter.
STIFF = {"Pad Length": 230.0, "Neck Width": 100.0, "Tip Width": 240.0, "Widening Length": 100.0, "Tip Length": 120.0,
         "Rear Thickness": 15.0, "Tip Thickness": 5.0, "Transition Length": 100.0, "Fillet Radius": 68.0,
         "Shaft Diameter": 80.0, "Shaft Length": 180.0, "Inclination": 45.0}
THIN = {**STIFF, "Rear Thickness": 5.0}
LATER = {"Widening Length": 150.0, "Tip Length": 80.0}
LATE = {**THIN, "Neck Width": 60.0, **LATER}
SHAPES = {"stiff": STIFF, "stiff, neck 60": {**STIFF, "Neck Width": 60.0}, "stiff, widest later": {**STIFF, **LATER},
          "thin": THIN, "narrow": {**THIN, "Neck Width": 60.0}, "late": LATE}
POISSON = 0.2
# Viscosities of the beam [E0 T0/L0^2]. The larger one saves iterations and adds 3 per cent to the late peak.
VISCOSITY, LARGER_VISCOSITY = 1e-9, 1e-7
# The coordinates of the first two nodes that do not move freely. The end keeps its direction unless it turns.
ENDS = {"held": [0, 1, 2, 3], "free along x": [1, 3], "free to turn": [0, 1]}
EARLY = 0.15  # lifts below this share of the pad's length belong to the first peak


class Centreline:
    """Nodes from the shaft's end to the tip: place, width, thickness, second moment and area of the section."""

    def __init__(self, shape, spacing):
        pad = np.linspace(0, shape["Pad Length"], round(shape["Pad Length"] / spacing) + 1)
        thickness = np.interp(pad, [0, shape["Pad Length"]], [shape["Rear Thickness"], shape["Tip Thickness"]])
        reach = shape["Transition Length"]
        along = np.concatenate([np.arange(spacing, reach, 2 * spacing),
                                np.linspace(reach, reach + shape["Shaft Length"], 25)])[::-1]
        radius, slope = shape["Fillet Radius"], np.radians(shape["Inclination"])
        angle = np.minimum(along / radius, slope)
        beyond = along - radius * angle
        share = np.minimum(along / reach, 1)
        disk = share**3 * (10 - 15 * share + 6 * share**2)  # 0: the pad's rectangle, 1: the shaft's disk
        base = recipe.EQUILIBRIUM_GAP
        self.first = len(along)  # node of the pad's rear end
        self.x = np.concatenate([-radius * np.sin(angle) - beyond * np.cos(angle), pad])
        self.z = np.concatenate([base + shape["Rear Thickness"] / 2 + radius * (1 - np.cos(angle))
                                 + beyond * np.sin(angle), base + thickness / 2])
        self.width = np.concatenate([shape["Neck Width"] + disk * (shape["Shaft Diameter"] - shape["Neck Width"]),
                                     outline(shape, pad)])
        self.thickness = np.concatenate([shape["Rear Thickness"] + disk
                                         * (shape["Shaft Diameter"] - shape["Rear Thickness"]), thickness])
        disk = np.concatenate([disk, 0 * pad])
        section = np.maximum(self.width, spacing)  # the tip has no width
        self.area = section * self.thickness * (1 - disk + disk * np.pi / 4)
        self.bending = section * self.thickness**3 * ((1 - disk) / 12 + disk * np.pi / 64) / (1 - POISSON**2)


def outline(shape, x):
    """Returns the pad's width at x: it widens by s^2 (3 - 2 s), and ends in half an ellipse."""
    s = np.clip(x / shape["Widening Length"], 0, 1)
    width = shape["Neck Width"] + (shape["Tip Width"] - shape["Neck Width"]) * s**2 * (3 - 2 * s)
    end = np.clip((x - shape["Pad Length"] + shape["Tip Length"]) / shape["Tip Length"], 0, 1)
    return width * np.sqrt(1 - end**2)


class Beam:
    """Energy, forces and stiffness of the chain at a vector of places (x, z, x, z, ...)."""

    def __init__(self, shape, spacing, end="held"):
        line = Centreline(shape, spacing)
        self.start = np.column_stack([line.x, line.z]).ravel()
        nodes = len(line.x)
        edges = np.diff(self.start.reshape(-1, 2), axis=0)
        self.lengths = np.hypot(*edges.T)
        self.stretching = (line.area[1:] + line.area[:-1]) / 2 / self.lengths
        self.turning = line.bending[1:-1] / ((self.lengths[1:] + self.lengths[:-1]) / 2)
        self.angles = np.diff(np.arctan2(edges[:, 1], edges[:, 0]))
        pad = np.arange(line.first, nodes)
        share = np.diff(line.x[pad]) * (line.width[pad][1:] + line.width[pad][:-1]) / 4
        self.pad_area = np.append(share, 0) + np.append(0, share)
        self.pad_dofs, self.under = 2 * pad + 1, line.thickness[pad] / 2
        self.mass = np.repeat(line.area * (np.append(self.lengths, 0) + np.append(0, self.lengths)) / 2, 2)
        self.free = np.setdiff1d(np.arange(2 * nodes), ENDS[end])
        self.driven = [dof for dof in ENDS[end] if dof % 2]
        self.edge_dofs = 2 * np.arange(nodes - 1)[:, None] + np.arange(4)
        self.hinge_dofs = 2 * np.arange(nodes - 2)[:, None] + np.arange(6)
        every = np.arange(2 * nodes)
        self.rows = np.concatenate([np.repeat(self.edge_dofs, 4, 1).ravel(), np.repeat(self.hinge_dofs, 6, 1).ravel(),
                                    every])
        self.columns = np.concatenate([np.tile(self.edge_dofs, 4).ravel(), np.tile(self.hinge_dofs, 6).ravel(), every])

    def gaps(self, q):
        return q[self.pad_dofs] - self.under

    def bonded(self, q):
        """Returns the area of pad at less than a nanometre more than twice the equilibrium gap."""
        return self.pad_area[self.gaps(q) < 2 * recipe.EQUILIBRIUM_GAP + 1].sum()

    def turns(self, edges):
        turn = np.diff(np.arctan2(edges[:, 1], edges[:, 0])) - self.angles
        return (turn + np.pi) % (2 * np.pi) - np.pi

    def elastic_energy(self, q):
        edges = np.diff(q.reshape(-1, 2), axis=0)
        return ((self.stretching * (np.hypot(*edges.T) - self.lengths)**2).sum()
                + (self.turning * self.turns(edges)**2).sum()) / 2

    def energy(self, q):
        """Returns the energy with that of the wall, infinite in the wall."""
        gaps = self.gaps(q)
        if gaps.min() < 0.05:
            return np.inf
        return self.elastic_energy(q) + (self.pad_area * recipe.law(gaps)[0]).sum()

    def derivatives(self, q):
        """Returns the energy's gradient and its second derivative."""
        edges = np.diff(q.reshape(-1, 2), axis=0)
        squares = (edges**2).sum(1)
        lengths = np.sqrt(squares)
        gradient = np.zeros(len(q))

        direction, tension = edges / lengths[:, None], self.stretching * (lengths - self.lengths)
        pull = tension[:, None] * direction
        np.add.at(gradient, self.edge_dofs, np.hstack([-pull, pull]))
        along = direction[:, :, None] * direction[:, None, :]
        k = self.stretching[:, None, None] * along + (tension / lengths)[:, None, None] * (np.eye(2) - along)
        stretch = np.block([[k, -k], [-k, k]])

        # An angle's gradient is the edge turned by 90 degrees over its squared length.
        moment, turned = self.turning * self.turns(edges), np.column_stack([-edges[:, 1], edges[:, 0]])
        turned /= squares[:, None]
        slope = np.hstack([turned[:-1], -turned[:-1] - turned[1:], turned[1:]])
        np.add.at(gradient, self.hinge_dofs, moment[:, None] * slope)
        product, difference = 2 * edges[:, 0] * edges[:, 1], edges[:, 1]**2 - edges[:, 0]**2
        curve = np.array([[product, difference], [difference, -product]]).transpose(2, 0, 1) / squares[:, None, None]**2
        first, second, none = curve[:-1], curve[1:], np.zeros_like(curve[1:])
        curve = np.block([[-first, first, none], [first, second - first, -second], [none, -second, second]])
        bend = self.turning[:, None, None] * slope[:, :, None] * slope[:, None, :] + moment[:, None, None] * curve

        _, push, change = recipe.law(self.gaps(q))
        gradient[self.pad_dofs] -= self.pad_area * push
        wall = np.zeros(len(q))
        wall[self.pad_dofs] = -self.pad_area * change
        values = np.concatenate([stretch.ravel(), bend.ravel(), wall])
        return gradient, sparse.csc_matrix((values, (self.rows, self.columns)), shape=(len(q), len(q)))


def direction_of(matrix, residual):
    """Returns Newton's direction, or one nearer to steepest descent if the former leads uphill."""
    shift = 0.0
    while True:
        step = -splu((matrix + shift * sparse.identity(len(residual))).tocsc()).solve(residual)
        if step @ residual < 0:
            return step
        shift = max(1e-4, 10 * shift)


def equilibrium(beam, last, start, drag):
    """Returns the places that minimise energy plus viscosity, and the force that holds the shaft's end."""
    def potential(q):
        return beam.energy(q) + (drag * (q - last)**2)[beam.free].sum() / 2

    q = start.copy()
    for _ in range(200):
        gradient, matrix = beam.derivatives(q)
        residual = (gradient + drag * (q - last))[beam.free]
        if np.linalg.norm(residual) < 1e-7 * max(1, abs(gradient).max()):
            break
        step = direction_of((matrix + sparse.diags(drag))[beam.free][:, beam.free], residual)
        now, slope, length = potential(q), step @ residual, min(1.0, 10 / abs(step).max())
        while True:
            trial = q.copy()
            trial[beam.free] += length * step
            if potential(trial) <= now + 1e-4 * length * slope + 1e-9 * abs(now):
                break
            length /= 2
            if length < 1e-6:
                return q, gradient[beam.driven].sum()
        q = trial
    return q, gradient[beam.driven].sum()


def peel(shape, step=1.0, spacing=1.0, end="held", viscosity=VISCOSITY):
    """Raises the shaft's end until the pad is free. Returns lift [L0] and force [E0 L0^2]."""
    beam = Beam(shape, spacing, end)
    q, lift, force = beam.start, [0.0], [0.0]
    while beam.bonded(q) > 0 and lift[-1] < 3 * shape["Pad Length"]:
        start = q.copy()
        start[beam.driven] += step
        q, pull = equilibrium(beam, q, start, viscosity * beam.mass / step)
        lift.append(lift[-1] + step)
        force.append(pull)
    return np.array(lift), np.array(force)


def measures(lift, force, length):
    """Returns first peak, least force after it and late peak, each with its lift; the lift of the release; the work.

    The first peak is the largest force at lifts below EARLY times the pad's length, the late peak the largest beyond.
    The release is the first force after the late peak below a tenth of it.
    """
    early = int(np.searchsorted(lift, EARLY * length))
    first = int(force[:early].argmax())
    late = early + int(force[early:].argmax())
    between = first + int(force[first:late + 1].argmin())
    after = np.flatnonzero(force[late:] < 0.1 * force[late])
    return {"first": (force[first], lift[first]), "trough": (force[between], lift[between]),
            "late": (force[late], lift[late]), "free": lift[late + after[0]] if len(after) else lift[-1],
            "work": trapezoid(force, lift)}


def scaled(shape, scale):
    """Returns a pad of another size that bends alike: its bending stiffness over W times its squared length stays."""
    def factor(name):
        return 1 if name == "Inclination" else scale**(2 / 3) if "Thickness" in name else scale
    return {name: factor(name) * value for name, value in shape.items()}


def varied():
    """Yields name, factor and shape: the shape of xml/spatula.xml with one parameter 20 per cent smaller or larger.

    The outline has to fit: Pad Length stretches all of the outline, and a longer widening or end shortens the other.
    Transition Length and Fillet Radius change together once."""
    for name in LATE:
        for factor in (0.8, 1.2):
            shape = {**LATE, name: factor * LATE[name]}
            room = shape["Pad Length"]
            if name == "Pad Length":
                shape |= {other: factor * LATE[other] for other in ("Widening Length", "Tip Length")}
            elif name == "Transition Length":  # a short one with a large fillet would sink below the pad's underside
                shape["Fillet Radius"] *= factor
            elif name == "Widening Length":
                shape["Tip Length"] = min(shape["Tip Length"], room - shape[name])
            elif name == "Tip Length":
                shape["Widening Length"] = min(shape["Widening Length"], room - shape[name])
            yield name, factor, shape
    for factor in (0.8, 1.2):
        both = {name: factor * LATE[name] for name in ("Rear Thickness", "Tip Thickness")}
        yield "both thicknesses", factor, {**LATE, **both}


def row(start, shape, scale=1.0, end="held"):
    """Prints a row of reference.csv after the cells of `start`: the measures of a pad, as those of the full pad."""
    lift, force = peel(scaled(shape, scale), scale, scale, end)
    found = measures(lift / scale, force / scale, shape["Pad Length"])
    print(f"{start},{found['first'][0]:.3f},{found['first'][1]:g},{found['trough'][0]:.3f},{found['late'][0]:.3f},"
          f"{found['late'][1]:g},{found['free']:g},{found['work']:.1f}", flush=True)


def parameter_row(start, shape):
    """Prints a row of parameters.csv. Its changes count, so it takes the larger viscosity."""
    found = measures(*peel(shape, viscosity=LARGER_VISCOSITY), shape["Pad Length"])
    print(f"{start},{found['first'][0]:.3f},{found['first'][1]:g},{found['trough'][0]:.3f},{found['late'][0]:.3f},"
          f"{found['late'][1]:g},{found['work']:.1f}", flush=True)


def main():
    if sys.argv[1:] == ["--parameters"]:
        print("parameter,factor,first,first_lift,trough,late,late_lift,work")
        parameter_row("none,1", LATE)
        for name, factor, shape in varied():
            parameter_row(f"{name},{factor:g}", shape)
        return
    print("shape,end,scale,first,first_lift,trough,late,late_lift,free,work")
    for name, shape in SHAPES.items():
        row(f'"{name}",held,1', shape)
    for name in ("stiff", "thin", "narrow", "late"):
        row(f"{name},held,0.25", SHAPES[name], 0.25)
    row("late,held,0.5", LATE, 0.5)
    for name in ("thin", "late"):
        for end in ("free along x", "free to turn"):
            row(f"{name},{end},1", SHAPES[name], end=end)


if __name__ == "__main__":
    main()
