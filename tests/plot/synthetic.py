"""Results folders of peeling runs without a simulation: a strip's force, contact and motion from formulas."""
import csv
import json
import pathlib

import numpy as np

SCENE = """<ParameterList name="Strip">
  <ParameterList name="Interactions"><ParameterList name="Wall">{element}</ParameterList></ParameterList>
  <ParameterList name="Time Integrator"><ParameterList name="Time Step Control">
    <Parameter name="Time Step" type="double" value="{step:.17e}"/>
  </ParameterList></ParameterList>
</ParameterList>
"""
COLUMNS = ("step time time_step kinetic_energy elastic_energy contact_energy external_work dissipated_energy "
           "total_energy linear_momentum_x linear_momentum_y angular_momentum_z contact_force_x contact_force_y "
           "contact_measure min_gap newton_iterations linear_iterations wall_seconds reaction_right_x reaction_right_y "
           "edge_ux edge_uy edge_vx edge_vy P_ux P_uy P_vx P_vy").split()
START, END = 40.0, 130.0  # of the peeling


def force(time, ripple=0.0, period=0.4):
    """Pull-off force: a rise until the peeling starts, a slow fall, vibration once the strip is free."""
    peak, plateau = 0.32, 0.19
    rise = peak * (np.minimum(time, START) / START) ** 2
    fall = plateau + (peak - plateau) * np.exp(-(np.maximum(time, START) - START) / 12)
    free = 0.06 * np.exp(-(np.maximum(time, END) - END) / 4) * np.cos(3 * (time - END))
    peeling = ripple * np.sin(2 * np.pi * time / period) * (time > START)
    return np.where(time < START, rise, np.where(time < END, fall + peeling, free))


def contact(time):
    """Contact length: 150 until the peeling starts, then a linear fall to 0 at its end."""
    return np.clip(150 * (END - time) / (END - START), 0, 150)


def write_history(folder, known, columns=COLUMNS):
    """Writes history.csv; columns that are not known stay empty."""
    with open(folder / "history.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        for row in range(len(known["time"])):
            cells = [known[name][row] if name in known else np.nan for name in columns]
            writer.writerow(["" if np.isnan(cell) else format(float(cell), ".17g") for cell in cells])


def peel(folder, scheme="Newmark", step=0.1, element=None, ripple=0.0, end=150.0, cost=0.004, iterations=4, mean=False,
         status="stopped"):
    """Writes history.csv, summary.json and effective.xml. mean: the force belongs to the middle of each step."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    time = step * np.arange(round(end / step) + 1)
    count = len(time) - 1
    pulled = force(time - step / 2 if mean else time, ripple)
    pulled[0] = np.nan if mean else pulled[0]
    height = 200 * np.clip((time - 110) / 40, 0, None) ** 3
    known = {
        "step": np.arange(len(time)), "time": time, "time_step": np.where(time > 0, step, 0.0),
        "total_energy": 0.1 * time - 1, "contact_measure": contact(time),
        "newton_iterations": np.where(time > 0, iterations, 0), "reaction_right_x": 0.1 * pulled,
        "reaction_right_y": pulled, "edge_vy": np.minimum(time / START, 1),
        "edge_uy": np.where(time < START, time ** 2 / (2 * START), time - START / 2),
        "P_ux": -0.75 * height, "P_uy": height, "P_vx": -0.75 * np.gradient(height, time),
        "P_vy": np.gradient(height, time),
    }
    write_history(folder, known)
    (folder / "summary.json").write_text(json.dumps({
        "status": status, "scheme": scheme, "end_time": float(time[-1]), "steps": count,
        "newton_iterations": round(count * iterations),
        "wall_seconds": count * cost, "seconds_per_increment": cost, "max_energy_error": None, "max_force": {}}))
    chosen = f'<Parameter name="Contact Element" type="string" value="{element}"/>' if element else ""
    (folder / "effective.xml").write_text(SCENE.format(element=chosen, step=step))
    return folder
