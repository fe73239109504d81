#!/usr/bin/env python3
"""Fail where a file of src/ includes a folder that the table does not allow.

Usage: check_includes.py SRC
"""
import re
import sys
from pathlib import Path

ALLOWED = {
    "core": "",
    "resin": "core",
    "mesh": "core",
    "dem": "core mesh",
    "fluid": "core mesh",
    "coupling": "core mesh dem",
    "continuum": "core resin",
    "column": "core resin mesh dem fluid coupling analysis",
    "analysis": "core mesh dem",
    "io": "core mesh dem",
    "setup": "core resin mesh dem fluid coupling continuum column analysis io",
    "study": "core resin continuum setup column analysis io",
    "report": "core continuum setup",
    "app": "core resin mesh dem fluid coupling continuum column analysis io setup study report",
}

src = Path(sys.argv[1])
violations = 0
for path in sorted(src.rglob("*.[hc]pp")):
    folder = path.relative_to(src).parts[0]
    if folder not in ALLOWED:
        sys.exit(f"{path}: folder {folder}/ is not in the table of {Path(__file__).name}")
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        included = re.match(r'\s*#\s*include\s*"([a-z_]+)/', line)
        if included and included[1] not in {folder, *ALLOWED[folder].split()}:
            print(f"{path}:{number}: {folder}/ may not include {included[1]}/")
            violations += 1
sys.exit(violations > 0)
