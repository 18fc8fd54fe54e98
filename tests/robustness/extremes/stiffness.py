"""Young's moduli from 1e-6 to 1e6 E0 before the same wall, in the same steps."""
import maps
from gap import block
from runs import EQUILIBRIUM, SCHEMES, steps, table

MODULI = [float(f"1e{k}") for k in range(-6, 7)]


def study(runner, images):
    outcomes = [[runner(f"stiffness/{scheme}/{modulus}",
                        {**block(1.1 * EQUILIBRIUM), **steps(scheme, 1e-4, 300), "Materials/Body/Young's Modulus": modulus})
                 for modulus in MODULI] for scheme in SCHEMES]
    title = "released at 1.1 times the equilibrium gap, Δt = 0.0001 T₀"
    maps.picture([(title, outcomes, MODULI, "Young's modulus [E₀]")], images / "extremes-stiffness")
    return [*table(["scheme", *map(str, MODULI)], maps.rows(outcomes, SCHEMES, MODULI)), "", *maps.messages(outcomes)]
