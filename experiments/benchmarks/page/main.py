# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of the page of endmill view. Columns: README.md beside this.

  /usr/bin/python3 experiments/benchmarks/page/main.py OUTPUT_FOLDER
"""
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
PARAMETERS = json.loads((HERE / "params.json").read_text(encoding="utf-8"))["parameters"]
PROGRAM = Path("build/release/src/cli/endmill").resolve()
MODULES = Path("build/release/tests/page_modules/node_modules").resolve()
NET = Path("datasets/surfaces/net_rot24_7D.json").resolve()
MB = 1e6


def run(*words, codes=(0,)):
    """Runs the program; returns its wall time in s."""
    start = time.perf_counter()
    done = subprocess.run([str(PROGRAM), *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode not in codes:
        raise RuntimeError(done.stderr)
    return time.perf_counter() - start


def wavy_path(file, points):
    """Lines of 1000 points over a wavy part."""
    with open(file, "w", encoding="utf-8") as out:
        out.write("pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm\n")
        for k in range(points):
            line, place = divmod(k, 1000)
            x = 0.1 * (place if line % 2 == 0 else 999 - place)
            out.write(f"{line},{place},cut,{x:.4f},{0.1 * line:.4f},{5 * math.sin(x / 3 + line / 50):.6f}\n")


def drawn(page):
    """What a browser measures of a page; nothing without one."""
    node, chromium = shutil.which("node"), shutil.which("chromium")
    if not node or not chromium or not MODULES.is_dir():
        return {}
    done = subprocess.run([node, str(HERE / "frames.mjs"), str(page), str(PARAMETERS["seconds_of_turning"])],
                          env={**os.environ, "NODE_PATH": str(MODULES), "CHROMIUM": chromium},
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def rows_in(folder):
    run("plan", NET, "--cutter", "ball:15", "--scallop", "0.5", "--strategy", "iso-u", "-o", folder / "net", codes=(0, 1))
    yield "page of the path on the default net", run("view", folder / "net", "-o", folder / "net.html"), "s", 1
    for points in PARAMETERS["points"]:
        file, page = folder / f"{points}.csv", folder / f"{points}.html"
        wavy_path(file, points)
        name = f"{points} points"
        yield f"page of {name}", run("view", file, "-o", page), "s", 5
        yield f"size of {name}", page.stat().st_size / MB, "MB", 25
        found = drawn(page)
        yield f"first frame of {name}", found.get("first_frame_s", ""), "s", 2
        yield f"turning {name}, at least 15", found.get("frames_per_s", ""), "frames/s", ""


def main(output):
    with tempfile.TemporaryDirectory() as folder:
        lines = [f'"{row}",{measured},{unit},{bar}' for row, measured, unit, bar in rows_in(Path(folder))]
    output.mkdir(parents=True, exist_ok=True)
    (output / "result.csv").write_text("\n".join(["row,measured,unit,bar_at_most", *lines]) + "\n", encoding="utf-8")


main(Path(sys.argv[1]))
