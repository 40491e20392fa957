# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether random parts can be machined in one setup, on every type of machine."""
from collections import defaultdict
from statistics import median

from generation import mesh_texts
from generation.random_parts import KINDS, random_parts

from .intervals import Tally, percent_columns

# Types of machines with the limits of their rotary axes in degrees, as in datasets/machines. There C, and the B of
# W/baxzBy/T, turn without end.
MACHINES = {
    "W/xyBz/T": "",
    "W/axyBz/T": "a=-120:120",
    "W/bxyBz/T": "b=-120:120",
    "W/caxyBz/T": "a=-120:30",
    "W/cbxyBz/T": "b=-110:30",
    "W/abxyBz/T": "a=-30:30,b=-120:120",
    "W/baxzBy/T": "a=-45:100",
    "W/cxyBza/T": "a=-100:100",
    "W/cxyBzb/T": "b=-30:110",
    "W/axyBzb/T": "a=-90:90,b=-45:45",
    "W/bxyBza/T": "a=-45:45,b=-90:90",
    "W/xyBzca/T": "a=-110:110",
    "W/xyBzcb/T": "b=-110:110",
    "W/xyBzab/T": "a=-40:40,b=-30:30",
    "W/xyBzba/T": "a=-30:30,b=-40:40",
}
YES, NO = "0", "1"  # exit codes


def prepare(folder, each):
    """Writes `each` parts of every kind with their bottoms. Each is a case for every machine."""
    cases = []
    for part in random_parts(each):
        vertices, triangles = part.solid()
        part_file, bottom = folder / f"{part.name}.off", folder / f"{part.name}-bottom.txt"
        part_file.write_bytes(mesh_texts.off("", vertices, triangles))
        bottom.write_bytes(mesh_texts.bottom_facets("", vertices, triangles))
        cases += [{"input": f"{folder.name}/{part_file.name}", "skip_facets": f"{folder.name}/{bottom.name}",
                   "machine": machine, "limits": limits} for machine, limits in MACHINES.items()]
    return cases


def kind_of(result):
    return result["input"].rsplit("/", 1)[-1].rsplit("-", 1)[0]


def check(results):
    """Raises SystemExit if a case failed."""
    for result in results:
        if result["exit_code"] not in (YES, NO):
            raise SystemExit(f"{result['input']}: exit code {result['exit_code']}, {result['message']}")


def number(text):
    return float(text) if text else None


def cells_of(results):
    """The cells of a group of cases: parts, machinable and undecided ones, and medians of what was found.

    Mode `paper` examines one cell for each cone. If the setup that it finds exceeds the limits, another one may not.
    """
    by_kind = defaultdict(Tally)
    for result in results:
        by_kind[kind_of(result)].add(result["exit_code"] == YES, 1)
    whole = Tally(sum(tally.found for tally in by_kind.values()), len(results))
    areas = [number(r["floored_area_deg2"]) for r in results if r["exit_code"] == YES]
    areas = [area for area in areas if area is not None]
    missed = [100 * share for r in results if (share := number(r["missed_area_share"])) is not None]
    undecided = sum(r["exit_code"] == NO and r["proved"] == "false" for r in results)
    return [len(results), *whole.percents(), undecided, *(by_kind[kind].found for kind in KINDS),
            f"{median(areas):.2f}" if areas else "", f"{median(missed):.4f}" if missed else ""]


HEADER = ["row", "parts", *percent_columns("machinable"), "undecided", *(f"machinable_{kind}" for kind in KINDS),
          "median_floored_area_deg2", "median_missed_area_percent"]


def any_machine(results):
    """The best case of each part: machinable if one machine can."""
    best = {}
    for result in results:
        if result["input"] not in best or result["exit_code"] < best[result["input"]]["exit_code"]:
            best[result["input"]] = result
    return list(best.values())


def evaluate(results):
    """The table of the study, and the counts by machine and kind for the figure."""
    check(results)
    by_machine = {machine: [r for r in results if r["machine"] == machine] for machine in MACHINES}
    rows = [[machine, *cells_of(cases)] for machine, cases in by_machine.items()]
    rows.append(["any machine", *cells_of(any_machine(results))[:-2], "", ""])
    long = [[machine, kind, sum(r["exit_code"] == YES for r in cases if kind_of(r) == kind)]
            for machine, cases in by_machine.items() for kind in KINDS]
    return {"result.csv": (HEADER, rows), "kinds.csv": (["machine", "kind", "machinable"], long)}
