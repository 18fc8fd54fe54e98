"""A run by its results folder: history.csv, summary.json, effective.xml (fields.e, or its series: exodus.py)."""
import functools
import pathlib

import numpy as np

import result_files
import units
from scene_file import ResultsError, existing, find, is_axisymmetric, read_scene

UNDAMPED = "no damping"

# Their reactions are means over the step, so belong to its middle.
STEP_MEAN_SCHEMES = {"Gautam-Sauer Composite", "Average Vector Field", "Energy-Momentum", "Midpoint"}


class Run:
    """history.csv as columns (NaN where a cell is empty; of `interval` in time only) in the units of the axes, and
    summary.json."""

    def __init__(self, folder, interval=None):
        self.folder = existing(folder)
        self.columns = result_files.read_history(self.folder / "history.csv")
        if not len(self["time"]):
            self._refuse("no rows")
        self.dimension = 3 if "linear_momentum_z" in self.columns else 2
        self.up = "z" if self.dimension == 3 else "y"
        self.body_dimension = 3 if is_axisymmetric(self.folder) else self.dimension  # of the units
        self._scales = units.scales(self.folder)
        units.convert_history(self.columns, self._scales, self.body_dimension)
        self.initial_energy = self["total_energy"][0]
        self._first = {name: values[0] for name, values in self.columns.items()}
        self.whole = not interval or interval[1] >= self["time"][-1]  # nothing cut off the end
        if interval:
            inside = within(self["time"], interval)
            if np.count_nonzero(inside) < 2:
                raise ResultsError(f"{self.folder / 'history.csv'} has no rows from time {interval[0]:g} to "
                                   f"{interval[1]:g}: it goes from {self['time'][0]:g} to {self['time'][-1]:g}")
            self.columns = {name: values[inside] for name, values in self.columns.items()}
        self.summary = result_files.read_summary(self.folder / "summary.json")
        self.scheme = self.summary.get("scheme", self.folder.resolve().name)

    def __getitem__(self, name):
        if name not in self.columns:
            self._refuse(f"no column '{name}'")
        return self.columns[name]

    def _refuse(self, complaint):
        raise ResultsError(f"{self.folder / 'history.csv'} has {complaint}")

    def factor(self, quantity):
        """Returns the factor from numbers of the scene to those of the axes."""
        return units.factor(self._scales, quantity, self.body_dimension)

    def has(self, name):
        """Whether the column holds anything."""
        return bool(np.isfinite(self[name]).any())

    def energy_error(self):
        """|E - E0 - external work + dissipated energy + energy released by jumps to other equilibria - energy that changes
        of the mesh added|, row by row; of all but E what came after the first row, where a restart in another folder has
        a past."""
        def since_first(name):
            return np.nan_to_num(self[name] - np.nan_to_num(self._first[name])) if name in self.columns else 0.0

        return np.abs(self["total_energy"] - self.initial_energy - since_first("external_work") +
                      since_first("dissipated_energy") + since_first("released_energy") - since_first("adapted_energy"))

    def reactions(self):
        """(name, times, values) of each reaction column, at the times that the values belong to."""
        means = self.scheme in STEP_MEAN_SCHEMES
        time = self["time"] - 0.5 * self["time_step"] if means else self["time"]
        first = int(means and self["step"][0] == 0)
        return [(name, time[first:], values[first:]) for name, values in self.columns.items()
                if name.startswith("reaction_")]

    def reaction(self, name=None):
        """One of the reactions, where finite: of that name, with or without 'reaction_'; else the first upward one."""
        known = self.reactions()
        for column, times, values in known:
            if column in (name, f"reaction_{name}") or (name is None and column.endswith("_" + self.up)):
                there = np.isfinite(values)
                if not there.any():
                    self._refuse(f"an empty column '{column}'")
                return column, times[there], values[there]
        wanted = f"reaction_*_{self.up}" if name is None else name
        return self._refuse(f"no column '{wanted}'; its reactions: {', '.join(r[0] for r in known) or 'none'}")

    def probe(self, kind, name=None):
        """The probe of that name that has displacements (kind u) or velocities (v). Without a name: the only one, where
        'edge' is the driven one, so the first choice for its displacement and the last for a speed."""
        known = [column[:-3] for column in self.columns if column.endswith(f"_{kind}{self.up}")]
        choice = [name] if name else known
        if name is None and "edge" in known and len(known) > 1:
            choice = ["edge"] if kind == "u" else [probe for probe in known if probe != "edge"]
        if len(choice) == 1 and choice[0] in known:
            return choice[0]
        wanted = f"column '{name or '*'}_{kind}{self.up}'"
        return self._refuse(f"several probes, an option must name one: {', '.join(choice)}" if len(choice) > 1 else
                            f"no {wanted}; its probes: {', '.join(known) or 'none'}")

    def speed(self, probe):
        """Size of a probe's velocity."""
        return np.sqrt(sum(self[f"{probe}_v{axis}"] ** 2 for axis in "xyz"[:self.dimension]))

    @functools.cached_property
    def scene(self):
        """effective.xml, or None where there is no such file."""
        return read_scene(self.folder)

    def setting(self, path):
        """A value of the scene by its list path, or None."""
        entry = find(self.scene, path)
        return None if entry is None else entry.get("value")

    @property
    def time_step(self):
        """The scene's time step, or None."""
        value = self.setting("Time Integrator/Time Step Control/Time Step")
        try:
            return None if value is None else float(value)
        except ValueError as error:
            raise ResultsError(f"{self.folder / 'effective.xml'}: {error}") from None

    @property
    def element(self):
        """The contact element of the scene's first interaction; None without any."""
        if find(self.scene, "Interactions/*") is None:
            return None
        asked = self.setting("Interactions/*/Contact Element") or "Q1C1"
        return "Q2C2" if asked == "Q1C1" and self.setting("Mesh/Cell Order") == "2" else asked  # their own side

    @property
    def damping(self):
        """The stiffness damping of the scene's first material as words, or None where it names none."""
        value = self.setting("Materials/*/Stiffness Damping")
        return value and (f"α₂ = {self._time(float(value))}" if float(value) else UNDAMPED)

    def _time(self, value):
        """A time of the scene as text."""
        return f"{value * self.factor('time'):g} {units.name('time', self.dimension)}"

    def applied(self, times):
        """The displacement that the scene's driven motion, a Rate Ramp, has at some times."""
        conditions = find(self.scene, "Boundary Conditions")
        names = [] if conditions is None else [find(condition, "History") for condition in conditions]
        names = [entry.get("value") for entry in names if entry is not None]
        name = next((name for name in names if self.setting(f"Histories/{name}/Type") == "Rate Ramp"), None)
        if name is None:
            raise ResultsError(f"{self.folder / 'effective.xml'} has no motion that follows a Rate Ramp")
        path = f"Histories/{name}/Rate Ramp"
        rate, start, length = (float(self.setting(f"{path}/{word}") or 0) for word in ("Rate", "Start", "Length"))
        times = np.asarray(times) / self.factor("time") - start
        return self.factor("length") * rate * ramp_integral(times, length, self.setting(f"{path}/Shape") or "Cosine")

    def traits(self):
        """The traits that tell runs apart, as words: scheme, contact element, time step, damping."""
        return self.scheme, self.element, self.time_step and f"Δt = {self._time(self.time_step)}", self.damping


def ramp_integral(times, length, shape):
    """The integral of a ramp from 0 to 1 over a length of time, from its start."""
    s = np.clip(times / length, 0, 1) if length > 0 else np.ones_like(times)
    grown = {"Linear": s ** 2 / 2, "Cosine": s / 2 - np.sin(np.pi * s) / (2 * np.pi),
             "Quintic": s ** 4 * (2.5 - 3 * s + s ** 2)}[shape]
    return length * grown + np.maximum(times - length, 0)


def within(times, interval):
    """Tells for each time whether it lies in the interval, up to round-off."""
    slack = 1e-9 * (interval[1] - interval[0])
    return (times >= interval[0] - slack) & (times <= interval[1] + slack)


def labels(runs):
    """A label for each run: the traits in which the runs differ. Falls back to the folder's name if there are none, or
    if two runs would have the same label."""
    table = [run.traits() for run in runs]
    differ = [len(runs) == 1 and trait == 0 or len(set(values)) > 1 for trait, values in enumerate(zip(*table))]
    names = [", ".join(word for word, counts in zip(words, differ) if word and counts) for words in table]
    return [name if name and names.count(name) == 1 else run.folder.resolve().name for run, name in zip(runs, names)]


def common(runs):
    """The traits that all runs share, as a title."""
    columns = zip(*(run.traits() for run in runs))
    return ", ".join(values[0] for values in columns if values[0] not in (None, UNDAMPED) and len(set(values)) == 1)


def flat_wall(folder):
    """The scene's flat wall by effective.xml, in the units of the axes: its height if the body is above it, else a point
    and the normal towards the body, as a pair. 0 if it is unknown, None if there is no such wall, or if it moves."""
    scene = read_scene(folder)
    if scene is None:
        return 0.0
    interactions = find(scene, "Interactions")
    for interaction in [] if interactions is None else interactions.findall("ParameterList"):
        value = {entry.get("name"): entry.get("value") for entry in interaction.findall("Parameter")}
        if value.get("Obstacle", "Half-Space") != "Half-Space" or value.get("Primary Side Set"):
            continue  # there is a curved obstacle, or another body
        motion = find(interaction, "Motion")
        moved = {entry.get("name"): entry.get("value") for entry in ([] if motion is None else motion)}
        if moved.get("Rotation") or moved.get("Translation", "").strip("{} "):
            return None
        try:
            normal, point = ([float(word) for word in value.get(name, "{}").strip("{} ").split(",") if word]
                             for name in ("Normal", "Point"))
        except ValueError as error:
            raise ResultsError(f"{pathlib.Path(folder) / 'effective.xml'}: {error}") from None
        factor = units.factor(units.scales(folder), "length", 2)
        if not any(normal[:-1]) and not (normal and normal[-1] < 0):
            return point[-1] * factor if point else 0.0
        return np.array(point or [0.0] * len(normal)) * factor, np.array(normal) / np.linalg.norm(normal)
    return None
