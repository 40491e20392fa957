# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill post --machine: programs with rotary axes, read back, and refused input."""
import json
import re
import shutil
import subprocess
import unittest

from program import ROOT, ProgramTest, endmill

DOME = ROOT / "datasets/paths/dome.csv"
MACHINES = ROOT / "datasets/machines"
TOOL = ROOT / "datasets/tools/ball-10-shrink-fit.json"
LINE = "tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z,feed_mm_per_min\n"


class FiveAxisPost(ProgramTest):
    def posted(self, *options, path=DOME):
        return self.summary("post", path, "--tool", TOOL, *options, "--force", "-o", "out")

    def refuse(self, status, *words, content=LINE + "0,0,0,0,0,1,100\n", name="p.csv", options=()):
        path = self.file(content, name)
        done = endmill("post", path, "--cutter", "ball:10", *options, "-o", "no", cwd=self.folder)
        self.assert_refused(done, status, *words)
        self.assertLessEqual(done.stderr.count(str(path)), 1)  # a message names the file once

    def test_dome_is_posted_for_three_kinds_of_machines(self):
        for machine, height in (("ca-table-table", 0), ("ca-table-head", 140), ("ca-head-head", 180)):
            facts = self.posted("--machine", MACHINES / f"{machine}.json", "--clamp", f"0,0,{height}")
            self.assertEqual((facts["rows"], facts["retracts"], facts["frame"]), (473, 0, "joint"), machine)
            self.assertLessEqual(facts["max_tip_error_mm"], 0.005)
            self.assertLess(facts["rounding_tip_mm"], 8.7e-5)
            self.assertEqual(facts["interpolation"], "joint")
            self.assertEqual(facts["machine"]["tool_length_mm"], 110)
            text = (self.folder / "out/dome.ngc").read_text(encoding="ascii")
            self.assertIn("\nG61\n", text)
            self.assertIn("\nG93\n", text)

    def test_part_frame_needs_fewer_pieces(self):
        machine = MACHINES / "ca-table-table.json"
        joint = self.posted("--machine", machine)
        part = self.posted("--machine", machine, "--frame", "part")
        self.assertLess(part["pieces"], joint["pieces"])
        self.assertEqual((part["interpolation"], part["frame"]), ("tcp", "part"))

    def test_program_is_read_back_by_its_summary_and_by_options(self):
        machine = MACHINES / "ca-table-table.json"
        first = self.posted("--machine", machine, "--decimals", "6", "--angle-decimals", "6")
        (self.folder / "one").mkdir()
        shutil.copy(self.folder / "out/dome.ngc", self.folder / "one/dome.ngc")
        options = ("--format", "apt", "--tool", TOOL)
        given = self.summary("post", "one/dome.ngc", "--machine", machine, "--frame", "joint", *options, "-o", "two")
        known = self.summary("post", "out/dome.ngc", "--machine", machine, "--frame", "joint", *options, "-o", "three")
        self.assertEqual((self.folder / "two/dome.apt").read_bytes(), (self.folder / "three/dome.apt").read_bytes())
        self.assertEqual(given["points"], known["points"])
        # a tip that bulges by s on a chord c goes a way that is longer by 8 s^2 / (3 c)
        chord = first["cut_mm"] / first["pieces"]
        bulge = first["pieces"] * 8 * first["max_tip_error_mm"] ** 2 / (3 * chord)
        self.assertAlmostEqual(given["cut_mm"], first["cut_mm"], delta=bulge + 1e-3)
        self.assert_refused(endmill("post", "one/dome.ngc", "--machine", machine, *options, "-o", "four",
                                    cwd=self.folder), 2, "--frame joint or --frame part")

    @unittest.skipUnless(shutil.which("rs274"), "rs274 is not installed")
    def test_interpreter_of_linuxcnc_accepts_the_programs_of_two_kinds_of_machines(self):
        for machine, height in (("ca-table-table", 0), ("ca-head-head", 180)):
            with self.subTest(machine):
                self.interpreted(MACHINES / f"{machine}.json", "--clamp", f"0,0,{height}")

    def interpreted(self, machine, *clamp):
        self.posted("--machine", machine, *clamp)
        tools = self.file("T1 P1 D0.3937 Z0.0 ;ball\n", "tool.tbl")
        done = subprocess.run(["rs274", "-g", "-t", tools, "out/dome.ngc"], cwd=self.folder, capture_output=True,
                              text=True, check=False, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, 0, done.stdout[-300:])
        canonical = self.file(done.stdout, "canonical.txt")
        read = self.summary("post", canonical, "--machine", machine, *clamp, "--frame", "joint", "--tool", TOOL, "--format",
                            "apt", "-o", "canonical", "--force")
        direct = self.summary("post", "out/dome.ngc", "--machine", machine, *clamp, "--frame", "joint", "--tool", TOOL,
                              "--format", "apt", "-o", "direct", "--force")
        self.assertAlmostEqual(read["cut_mm"], direct["cut_mm"], delta=0.01)
        self.assertAlmostEqual(read["time_min"], direct["time_min"], delta=1e-3 * direct["time_min"])

    def test_clamping_and_setup_move_the_part(self):
        pose = {"part_to_machine": [[0, 1, 0], [-1, 0, 0], [0, 0, 1]], "clamp_mm": [1, 2, 3]}
        facts = self.posted("--machine", "W/caxyBz/T", "--setup", self.file(pose, "pose.json"))
        self.assertEqual(facts["machine"]["clamp_mm"], [1, 2, 3])
        self.assertEqual(facts["machine"]["part_to_machine"], pose["part_to_machine"])
        moved = self.posted("--machine", "W/caxyBz/T", "--setup", self.file(pose, "pose.json"), "--clamp", "4,5,6")
        self.assertEqual(moved["machine"]["clamp_mm"], [4, 5, 6])

    def test_refused_input(self):
        tilted = LINE + "0,0,0,0,0,1,100\n1,0,0,0,0.6,0.8,100\n"
        self.refuse(2, "p.csv: the axis at point 1 of the path is 0, 0.6, 0.8", "expected --machine", content=tilted)
        self.refuse(2, "--frame", "--machine", options=("--frame", "joint"))
        self.refuse(2, "--retract", "--machine", options=("--retract", "5"))
        self.refuse(2, "--arcs", content=tilted, options=("--machine", "W/caxyBz/T", "--arcs"))
        self.refuse(4, "the machine W/acxyBz/T cannot direct its tool", content=tilted,
                    options=("--machine", "W/acxyBz/T"))
        self.refuse(4, "point 1 of the path: the axis turns by 180 degrees",
                    content=LINE + "0,0,0,0,0,1,100\n1,0,0,0,0,-1,100\n", options=("--machine", "W/caxyBz/T"))
        limited = {"format": "endmill-machine/1", "configuration": "W/caxyBz/T", "limits": {"a_deg": [-20, 20]}}
        self.refuse(4, "point 1 of the path: axis A at ", "exceeds its limit", "--retract", content=tilted,
                    options=("--machine", self.file(limited, "m.json")))
        short = {"format": "endmill-machine/1", "configuration": "W/caxyBz/T", "limits": {"x_mm": [10, 20]}}
        self.refuse(4, "point 0 of the path: X at 0 mm exceeds its travel 10 by 10 mm", "--clamp ", content=tilted,
                    options=("--machine", self.file(short, "m.json")))
        program = "G21 G90\nG0 X0 Y0 Z5\nG1 A10 F9\nM2\n"
        self.refuse(3, "p.ngc:3: A10; expected A0, or the machine of the program", content=program, name="p.ngc")
        self.refuse(3, "p.ngc:3: A10 on the machine W/cbxyBz/T; expected words of B and C", content=program,
                    name="p.ngc", options=("--machine", "W/cbxyBz/T", "--frame", "joint"))
        self.refuse(2, "--wrapped: found \"x:signed\"", content=program, name="p.ngc",
                    options=("--machine", "W/caxyBz/T", "--frame", "joint", "--wrapped", "x:signed"))

    def test_same_bytes_with_any_number_of_threads(self):
        programs = set()
        for threads in ("1", "2", "3", "8"):
            self.posted("--machine", MACHINES / "cb-table-table.json", "--threads", threads)
            programs.add((self.folder / "out/dome.ngc").read_bytes())
        self.assertEqual(len(programs), 1)

    def test_rates_make_the_program_longer(self):
        machine = json.loads((MACHINES / "ca-table-table.json").read_text())
        free = self.posted("--machine", self.file(machine, "m.json"))
        machine["max_rate"] = {"c_deg_per_min": 600}
        slow = self.posted("--machine", self.file(machine, "m.json"))
        self.assertEqual(free["rate_limited_min"], 0)
        self.assertGreater(slow["rate_limited_min"], 0)
        self.assertGreater(slow["time_min"], free["time_min"])
        fastest = max(abs(float(word)) for word in re.findall(r"F([\d.]+)", (self.folder / "out/dome.ngc").read_text()))
        self.assertGreater(fastest, 0)


if __name__ == "__main__":
    unittest.main()
