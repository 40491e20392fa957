# SPDX-License-Identifier: GPL-3.0-or-later
"""The share of random curves that each trimming method gets wrong, by points on a curve and by depth of interference."""
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor

from generation.random_curves import FAMILIES, POINTS, Block, curves, polyline_text

from .intervals import Tally, percent_columns

CURVES = 1000  # of a case
METHODS = ("1", "2", "3", "3r", "envelope")
DETECTIONS = ("literal", "guarded")
DEPTHS = {"none": "no interference", "below_10_um": "below 0.01 mm", "below_100_um": "0.01 to 0.1 mm",
          "below_1_mm": "0.1 to 1 mm", "from_1_mm": "1 mm and more"}
RULES = "comparison.by_depth"  # of summary.json
TIMES = "comparison.measured"


def write_block(path, block):
    path.write_text(polyline_text(curves(block, CURVES)), encoding="utf-8")


def prepare(folder, blocks):
    """Writes so many blocks of each family and number of points. A block is a case for each detection of folds."""
    wanted = [Block(family, points, number) for family in FAMILIES for points in POINTS for number in range(blocks)]
    files = [folder / f"{block.name}.csv" for block in wanted]
    with ProcessPoolExecutor() as pool:
        list(pool.map(write_block, files, wanted))
    return [{"polyline": f"{folder.name}/{file.name}", "detection": detection}
            for file, block in zip(files, wanted) for detection in DETECTIONS]


def groups_of(result):
    """Yields (row, depth) for each row of the table in which a depth of a case counts."""
    family, points, _ = result["polyline"].rsplit("/", 1)[-1].split("-")
    name = f"{family}, {result['detection']}"
    for depth, words in DEPTHS.items():
        yield f"{name}, all", depth
        yield f"{name}, {points} points", depth
        yield f"{name}, {words}", depth


def add_case(result, tallies, times):
    """Adds the counts and times of one case."""
    for row, depth in groups_of(result):
        planes = int(result[f"{RULES}.{depth}.planes"])
        for method in METHODS:
            tallies[row][method].add(int(result[f"{RULES}.{depth}.wrong.{method}"]), planes)
            if depth == "none":
                times[row][method].append(float(result[f"{TIMES}.{method}.median_ms"]))


def order(row):
    """Families and detections in their order; then all curves, by points, by depth."""
    family, detection, group = row.split(", ")
    places = ["all", *(f"{points} points" for points in POINTS), *DEPTHS.values()]
    return list(FAMILIES).index(family), DETECTIONS.index(detection), places.index(group)


def table(tallies, times):
    """The rows of result.csv. A time is the mean of the cases, in ms for CURVES curves; rows by depth have none."""
    header = ["row", "curves"]
    for method in METHODS:
        header += percent_columns(f"wrong_{method}")
    header += [f"time_{method}_ms" for method in METHODS]
    rows = []
    for row in sorted(tallies, key=order):
        cells = [row, tallies[row][METHODS[0]].count]
        for method in METHODS:
            cells += tallies[row][method].percents()
        is_by_depth = row.endswith(tuple(DEPTHS.values()))
        cells += ["" if is_by_depth else f"{sum(times[row][m]) / len(times[row][m]):.3f}" for m in METHODS]
        rows.append(cells)
    return header, rows


def long_table(tallies):
    """The shares by family, detection, group and method, for the figures."""
    rows = []
    for row in sorted(tallies, key=order):
        family, detection, group = row.split(", ")
        points = group.removesuffix(" points") if group.endswith(" points") else ""
        kind = "points" if points else ("all" if group == "all" else "depth")
        for method in METHODS:
            rows.append([family, detection, kind, points or group, f"method {method}",
                         *tallies[row][method].percents()])
    return ["family", "detection", "by", "group", "method", *percent_columns("wrong")], rows


def evaluate(results):
    """The tables of the study."""
    tallies, times = defaultdict(lambda: defaultdict(Tally)), defaultdict(lambda: defaultdict(list))
    for result in results:
        if result["exit_code"] != "0":
            raise SystemExit(f"{result['polyline']}: exit code {result['exit_code']}, {result['message']}")
        add_case(result, tallies, times)
    return {"result.csv": table(tallies, times), "shares.csv": long_table(tallies)}
