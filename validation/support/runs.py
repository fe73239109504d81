# SPDX-License-Identifier: BSD-3-Clause
"""What validations that call `packbed run` share. It lies beside their scripts in the build."""
import csv
import fcntl
import json
import pathlib
import subprocess
import sys

BUILD = pathlib.Path(__file__).resolve().parent.parent
PACKBED = BUILD / "packbed"
CM_H = 0.01 / 3600  # [m/s]


def run(case, folder):
    """Runs a case text in a folder, unless it has ended there. One process runs it, others wait."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    with open(folder.parent / (folder.name + ".lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        file = folder.parent / (folder.name + ".toml")
        same = file.exists() and file.read_text() == case
        if same and (folder / "summary.json").exists():
            return
        file.write_text(case)
        how = "--resume" if same and list(folder.glob("checkpoints/*.h5")) else "--overwrite"
        subprocess.run([PACKBED, "run", file, "-n", "1", "-o", folder, how], check=True, stdout=sys.stderr)


def rows(file):
    """Rows of a table, as dictionaries of text; lines that begin with # are left out."""
    with open(file) as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def summary(folder):
    return json.loads((folder / "summary.json").read_text())


def print_plateaus(folder, more={}):
    """The plateaus of a run in lab units, with the compression of the sections at their ends; more: functions of a plateau."""
    about = summary(folder)
    sections = rows(folder / "sections.csv")
    print("velocity_cm_h,pressure_drop_bar,pressure_drop_bar_m,bed_height_mm,compression,budget_error,pressure_noise,"
          "steady,settled_porosity,settled_height_mm,wall_time_s," + ",".join([f"section_{k}" for k in range(1, 8)] + list(more)))
    for p in rows(folder / "plateaus.csv"):
        here = [s["compression"] for s in sections if abs(float(s["time_s"]) - float(p["end_time_s"])) < 1e-9]
        print(",".join(str(v) for v in [
            float(p["superficial_velocity_m_s"]) / CM_H, float(p["pressure_drop_Pa"]) * 1e-5,
            float(p["pressure_drop_per_height_Pa_m"]) * 1e-5, float(p["bed_height_m"]) * 1e3, p["compression"],
            p["budget_error"], p["pressure_noise"] or 0, p["steady"], about["settled_porosity"],
            about["settled_height_m"] * 1e3, about["wall_time_s"]] + here + [value(p) for value in more.values()]))


def at_highest_flow(table):
    """The last plateau at the highest velocity."""
    highest = max(float(r["velocity_cm_h"]) for r in table)
    return [r for r in table if float(r["velocity_cm_h"]) > highest - 1e-6][-1]


def line(what, value, low, high, reference):
    """Prints a figure with its limits; whether it is within them."""
    good = low <= value <= high
    print(f"{'met' if good else 'NOT MET'}: {what}: {value:.4g} ({low:.4g} to {high:.4g}, {reference})")
    return good


def tables(folder, pieces):
    """Tables of the pieces that are there, by name; says which are missing."""
    there = {}
    for piece in pieces:
        path = pathlib.Path(folder) / f"{piece}.csv"
        if path.exists():
            there[piece] = rows(path)
        else:
            print(f"missing: {piece}")
    return there


def main(pieces, run_piece, judge):
    what = sys.argv[1] if len(sys.argv) > 1 else ""
    if what == "pieces":
        print("\n".join(pieces))
    elif what == "files":
        print(f"{PACKBED}\n{pathlib.Path(__file__).resolve()}")
    elif what == "run":
        run_piece(sys.argv[2])
    elif what == "judge":
        there = tables(sys.argv[2], pieces)
        return 0 if judge(there) and len(there) == len(list(pieces)) else 1
    return 0
