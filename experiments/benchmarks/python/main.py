# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost of the Python package. Columns: README.md beside this.

  /usr/bin/python3 experiments/benchmarks/python/main.py OUTPUT_FOLDER
"""
import json
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

PACKAGE = Path("build/release/src/python").resolve()
PARAMETERS = json.loads(Path(__file__).with_name("params.json").read_text(encoding="utf-8"))["parameters"]

sys.path.insert(0, str(PACKAGE))
import endmill  # noqa: E402  from the build
import numpy as np  # noqa: E402

MB = 1e6


def output_of(script):
    """What a Python process prints."""
    environment = {**os.environ, "PYTHONPATH": str(PACKAGE)}
    done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True)
    return float(done.stdout)


def import_ms():
    script = ("import time, numpy\nstart = time.perf_counter()\nimport endmill\n"
              "print(1000 * (time.perf_counter() - start))")
    return statistics.median(output_of(script) for _ in range(PARAMETERS["processes"]))


def least_us(call, calls):
    """The least time of a call, in microseconds, over ten series of calls."""
    least = float("inf")
    for _ in range(10):
        start = time.perf_counter()
        for _ in range(calls // 10):
            call()
        least = min(least, 1e6 * (time.perf_counter() - start) / (calls // 10))
    return least


def call_us(call):
    """The time of a call beyond that of its elements. call(n) takes n elements."""
    many = 1000  # few enough for one thread
    one, all_of_them = call(1), call(many)
    return least_us(one, PARAMETERS["calls"]) - least_us(all_of_them, PARAMETERS["calls"] // 20) / many


def calls():
    """Names and calls: functions of the number of elements that return the call."""
    rng = np.random.default_rng(1)
    y, x = np.mgrid[0:4, 0:4] * 10.0
    surface = endmill.Surface.bezier(np.stack([x, y, np.sin(x + y)], axis=-1))
    plate = endmill.Mesh([[-50, -50, 0], [50, -50, 0], [50, 50, 0], [-50, 50, 0]], [[0, 1, 2], [0, 2, 3]])
    drop = endmill.DropCutter(plate, "ball:6")
    machine = endmill.Machine("W/caxyBz/T")

    def points(n):
        u, v = rng.random((2, n))
        return lambda: surface.point(u, v)

    def heights(n):
        places = rng.uniform(-40, 40, (n, 2))
        return lambda: drop.heights(places)

    def poses(n):
        positions = rng.uniform(-40, 40, (n, 5))
        return lambda: machine.poses(positions)

    return {"Surface.point": points, "DropCutter.heights": heights, "Machine.poses": poses}


def memory_mb():
    script = f"""
import resource, numpy as np, endmill
y, x = np.mgrid[0:4, 0:4]
surface = endmill.Surface.bezier(np.stack([x, y, x * y], axis=-1))
u = np.random.default_rng(1).random({PARAMETERS["numbers"]})
v = u[::-1].copy()
peak = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
before = peak()
points = surface.point(u, v)
print((peak() - before - points.nbytes) / {MB})"""
    return output_of(script)


def main(output):
    rows = [("import beyond NumPy", import_ms(), "ms", 50)]
    rows += [(f"call of {name}", call_us(call), "us", 10) for name, call in calls().items()]
    rows.append(("memory beyond the result, 10^7 parameters u and v", memory_mb(), "MB", 20))
    lines = ["row,measured,unit,bar_at_most", *(f'"{row}",{measured},{unit},{bar}' for row, measured, unit, bar in rows)]
    output.mkdir(parents=True, exist_ok=True)
    (output / "result.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


main(Path(sys.argv[1]))
