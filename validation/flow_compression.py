#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A slice of a lab column of CM Sepharose 6FF under a flow to 2763 cm/h, one setting changed at a time.

Answers validation/validate.sh: pieces, run PIECE, judge FOLDER, files. Each piece takes the settled bed of
its porosity (settled when it is first asked for) and calls `packbed run`.
"""
import csv
import fcntl
import json
import pathlib
import subprocess
import sys

BUILD = pathlib.Path(__file__).resolve().parent.parent  # build/validation
PACKBED = BUILD / "packbed"
WORK = BUILD / "flow_compression"  # beds and runs; tables go to standard output
CM_H = 0.01 / 3600

COLUMN = """
[column]
shape = "slice"
inner_diameter = "10 mm"
slice_depth = "0.9 mm"
height = "40 mm"
[resin]
name = "CM Sepharose 6FF"
coarse_grain = 3
{resin}
[liquid]
temperature = "20 degC"
"""
RAMP = """
[[protocol]]
step = "flow_ramp"
to = "2763 cm/h"
steps = 20
hold = "0.8 s"
"""
BACK = """
[[protocol]]
step = "flow_ramp"
from = "2763 cm/h"
to = "0 cm/h"
steps = 20
hold = "0.8 s"
"""
HERTZ = 'contact = "hertz"\nyoungs_modulus = "5.53 MPa"'  # thesis fig. 8.1

# Name: porosity of the settled bed (none: as it settles), keys of [resin], further sections, steps.
PIECES = {
    "porosity-0.38": (0.38, "", "", RAMP),
    "porosity-0.39": (0.39, "", "", RAMP + BACK),
    "porosity-0.40": (None, "", "", RAMP),
    "merged": (0.39, "", '[coupling]\noverlap = "merged"', RAMP),
    "clamp-0.40": (0.39, "", "[drag]\nmin_void_fraction = 0.40", RAMP),
    "width-half": (0.39, "", '[coupling]\naveraging_width = "0.395 mm"', RAMP),
    "width-twice": (0.39, "", '[coupling]\naveraging_width = "1.57 mm"', RAMP),
    "hertz": (0.39, HERTZ, "", RAMP),
    "hertz-0.38": (0.38, HERTZ, "", RAMP),
}
LAB = {"pressure_drop_bar_m": 37.0, "compression": 0.12}  # thesis chapter 8.1, at 2763 cm/h


def run(case, folder):
    """Runs a case text in a folder, unless it has ended there."""
    if (folder / "summary.json").exists():
        return
    folder.parent.mkdir(parents=True, exist_ok=True)
    file = folder.parent / (folder.name + ".toml")
    same = file.exists() and file.read_text() == case
    file.write_text(case)
    how = ["--resume"] if same and list(folder.glob("checkpoints/*.h5")) else ["--overwrite"]
    subprocess.run([PACKBED, "run", file, "-n", "1", "-o", folder] + how, check=True, stdout=sys.stderr)


def bed(porosity):
    """Folder of a settled bed; one process settles it, others wait."""
    name = "as it settles" if porosity is None else f"{porosity}"
    folder = WORK / "beds" / name.replace(" ", "-")
    folder.parent.mkdir(parents=True, exist_ok=True)
    with open(folder.parent / (folder.name + ".lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        wish = "" if porosity is None else f"porosity = {porosity}\n"
        run(COLUMN.format(resin="") + f'[[protocol]]\nstep = "settle"\nbed_height = "31 mm"\n{wish}', folder)
    return folder


def run_piece(piece):
    porosity, resin, more, steps = PIECES[piece]
    start = bed(porosity)
    folder = WORK / "runs" / piece
    run(COLUMN.format(resin=resin) + more + f'\n[beads]\nrun = "{start}"\n' + steps, folder)
    summary = json.loads((folder / "summary.json").read_text())
    with open(folder / "plateaus.csv") as file:
        rows = list(csv.DictReader(file))
    with open(folder / "sections.csv") as file:
        sections = list(csv.DictReader(file))
    head = ["velocity_cm_h", "pressure_drop_bar", "pressure_drop_bar_m", "compression", "budget_error",
            "pressure_noise", "steady", "settled_porosity", "wall_time_s"] + [f"section_{k}" for k in range(1, 8)]
    print(",".join(head))
    for row in rows:
        here = [s for s in sections if abs(float(s["time_s"]) - float(row["end_time_s"])) < 1e-9]
        print(",".join(str(v) for v in [
            float(row["superficial_velocity_m_s"]) / CM_H, float(row["pressure_drop_Pa"]) * 1e-5,
            float(row["pressure_drop_per_height_Pa_m"]) * 1e-5, row["compression"], row["budget_error"],
            row["pressure_noise"], row["steady"], summary["settled_porosity"], summary["wall_time_s"]]
            + [s["compression"] for s in here]))


def table_of(path):
    with open(path) as file:
        return [r for r in csv.DictReader(line for line in file if not line.startswith("#"))]


def line(what, value, low, high, reference):
    good = low <= value <= high
    print(f"{'met' if good else 'NOT MET'}: {what}: {value:.4g} ({low:.4g} to {high:.4g}, {reference})")
    return good


def judge(folder):
    good = True
    for piece in PIECES:
        path = pathlib.Path(folder) / f"{piece}.csv"
        if not path.exists():
            print(f"missing: {piece}")
            good = False
            continue
        rows = table_of(path)
        top = max(rows, key=lambda r: float(r["velocity_cm_h"]))
        print(f"{piece}: settled porosity {float(top['settled_porosity']):.4f}; at {float(top['velocity_cm_h']):.0f} cm/h "
              f"{float(top['pressure_drop_bar_m']):.3g} bar/m (lab {LAB['pressure_drop_bar_m']:g}), compression "
              f"{float(top['compression']):.4f} (lab about {LAB['compression']:g}); sections from the inlet "
              + " ".join(f"{float(top[f'section_{k}']):.3f}" for k in range(1, 8)))
        loaded = [r for r in rows if float(r["velocity_cm_h"]) > 100]
        good &= line(f"{piece}, largest error of the balance of forces", max(abs(float(r["budget_error"])) for r in loaded),
                     0, 5e-3, "issue: below 0.5 %")
        good &= line(f"{piece}, largest noise of the pressure drop", max(float(r["pressure_noise"]) for r in loaded),
                     0, 1e-3, "issue: below 0.1 %")
        good &= line(f"{piece}, compression of the last section over the first", float(top["section_7"]) / float(top["section_1"]),
                     1, 1e3, "lab: rises towards the outlet")
    return good


def main(arguments):
    what = arguments[0] if arguments else ""
    if what == "pieces":
        print("\n".join(PIECES))
    elif what == "files":
        print(PACKBED)
    elif what == "run":
        run_piece(arguments[1])
    elif what == "judge":
        return 0 if judge(arguments[1]) else 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
