"""The direction in which a scene pulls, and the force along it."""
import numpy as np

from scene_file import find

# The entry of a history that tells its size.
SIZES = {"Rate Ramp": "Rate", "Ramp": "Value", "Sine": "Amplitude", "Table": "Values", "Constant": "Value"}


def size(run, history):
    """The size of a history, with its sign, or None for an expression."""
    kind = run.setting(f"Histories/{history}/Type") or "Constant"
    text = run.setting(f"Histories/{history}/{kind}/{SIZES.get(kind)}")
    try:
        return float(text.strip("{} ").split(",")[-1])
    except (AttributeError, ValueError):
        return None


def motions(run):
    """By node set whose reactions are recorded: the history of each axis along which the scene moves it."""
    found = {}
    conditions = find(run.scene, "Boundary Conditions")
    for condition in [] if conditions is None else conditions:
        values = {entry.get("name"): entry.get("value") for entry in condition}
        node_set, history = values.get("Node Set"), values.get("History")
        if values.get("Type", "Displacement") == "Displacement" and history and f"reaction_{node_set}_x" in run.columns:
            axes = values.get("Components", "all").replace("all", "xyz")[:3]
            found.setdefault(node_set, {}).update({axis: history for axis in axes if axis in "xyz"[:run.dimension]})
    return found


def direction(run):
    """(node set, unit vector) of the first such motion; None where there is none, or it follows no one direction."""
    for node_set, histories in motions(run).items():
        if len(set(histories.values())) == 1:
            sizes = {axis: 1.0 for axis in histories}
        else:
            sizes = {axis: size(run, history) for axis, history in histories.items()}
        vector = [sizes.get(axis, 0.0) for axis in "xyz"[:run.dimension]]
        if None not in vector and any(vector):
            return node_set, np.array(vector) / np.linalg.norm(vector)
    return None


def force(run, reaction=None):
    """(what it is, times, values) of a reaction; without its name, along an oblique pull the component along the pull,
    else the first reaction normal to the wall."""
    pull = None if reaction else direction(run)
    if pull is None or abs(pull[1]["xyz".index(run.up)]) == 1:
        column, times, values = run.reaction(reaction)
        return "pull-off force" if column.endswith("_" + run.up) else column.replace("_", " "), times, values
    node_set, vector = pull
    parts = [run.reaction(f"{node_set}_{axis}") for axis in "xyz"[:run.dimension]]
    words = ", ".join(f"{component:.2g}" for component in vector)
    return f"force along the pull ({words})", parts[0][1], sum(c * part[2] for c, part in zip(vector, parts))
