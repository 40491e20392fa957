# SPDX-License-Identifier: GPL-3.0-or-later
"""Passes along u against passes along v on random surfaces, for several cutters and tolerances.

The first paper recommends to plan both directions and to take the one with fewer points (NCL) and less travel (TCD).
"""
from collections import defaultdict
from statistics import median

from generate_surfaces import surface_text
from generation.random_surfaces import KINDS, random_surfaces

from .intervals import Tally, percent_columns

SETTINGS = [("ball:8", 0.2), ("ball:16", 0.05), ("ball:16", 0.2)]  # cutter, and tolerance in mm
NCL_LIMIT, TCD_LIMIT = 22, 4  # %, least reductions of the printed tables
EQUAL = 1e-9  # relative difference of two travels that is rounding
GOUGED = "1"  # exit code: a path of the paper gouges beyond its tolerance
TOO_LARGE = "4"  # exit code: the surface does not admit the cutter


def prepare(folder, each):
    """Writes `each` surfaces of every kind. Each is a case for every setting."""
    cases = []
    for name, content in random_surfaces(each).items():
        (folder / f"{name}.json").write_text(surface_text(name, content), encoding="utf-8")
        cases += [{"input": f"{folder.name}/{name}.json", "cutter": cutter, "scallop": tolerance,
                   "chord_tolerance": tolerance} for cutter, tolerance in SETTINGS]
    return cases


def surface_of(result):
    return result["input"].rsplit("/", 1)[-1].removesuffix(".json")


def setting_of(result):
    return f"{result['cutter']} at {float(result['scallop']):g} mm"


def smaller(result, column):
    """The direction with the smaller value, u or v; empty if they are equal."""
    u, v = (float(result[f"{direction}.{column}"]) for direction in "uv")
    if abs(u - v) <= EQUAL * max(u, v):
        return ""
    return "u" if u < v else "v"


def reduction(result, column):
    """The reduction in percent from the larger to the smaller value."""
    values = [float(result[f"{direction}.{column}"]) for direction in "uv"]
    return 100 * (1 - min(values) / max(values))


def agree(one, other):
    """Whether two criteria do not choose different directions."""
    return not one or not other or one == other


PROPERTIES = {
    "ncl_and_tcd_agree": lambda r: agree(smaller(r, "ncl"), smaller(r, "tcd_mm")),
    "contacts_and_tips_agree": lambda r: agree(smaller(r, "tcd_mm"), smaller(r, "tcd_cl_mm")),
    "ncl_saves_22": lambda r: reduction(r, "ncl") >= NCL_LIMIT,
    "tcd_saves_4": lambda r: reduction(r, "tcd_mm") >= TCD_LIMIT,
    "both_save": lambda r: reduction(r, "ncl") >= NCL_LIMIT and reduction(r, "tcd_mm") >= TCD_LIMIT
    and agree(smaller(r, "ncl"), smaller(r, "tcd_mm")),
    "a_path_gouges": lambda r: r["exit_code"] == GOUGED,
}


def row(label, results, surfaces):
    """The row of a group of cases. `surfaces` maps a surface to all its cases that fit."""
    fitting = [r for r in results if r["exit_code"] != TOO_LARGE]
    cells = [label, len(results), len(fitting)]
    for holds in PROPERTIES.values():
        cells += Tally(sum(map(holds, fitting)), len(fitting)).percents()
    for column in ("ncl", "tcd_mm"):
        cells.append(f"{median(reduction(r, column) for r in fitting):.3f}" if fitting else "")
    same = [len({smaller(r, "tcd_mm") for r in cases} - {""}) <= 1 for cases in surfaces.values() if len(cases) > 1]
    return cells + [len(same)] + Tally(sum(same), len(same)).percents()


HEADER = ["row", "cases", "cutter_fits", *(text for name in PROPERTIES for text in percent_columns(name)),
          "ncl_median_reduction_percent", "tcd_median_reduction_percent",
          "surfaces", *percent_columns("one_direction")]


def grouped(results):
    """(label, cases) of each row: all, by kind of surface, by setting."""
    yield "all", results
    for kind in KINDS:
        yield kind, [r for r in results if surface_of(r).rsplit("-", 1)[0] == kind]
    for setting in dict.fromkeys(map(setting_of, results)):
        yield setting, [r for r in results if setting_of(r) == setting]


def check(results):
    """Raises SystemExit if a case failed for another reason than its cutter."""
    for result in results:
        if result["exit_code"] not in ("0", GOUGED, TOO_LARGE):
            raise SystemExit(f"{result['input']}: exit code {result['exit_code']}, {result['message']}")


def evaluate(results):
    """The tables of the study."""
    check(results)
    rows = []
    for label, cases in grouped(results):
        surfaces = defaultdict(list)
        for case in cases:
            if case["exit_code"] != TOO_LARGE:
                surfaces[surface_of(case)].append(case)
        rows.append(row(label, cases, surfaces))
    return {"result.csv": (HEADER, rows), "reductions.csv": reductions(results)}


def reductions(results):
    """The reductions of every case, for the figure."""
    rows = [[surface_of(r), surface_of(r).rsplit("-", 1)[0], r["cutter"], r["scallop"],
             f"{reduction(r, 'ncl'):.4f}", f"{reduction(r, 'tcd_mm'):.4f}"]
            for r in results if r["exit_code"] != TOO_LARGE]
    return ["surface", "kind", "cutter", "tolerance_mm", "ncl_reduction_percent", "tcd_reduction_percent"], rows
