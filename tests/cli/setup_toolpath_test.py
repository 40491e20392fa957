# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill setup --path: a setup for a planned path, used by post, and refused input."""
import json
import re
import unittest
from math import cos, radians, sin

from program import ROOT, ProgramTest, endmill

MACHINES = ROOT / "datasets/machines"
TABLE = MACHINES / "ca-table-table.json"  # A from -120 to 30 degrees
HEAD = MACHINES / "cb-head-head.json"  # B from -110 to 110 degrees
PATH = "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z\n"


def tilted(*polar_deg):
    """A path with a tool axis at each of these angles from +z, in the plane of x and z, about the origin."""
    rows = []
    for k, angle in enumerate(polar_deg):
        axis = f"{sin(radians(angle))!r},0,{cos(radians(angle))!r}"
        tip = f"{20 * sin(radians(angle))!r},{k},{20 * cos(radians(angle))!r}"
        rows.append(f"0,{k},cut,{tip},{axis}\n")
    return PATH + "".join(rows)


class SetupForPath(ProgramTest):
    def test_part_that_stands_upside_down_is_turned_and_posted(self):
        path = self.file(tilted(180, 150, 120, 90), "down.csv")
        options = ("--cutter", "ball:10", "--feed", "500", "--spindle-rpm", "6000")
        for name, machine in (("table", TABLE), ("head", HEAD)):
            alone = endmill("post", path, "--machine", machine, "--clamp", "0,0,300", *options, "-o", "no", cwd=self.folder)
            self.assert_refused(alone, 4, "point 0 of the path: axis", "endmill setup --path")
            found = self.summary("setup", "--path", path, "--machine", machine, "-o", name)
            self.assertEqual((found["points"], found["axes"], found["machinable"]), (4, 4, True))
            self.assertGreater(min(found["slack_mm"].values()), 0.1)
            posted = self.summary("post", path, "--machine", machine, "--setup", f"{name}/summary.json", *options,
                                  "-o", f"{name}-post")
            self.assertEqual(posted["retracts"], 0)
            self.assertEqual(posted["machine"]["clamp_mm"], found["clamp_mm"])
            self.assertEqual(posted["machine"]["part_to_machine"], found["part_to_machine"])
            limits = json.loads(machine.read_text(encoding="utf-8"))["limits"]
            text = (self.folder / f"{name}-post/down.ngc").read_text(encoding="ascii")
            for letter in "ABCXYZ":
                low, high = limits.get(f"{letter.lower()}_{'mm' if letter in 'XYZ' else 'deg'}", (0, 0))
                for word in re.findall(rf"\b{letter}(-?[\d.]+)", text):
                    self.assertTrue(low - 1e-4 <= float(word) <= high + 1e-4, (name, letter, word))

    def test_path_that_fits_stays_as_it_stands(self):
        path = self.file(tilted(0, 20, 40), "up.csv")
        found = self.summary("setup", "--path", path, "--machine", TABLE, "-o", "up")
        self.assertEqual(found["part_to_machine"], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        self.assertEqual(found["poses_tried"], 1)
        given = self.summary("setup", "--path", path, "--machine", TABLE, "--clamp", "1,2,3", "-o", "given")
        self.assertEqual(given["clamp_mm"], [1, 2, 3])

    def test_path_out_of_reach_names_the_point(self):
        """A tilt of 0 to 20 degrees on both sides covers 40 degrees, so the axis at 45 degrees is the first too far."""
        machine = self.file(json.dumps({"format": "endmill-machine/1", "configuration": "W/xyBzcb/T", "pivot_mm": 100,
                                        "limits": {"b_deg": [-20, 20]}}), "narrow.json")
        path = self.file(tilted(0, 15, 30, 45, 60), "wide.csv")
        done = endmill("setup", "--path", path, "--machine", machine, "-o", "no", cwd=self.folder)
        self.assert_refused(done, 4, f"{path}: point 3 of the path: no rotation of the part brings its tool axis",
                            "expected wider limits")
        self.assertFalse((self.folder / "no").exists())
        narrow = self.file(tilted(0, 15, 30), "narrow.csv")
        self.summary("setup", "--path", narrow, "--machine", machine, "-o", "yes")
        short = self.file(json.dumps({"format": "endmill-machine/1", "configuration": "W/caxyBz/T",
                                      "limits": {"x_mm": [-1, 1], "y_mm": [-1, 1], "z_mm": [-1, 1]}}), "short.json")
        done = endmill("setup", "--path", narrow, "--machine", short, "-o", "no", cwd=self.folder)
        self.assert_refused(done, 4, " exceeds its travel by ", "rotations of the part were tried")

    def test_refused_command_lines(self):
        path = self.file(tilted(0, 20), "p.csv")
        for arguments, *words in (
                (("--path", path, "--machine", "W/xyBz/T"), "--path: expected one machine with two rotary axes"),
                (("--path", path, "--machine", MACHINES), "--path: expected one machine"),
                (("--path", path, "--family", "CA"), "--family"),
                (("--path", path), "expected --machine"),
                (("--path", path, "--machine", TABLE, "--mode", "set"), "--mode"),
                (("--path", path, "--machine", TABLE, "--max-setups", 2), "--max-setups"),
                ((ROOT / "datasets/meshes/prism.off", "--path", path, "--machine", TABLE),
                 "expected either PART, --points or --path")):
            done = endmill("setup", *arguments, "-o", "no", cwd=self.folder)
            self.assert_refused(done, 2, *words)
        bad = self.file(PATH + "0,0,cut,0,0,0,0,0,2\n", "bad.csv")
        self.assert_refused(endmill("setup", "--path", bad, "--machine", TABLE, "-o", "no", cwd=self.folder), 3, "bad.csv")


if __name__ == "__main__":
    unittest.main()
