# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the numbers in datasets/surfaces/README.md with the files that they describe."""
import csv
import math
import re
import unittest

from program import ROOT, SURFACES, ProgramTest

README = (SURFACES / "README.md").read_text(encoding="utf-8")
TABLES = ROOT / "experiments/economic-cl-data"


def described(heading):
    """The table under a heading, as the cells beside the name of each file."""
    section = README.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    lines = re.findall(r"^\| `(\S+\.json)`[^|]*\|(.*)\|$", section, re.MULTILINE)
    return {name: [cell.strip() for cell in cells.split("|")] for name, cells in lines}


def number(text):
    """Parses a number such as "59 675"; the minus sign may be typographic."""
    return float(text.replace(" ", "").replace("−", "-"))


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def deviations(net):
    """Relative differences, in %, of the 36 cells of a net from the printed tables."""
    printed = {}
    for table in ("table-1", "table-2"):
        for row in rows(TABLES / table / "published.csv"):
            if row["row"] != "inputs":
                printed[row["row"], row["column"]] = float(row["published"])
    for cell in rows(SURFACES / "fitted-nets-cells.csv"):
        if cell["net"] != net:
            continue
        row = f"net_rot24_7D d={cell['chord_tolerance_mm']} {cell['direction']}"
        for key, column in (("ncl", "ncl_d{}"), ("tcd_mm", "tcd_d{}_mm")):
            expected = printed[row, column.format(cell["cutter_diameter_mm"])]
            yield 100 * (float(cell[key]) / expected - 1)


class SurfacesReadme(ProgramTest):
    def assert_rounds_to(self, value, text, message):
        """Asserts that `value` rounds to `text`, in the digits that `text` shows."""
        digits = len(text.partition(".")[2])
        self.assertLessEqual(abs(value - number(text)), 0.5 * 10**-digits * (1 + 1e-9), message)

    def test_every_surface_is_described(self):
        names = {*described("Fitted nets"), *described("Surfaces with a closed form"),
                 *described("Height grids"), "teapot.json"}
        self.assertEqual(names, {path.name for path in SURFACES.glob("*.json")})

    def test_areas_and_largest_balls_of_the_fitted_nets(self):
        for name, (_, _, area, radius) in described("Fitted nets").items():
            facts = self.summary("info", SURFACES / name)
            self.assertEqual((facts["patches_u"], facts["patches_v"]), (3, 2))
            self.assert_rounds_to(facts["area_mm2"], area, name)
            self.assert_rounds_to(facts["max_cutter_radius_mm"], radius, name)
            for size, low, high in zip(facts["size_mm"], (200, 120, 220), (200, 120, 220.1)):
                self.assertTrue(low - 1e-6 <= size <= high + 1e-6, (name, size))

    def test_differences_of_the_fitted_nets_from_the_printed_tables(self):
        for name, (rms, worst, _, _) in described("Fitted nets").items():
            cells = list(deviations(name.removesuffix(".json")))
            self.assertEqual(len(cells), 36)
            self.assert_rounds_to(math.hypot(*cells) / 6, rms, name)
            self.assert_rounds_to(max(map(abs, cells)), worst, name)

    def test_facts_of_surfaces_with_a_closed_form(self):
        told = 0
        for name, (surface, known) in described("Surfaces with a closed form").items():
            facts = self.summary("info", SURFACES / name)
            patches = re.search(r"(\d+) x (\d+) patches", surface)
            self.assertEqual((facts["patches_u"], facts["patches_v"]), tuple(map(int, patches.groups())))
            size = re.search(r"over (\d+) x (\d+) mm", surface)
            for value, expected in zip(facts["size_mm"], size.groups() if size else ()):
                self.assertAlmostEqual(value, int(expected), delta=1e-9)
            for pattern, key in ((r"area ([\d .]+) mm²", "area_mm2"),
                                 (r"largest ball radius ([\d.]+) mm", "max_cutter_radius_mm")):
                for expected in re.findall(pattern, known):
                    self.assertAlmostEqual(facts[key], number(expected), delta=1e-6)
                    told += 1
            if "no limit to the cutter" in known:
                self.assertIsNone(facts["max_cutter_radius_mm"])
                told += 1
            for length in re.findall(r"a pass along u is (\d+) mm", known):
                plan = self.summary("plan", SURFACES / name, "--mode", "paper", "--cutter", "ball:10",
                                    "--direction", "u", "--count-links", "no", "-o", name)
                self.assertAlmostEqual(plan["tcd_mm"] / plan["passes"], number(length), delta=1e-9)
                told += 1
        self.assertEqual(told, 13)

    def test_surfaces_described_as_facing_up_face_up(self):
        for name, (_, known) in described("Surfaces with a closed form").items():
            if "N·z ≥" in known:
                self.assertIsNone(self.summary("info", SURFACES / name)["unreachable_at"], name)

    def test_facts_of_the_teapot(self):
        text = README.split("\n## The Utah teapot\n")[1]
        facts = self.summary("info", SURFACES / "teapot.json")
        self.assertEqual(facts["patches"], 32)
        for stated, size in zip(re.search(r"of ([\d.]+) x ([\d.]+) x\s+([\d.]+) mm", text).groups(),
                                facts["size_mm"]):
            self.assert_rounds_to(size, stated, "teapot")


if __name__ == "__main__":
    unittest.main()
