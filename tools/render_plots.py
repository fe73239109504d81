#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draw chosen plots of report pages as one picture, as a browser shows them.

Usage: render_plots.py PICTURE.png COLUMNS PAGE.html[:HEADING]::TITLE...    (Debian: chromium, python3-pil)

TITLE is the caption of a plot; HEADING, if given, stands above it. Plots fill rows of COLUMNS.
"""
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image, ImageChops

WIDTH = 560  # of a plot [pixels]
KEEP = """
<style>body{margin:0}main{max-width:none!important;padding:8px!important;margin:0!important}
main>*:not(.chosen),header,footer{display:none!important}.chosen{width:%dpx;margin:0!important}</style>
<script>addEventListener("load",()=>setTimeout(()=>{
const wanted=[...document.querySelectorAll("figure")].find(f=>f.querySelector("figcaption")?.textContent===%s);
if(!wanted){document.title="missing";return}
const main=document.querySelector("main");main.append(wanted);wanted.classList.add("chosen");
const heading=%s;if(heading){const h=document.createElement("h3");h.textContent=heading;h.className="chosen";main.insertBefore(h,wanted)}
},1500))</script></body>"""


def text(words):
    return '"' + words.replace("\\", "\\\\").replace('"', '\\"') + '"'


def chromium(*options):
    call = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
            "--virtual-time-budget=6000", f"--window-size={WIDTH + 40},1400", *options]
    return subprocess.run(call, check=True, capture_output=True, text=True, timeout=120).stdout


def plot(page, heading, title, folder):
    """Picture of one plot, cut to what is drawn."""
    html = page.read_text()
    end = html.rindex("</body>")
    file = folder / "page.html"
    file.write_text(html[:end] + KEEP % (WIDTH, text(title), text(heading)) + html[end + len("</body>"):])
    if "<title>missing" in chromium("--dump-dom", file.as_uri()):
        sys.exit(f'{page}: has no plot "{title}"')
    shot = folder / "shot.png"
    chromium(f"--screenshot={shot}", file.as_uri())
    picture = Image.open(shot).convert("RGB")
    ground = Image.new("RGB", picture.size, picture.getpixel((picture.width - 1, picture.height - 1)))
    _, _, right, bottom = ImageChops.difference(picture, ground).getbbox()
    return picture.crop((0, 0, right + 8, bottom + 8)), ground.getpixel((0, 0))


def main(output, columns, *wanted):
    pictures, ground = [], (255, 255, 255)
    with tempfile.TemporaryDirectory() as folder:
        for entry in wanted:
            where, _, title = entry.partition("::")
            page, _, heading = where.partition(":")
            picture, ground = plot(pathlib.Path(page), heading, title, pathlib.Path(folder))
            pictures.append(picture)
    rows = [pictures[k:k + int(columns)] for k in range(0, len(pictures), int(columns))]
    width = max(p.width for p in pictures)
    whole = Image.new("RGB", (width * min(int(columns), len(pictures)), sum(max(p.height for p in row) for row in rows)), ground)
    top = 0
    for row in rows:
        for k, picture in enumerate(row):
            whole.paste(picture, (k * width, top))
        top += max(p.height for p in row)
    whole.save(output, optimize=True)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
