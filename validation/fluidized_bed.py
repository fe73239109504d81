#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""K6: the Ergun test of CFDEMcoupling: a bed of 1 mm spheres, 15.6 mm high, in a dense gas that goes up until it floats.

Spheres of 2000 kg/m3, gas of 10 kg/m3 and 1.5e-4 m2/s, 0.002 to 0.02 m/s, there and back. Fixed, the bed has Ergun's
pressure drop at its own porosity; afloat, it hangs on the gas; the velocity between follows from both.
"""
import math
import sys

sys.dont_write_bytecode = True
import runs  # noqa: E402

WORK = runs.BUILD / "fluidized_bed"
DIAMETER, BED_DIAMETER = 1e-3, 27.7e-3  # [m]
SOLID, GAS, VISCOSITY = 2000.0, 10.0, 1.5e-3  # [kg/m3], [Pa s]
CASE = """
[column]
shape = "cylinder"
inner_diameter = "27.7 mm"
height = "30 mm"
[column.mesh]
cell = "1.5 mm"
[resin]
density = "2000 kg/m3"
contact = "hertz"
youngs_modulus = "1 MPa"
poisson_ratio = 0.45
restitution = 0.9
friction = 0.5
rolling_friction = 0
wall_friction = 0
[resin.sizes]
distribution = "monodisperse"
diameter = "1 mm"
[liquid]
density = "10 kg/m3"
viscosity = "1.5e-3 Pa s"
[drag]
law = "ergun"
[numerics]
inertia_scale = 1
[output]
checkpoint_interval = "3 min"
analysis = false
[[protocol]]
step = "settle"
bed_height = "15.6 mm"
[[protocol]]
step = "flow_ramp"
to = "-0.02 m/s"
steps = 10
hold = "0.3 s"
[[protocol]]
step = "flow_ramp"
from = "-0.02 m/s"
to = "-0.002 m/s"
steps = 9
hold = "0.3 s"
"""
PIECES = ("up-and-down",)


def ergun(porosity, u):
    """Pressure drop per height [Pa/m] (Ergun 1952)."""
    s = 1 - porosity
    return (150 * VISCOSITY * s * s / porosity**3 / DIAMETER**2 + 1.75 * GAS * s / porosity**3 / DIAMETER * u) * u


def floats(porosity, factor):
    """Velocity [m/s] at which a factor times Ergun's pressure drop carries the bed."""
    low, high = 0.0, 1.0
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        carried = factor * ergun(porosity, middle) >= (1 - porosity) * (SOLID - GAS) * 9.81
        low, high = (low, middle) if carried else (middle, high)
    return high


def run_piece(piece):
    folder = WORK / piece
    runs.run(CASE, folder)
    count = float(runs.rows(folder / "series.csv")[-1]["particles"])
    solids = count * math.pi / 6 * DIAMETER**3 / (math.pi / 4 * BED_DIAMETER**2)  # height of the spheres alone [m]
    print("velocity_m_s,pressure_drop_Pa,bed_height_m,porosity,weight_Pa")
    for row in runs.rows(folder / "plateaus.csv"):
        height = float(row["bed_height_m"])
        print(",".join(str(v) for v in (
            abs(float(row["superficial_velocity_m_s"])), abs(float(row["pressure_drop_Pa"])), height, 1 - solids / height,
            solids * (SOLID - GAS) * 9.81)))


def judge(tables):
    if not tables:
        return False
    table = [{k: float(v) for k, v in row.items()} for row in tables[PIECES[0]]]
    for r in table:
        print(f"{r['velocity_m_s']:.4f} m/s: {r['pressure_drop_Pa']:.2f} Pa, {r['pressure_drop_Pa'] / r['weight_Pa']:.4f} of "
              f"the weight, {r['bed_height_m'] * 1e3:.3f} mm, porosity {r['porosity']:.4f}, Ergun "
              f"{ergun(r['porosity'], r['velocity_m_s']) * r['bed_height_m']:.2f} Pa")
    good = True
    for way, rows in (("up", table[:10]), ("down", table[10:])):
        fixed = [r for r in rows if r["velocity_m_s"] < 0.0101]
        afloat = [r for r in rows if r["velocity_m_s"] > 0.0171]
        ratio = sum(r["pressure_drop_Pa"] for r in fixed) / sum(
            ergun(r["porosity"], r["velocity_m_s"]) * r["bed_height_m"] for r in fixed)
        plateau = sum(r["pressure_drop_Pa"] / r["weight_Pa"] for r in afloat) / len(afloat)
        good &= runs.line(f"way {way}, fixed bed: pressure drop over Ergun's", ratio, 0.97, 1.03, "K6: 3 %")
        good &= runs.line(f"way {way}, afloat: pressure drop over the weight", plateau, 0.97, 1.03, "K6: 3 %")
        if way == "down":  # a bed that has just settled from the gas: its line meets the plateau where it floats
            porosity = fixed[-1]["porosity"]
            good &= runs.line("velocity at which it floats, over Ergun's",
                              floats(porosity, ratio / plateau) / floats(porosity, 1.0), 0.97, 1.03, "K6: 3 %")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
