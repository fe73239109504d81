#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""K6: the Ergun test of CFDEMcoupling: a bed of 1 mm spheres, 15.6 mm high, in a dense gas that goes up until it floats.

Spheres of 2000 kg/m3, gas of 10 kg/m3 and 1.5e-4 m2/s, 0.002 to 0.02 m/s, there and back; in its cylinder, and in a
box without walls, also three times as high. Inside a fixed bed the pressure falls as Ergun says at the porosity there;
afloat, the bed hangs on the gas. Over the whole of so low a bed it falls by less: its ends are looser, and so is the
ring at the wall.
"""
import math
import sys

sys.dont_write_bytecode = True
import runs  # noqa: E402

WORK = runs.BUILD / "fluidized_bed"
DIAMETER = 1e-3  # [m]
SOLID, GAS, VISCOSITY = 2000.0, 10.0, 1.5e-3  # [kg/m3], [Pa s]
CASE = """
{column}
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
bed_height = "{height} mm"
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
CYLINDER = """
[column]
shape = "cylinder"
inner_diameter = "27.7 mm"
height = "30 mm"
"""
BOX = """
[column]
shape = "box"
size = ["12 mm", "12 mm", "{top} mm"]
[column.boundaries]
x = "periodic"
y = "periodic"
z = "wall"
"""
# Column, height of the bed [mm], cross-section [m2].
PIECES = {
    "box": (BOX.format(top=30), 15.6, 144e-6),
    "high-box": (BOX.format(top=90), 46.8, 144e-6),  # whose ends count a third
    "cylinder": (CYLINDER, 15.6, math.pi / 4 * 27.7e-3**2),
}


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


def gradient_inside(folder, plateau):
    """Of the pressure over the middle half of the bed [Pa/m]."""
    height = float(plateau["bed_height_m"])
    layers = [(0.5 * (float(r["z_low_m"]) + float(r["z_high_m"])), float(r["pressure_Pa"]))
              for r in runs.rows(folder / "profiles" / f"plateau_z_{int(plateau['plateau']):06}.csv")]
    (low, p_low), *_, (high, p_high) = [layer for layer in layers if 0.25 * height < layer[0] < 0.75 * height]
    return abs(p_high - p_low) / (high - low)


def run_piece(piece):
    column, height, area = PIECES[piece]
    folder = WORK / piece
    runs.run(CASE.format(column=column, height=height), folder)
    series = runs.rows(folder / "series.csv")
    solids = float(series[-1]["particles"]) * math.pi / 6 * DIAMETER**3 / area  # height of the spheres alone [m]
    weight = solids * (SOLID - GAS) * 9.81
    print("velocity_m_s,pressure_drop_Pa,gradient_inside_Pa_m,bed_height_m,porosity,porosity_inside,weight_Pa,floor_Pa,steady")
    for row in runs.rows(folder / "plateaus.csv"):
        start, end = float(row["start_time_s"]), float(row["end_time_s"])
        late = [r for r in series if 0.5 * (start + end) <= float(r["time_s"]) <= end and r["pressure_drop_Pa"]]
        mean = {key: sum(abs(float(r[key])) for r in late) / len(late)
                for key in ("pressure_drop_Pa", "floor_force_N", "bed_height_m")}
        print(",".join(str(v) for v in (
            abs(float(row["superficial_velocity_m_s"])), mean["pressure_drop_Pa"], gradient_inside(folder, row),
            mean["bed_height_m"], 1 - solids / mean["bed_height_m"], row["middle_porosity"], weight,
            mean["floor_force_N"] / area, row["steady"])))


def judge(tables):
    good = True
    for piece, table in tables.items():
        table = [{k: float(v) for k, v in row.items()} for row in table]
        for r in table:
            whole = ergun(r["porosity"], r["velocity_m_s"]) * r["bed_height_m"]
            inside = ergun(r["porosity_inside"], r["velocity_m_s"])
            print(f"{piece}, {r['velocity_m_s']:.3f} m/s: {r['pressure_drop_Pa']:.1f} Pa, of the weight "
                  f"{r['pressure_drop_Pa'] / r['weight_Pa']:.3f}, on the floor {r['floor_Pa'] / r['weight_Pa']:.3f}; "
                  f"{r['bed_height_m'] * 1e3:.2f} mm, porosity {r['porosity']:.4f}, inside {r['porosity_inside']:.4f}; over Ergun's: "
                  f"whole {r['pressure_drop_Pa'] / whole:.3f}, inside {r['gradient_inside_Pa_m'] / inside:.3f}")
        if piece == "cylinder":
            continue
        for way, rows in (("up", table[:10]), ("down", table[10:])):
            fixed = [r for r in rows if r["velocity_m_s"] < 0.0101 and r["steady"]]  # not one that still settles
            afloat = [r for r in rows if r["velocity_m_s"] > 0.0119]
            if fixed:
                inside = sum(r["gradient_inside_Pa_m"] for r in fixed) / sum(
                    ergun(r["porosity_inside"], r["velocity_m_s"]) for r in fixed)
                good &= runs.line(f"{piece}, way {way}, fixed bed: pressure gradient inside over Ergun's", inside, 0.97, 1.03,
                                  "K6: 3 %")
            else:
                print(f"{piece}, way {way}: settles still on all plateaus below 0.0101 m/s")
            hangs = sum(r["pressure_drop_Pa"] / r["weight_Pa"] for r in afloat if r["velocity_m_s"] < 0.0141) / 2
            good &= runs.line(f"{piece}, way {way}, just afloat (0.012, 0.014 m/s): pressure drop over the weight", hangs,
                              0.97, 1.03, "K6: 3 %")
            good &= runs.line(f"{piece}, way {way}, bubbling (0.016 m/s and more): the same",
                              sum(r["pressure_drop_Pa"] / r["weight_Pa"] for r in afloat if r["velocity_m_s"] > 0.0159)
                              / sum(r["velocity_m_s"] > 0.0159 for r in afloat), 0.97, 1.03, "K6: 3 %")
            if way == "down":
                continue
            if not fixed:  # there is no line to meet the plateau
                good = False
                continue
            slope = sum(r["pressure_drop_Pa"] for r in fixed) / sum(
                ergun(r["porosity"], r["velocity_m_s"]) * r["bed_height_m"] for r in fixed)
            porosity = fixed[-1]["porosity"]
            good &= runs.line(f"{piece}, velocity at which the line of the fixed bed meets that plateau, over Ergun's",
                              floats(porosity, slope / hangs) / floats(porosity, 1.0), 0.97, 1.03, "K6: 3 %")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
