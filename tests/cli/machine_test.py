# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill machine: words, feasible directions and positions of docs/methods/five-axis-setup.md,
section 9, and refused input."""
import json
import math
import unittest

from program import ROOT, ProgramTest, endmill

MACHINES = ROOT / "datasets/machines"

# Pairs of rotary axes: rank, solid angle in sr for limits of 30 degrees either way, family.
PAIRS = {"ab": (2, 4 * math.pi / 6 * 0.5, "AB"), "ba": (2, 4 * math.pi / 6 * 0.5, "AB"),
         "ca": (2, 2 * math.pi / 3 * (1 - math.cos(math.pi / 6)), "CA"),
         "cb": (2, 2 * math.pi / 3 * (1 - math.cos(math.pi / 6)), "CA"),
         "ac": (1, 0, None), "bc": (1, 0, None)}


class Machine(ProgramTest):
    def answer(self, *arguments, status=0):
        done = endmill("machine", *arguments, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout)

    def refused(self, *arguments, status=2, words=()):
        self.assert_refused(endmill("machine", *arguments, cwd=self.folder), status, *words)

    def assert_vector(self, found, expected, delta=1e-7):
        self.assertEqual(len(found), len(expected))
        for value, other in zip(found, expected):
            self.assertAlmostEqual(value, other, delta=delta)

    def machine_file(self, **keys):
        return self.file({"format": "endmill-machine/1", **keys}, "m.json")

    def test_eighteen_words_have_their_rank_family_and_solid_angle(self):
        for pair, (rank, area, family) in PAIRS.items():
            for place in range(3):
                word = f"W/{pair[:place]}B{pair[place:]}xyz/T"
                limits = f"{pair[0]}=-30:30,{pair[1]}=-30:30"
                found = self.answer(word, "--limits", limits, status=0 if rank == 2 else 1)
                self.assertEqual((found["valid"], found["axes"], found["rank"]), (rank == 2, 5, rank))
                self.assertEqual((found["family"], found["r1"], found["r2"]), (family, *pair.upper()))
                self.assertEqual(found["sides"], ["part"] * place + ["tool"] * (2 - place))
                self.assertAlmostEqual(found["solid_angle_sr"], area, delta=1e-14)
                self.assertEqual(found["reason"] is None, rank == 2)
                if rank == 1:
                    self.assertIn("turns it about itself", found["reason"])

    def test_four_machines_of_the_paper_have_their_family(self):
        for word, family, r1 in (("W/xyBzca/T", "CA", "C"), ("W/cxyBza/T", "CA", "C"), ("W/caxyBz/T", "CA", "C"),
                                 ("W/baxzBy/T", "AB", "B")):
            found = self.answer(word)
            self.assertEqual((found["family"], found["r1"], found["r2"]), (family, r1, "A"))
            self.assertAlmostEqual(found["solid_angle_sr"], 4 * math.pi, delta=1e-13)
        for word in ("W/acxyBz/T", "W/xyzBbc/T"):
            self.assertFalse(self.answer(word, status=1)["valid"])

    def test_limits_of_tables_are_mirrored_limits_of_heads(self):
        head = self.answer("W/Bbaxyz/T", "--limits", "b=-40:65,a=-20:35", "--contains", "322.391,69.6406",
                           "--contains", "0,65.1")
        self.assertAlmostEqual(head["solid_angle_sr"], 1.6779183682, delta=1e-10)
        self.assertEqual(head["contains"], [True, False])
        table = self.answer("W/baBxyz/T", "--limits", "b=-40:65,a=-20:35", "--contains", "142.391,69.6406",
                            "--contains", "0,64.9")
        self.assertEqual(table["contains"], [True, False])
        self.assertAlmostEqual(table["solid_angle_sr"], head["solid_angle_sr"], delta=1e-14)
        self.assertEqual((head["phi_range_deg"], head["theta_range_deg"]), ([-40, 65], [-20, 35]))
        self.assertEqual((table["phi_range_deg"], table["theta_range_deg"]), ([-65, 40], [-35, 20]))
        mirrored = self.answer("W/abBxyz/T", "--limits", "a=-20:50,b=-15:30")
        same = self.answer("W/abBxyz/T", "--limits", "phi=-50:20,theta=-30:15")
        self.assertEqual(mirrored, same)
        self.assertAlmostEqual(same["solid_angle_sr"], 0.9270723535, delta=1e-10)

    def test_directions_of_two_sectors_are_contained(self):
        inside = [(azimuth, 60) for azimuth in range(-30, 61, 15)] + [(azimuth, 30) for azimuth in range(150, 241, 15)]
        outside = [(61, 10), (200, 31)]
        directions = [word for az, pol in inside + outside for word in ("--contains", f"{az},{pol}")]
        found = self.answer("W/Bcbxyz/T", "--limits", "phi=-30:60,theta=-30:60", *directions)
        self.assertEqual(found["contains"], [True] * len(inside) + [False] * len(outside))
        self.assertAlmostEqual(found["solid_angle_sr"], 0.9958449670, delta=1e-10)

    def test_machines_with_fewer_axes_are_reported(self):
        three = self.answer("W/xyBz/T", "--contains", "0,0", "--contains", "0,1")
        self.assertEqual([three[key] for key in ("valid", "axes", "family", "r1", "r2", "sides", "rank", "reason")],
                         [True, 3, None, None, None, [], 0, None])
        self.assertEqual((three["solid_angle_sr"], three["contains"]), (0, [True, False]))
        four = self.answer("W/axyBz/T", "--limits", "a=-20:90", "--contains", "90,89", "--contains", "270,19",
                           "--contains", "270,21", "--contains", "0,10")
        self.assertEqual([four[key] for key in ("valid", "axes", "family", "r1", "r2", "sides", "rank")],
                         [True, 4, "A", "A", None, ["part"], 1])
        self.assertEqual((four["phi_range_deg"], four["theta_range_deg"]), ([-90, 20], [0, 0]))
        self.assertEqual(four["contains"], [True, True, False, False])
        spin = self.answer("W/cxyBz/T", status=1)
        self.assertEqual((spin["valid"], spin["axes"], spin["rank"]), (False, 4, 0))

    def test_positions_are_those_of_the_test_vectors(self):
        point = ("--point", "50,20,30", "--length", 200)
        direction = [0.2716538, -0.3237444, 0.9063078]
        for word, at, xyz in (("W/cBaxyz/T", "c=-40,a=25", [51.1579743, -101.3421440, 11.2615574]),
                              ("W/Bcaxyz/T", "a=25,c=40", [104.3307565, -44.7488742, 11.2615574])):
            found = self.answer(word, "--at", at, *point)
            self.assert_vector(found["direction"], direction)
            self.assert_vector(found["xyz_mm"], xyz)
        path = self.machine_file(configuration="W/baBxyz/T", table_offset_mm=[0, 0, -50])
        found = self.answer(path, "--at", "b=30,a=-20", *point)
        self.assert_vector(found["direction"], [-0.4698463, -0.3420201, 0.8137977])
        self.assert_vector(found["xyz_mm"], [83.3012702, 33.9391995, -15.2289039])

    def test_both_solutions_give_the_direction(self):
        azimuth, polar = 200, 40
        expected = [math.sin(math.radians(polar)) * math.cos(math.radians(azimuth)),
                    math.sin(math.radians(polar)) * math.sin(math.radians(azimuth)), math.cos(math.radians(polar))]
        for name in sorted(MACHINES.glob("*-*-*.json")):
            if name.name.startswith("milling"):
                continue
            solutions = self.answer(name, "--inverse", f"{azimuth},{polar}", "--point", "1,2,3")["inverse"]
            self.assertEqual(len(solutions), 2)
            for solution in solutions:
                at = ",".join(f"{letter}={solution[letter + '_deg']}" for letter in "abc" if letter + "_deg" in solution)
                found = self.answer(name, "--at", at, "--point", "1,2,3")
                self.assert_vector(found["direction"], expected, 1e-14)
                self.assert_vector(found["xyz_mm"], solution["xyz_mm"], 1e-10)
                self.assertEqual(found["within_limits"], solution["within_limits"], name)
        self.assertEqual(self.answer("W/xyBz/T", "--inverse", "0,10")["inverse"], [])

    def test_travel_limits_are_checked(self):
        name = MACHINES / "ca-table-table.json"
        self.assertTrue(self.answer(name, "--at", "a=30", "--point", "0,0,0")["within_limits"])
        self.assertFalse(self.answer(name, "--at", "a=31")["within_limits"])
        self.assertFalse(self.answer(name, "--at", "a=0", "--point", "251,0,0")["within_limits"])
        wider = self.answer(name, "--at", "a=31", "--limits", "a=-120:40")
        self.assertEqual((wider["within_limits"], wider["phi_range_deg"]), (True, [-40, 120]))

    def test_answer_is_printed_and_written(self):
        done = endmill("machine", "W/caxyBz/T", "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("W/caxyBz/T is a valid 5-axis machine: C (R1) and A (R2) turn the part.\n", done.stdout)
        self.assertIn("phi from -180 to 180 degrees, theta from -180 to 180 degrees: 100 % of all directions.\n",
                      done.stdout)
        self.assertNotRegex(done.stdout, r"null|[\[\]{}\"=]|true|offset")
        summary = json.loads((self.folder / "out/summary.json").read_text())
        self.assertEqual(summary, self.answer("W/caxyBz/T"))
        done = endmill("machine", "W/acxyBz/T", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("W/acxyBz/T is not valid: c, the rotary axis next to the tool", done.stdout)

    def test_text_states_directions_and_positions(self):
        """A table turned by c = -90, a = 30 has the tool lean by 30 degrees to -x of the part (right-hand rule)."""
        done = endmill("machine", "W/caxyBz/T", "--limits", "a=-120:30", "--contains", "45,100", "--contains", "0,170",
                       "--at", "c=-90,a=30", "--inverse", "180,90", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for sentence in ("Axis positions: c from -180 to 180 degrees, a from -120 to 30 degrees.\n",
                         "The tool reaches azimuth 45, polar angle 100 degrees.\n",
                         "The tool does not reach azimuth 0, polar angle 170 degrees.\n",
                         "At c=-90,a=30 the tool points along (-0.5, 0, 0.866), within the limits.\n",
                         "Positions for azimuth 180, polar angle 90 degrees: "):
            self.assertIn(sentence, done.stdout)
        done = endmill("machine", "W/xyBz/T", "--inverse", "0,10", cwd=self.folder)
        self.assertEqual(done.stdout, "W/xyBz/T is a valid 3-axis machine: its tool always points along +z.\n"
                                      "No position gives azimuth 0, polar angle 10 degrees.\n")

    def test_limits_beyond_a_rotation_reach_every_direction(self):
        """C of a table within 720 degrees either way reaches what C without limits reaches, and turns no further."""
        limits = {"a_deg": [-120, 30], "c_deg": [-720, 720]}
        path = self.machine_file(configuration="W/caxyBz/T", limits=limits)
        found = self.answer(path)
        free = self.answer("W/caxyBz/T", "--limits", "a=-120:30")
        self.assertEqual(found["solid_angle_sr"], free["solid_angle_sr"])
        self.assertEqual((found["theta_range_deg"], found["phi_range_deg"]), ([-180, 180], [-30, 120]))
        self.assertEqual(found["position_limits"], limits | {"c_deg": [-720, 720]})
        for at, within in (("c=720", True), ("c=-719.5", True), ("c=721", False), ("c=-800,a=1", False)):
            self.assertEqual(self.answer(path, "--at", at)["within_limits"], within, at)
        self.assertFalse(self.answer(path, "--limits", "c=-90:90", "--at", "c=100")["within_limits"])
        tilt = self.machine_file(configuration="W/caxyBz/T", limits={"a_deg": [-10, 200]})
        self.assertEqual(self.answer(tilt)["phi_range_deg"], [-180, 10])
        self.assertTrue(self.answer(tilt, "--at", "a=200")["within_limits"])
        self.assertFalse(self.answer(tilt, "--at", "a=201")["within_limits"])

    def test_offset_of_the_rotary_axes_is_reported(self):
        path = self.machine_file(configuration="W/caxyBz/T", axis_offset_mm=[0, 12, -8])
        self.assertEqual(self.answer(path)["axis_offset_mm"], [0, 12, -8])
        done = endmill("machine", path, cwd=self.folder)
        self.assertIn("R2 is offset from R1 by (0, 12, -8) mm; positions of X, Y and Z do not include the offset.\n",
                      done.stdout)
        self.assertEqual(self.answer("W/caxyBz/T")["axis_offset_mm"], [0, 0, 0])
        for word in ("W/cxyBza/T", "W/axyBz/T", "W/xyBz/T"):
            self.refused(self.machine_file(configuration=word, axis_offset_mm=[0, 0, 1]), status=3,
                         words=["m.json:/axis_offset_mm", "two rotary axes on one side of the bed"])
        for value, place in (([1, 2], "axis_offset_mm"), ([1, 2, "x"], "axis_offset_mm/2"), (3, "axis_offset_mm"),
                             ([0, 0, 1e7], "axis_offset_mm/2")):
            self.refused(self.machine_file(configuration="W/caxyBz/T", axis_offset_mm=value), status=3,
                         words=[f"m.json:/{place}: "])

    def test_malformed_words_are_refused(self):
        for word, said in (("W/caxyz/T", "B, the bed, is missing"), ("W/ccxyBz/T", "two equal rotary axes c"),
                           ("W/caxyBz", "/T is missing"), ("caxyBz/T", "W/ is missing"), ("W/cqxyBz/T", '"q"'),
                           ("W/CxyBz/T", "lower case"), ("W/cabxyBz/T", "three rotary axes"), ("W/caxyyBz/T", "two letters y"),
                           ("W/caxBz/T", "y is missing")):
            self.refused(word, words=[said])
            self.refused(self.machine_file(configuration=word), status=3, words=["/configuration", said])
        self.refused("", words=['MACHINE: found ""'])
        self.refused(self.machine_file(configuration=""), status=3, words=["/configuration", "W/ is missing"])
        self.refused("none.json", status=3, words=["none.json"])
        self.refused()
        self.assertEqual(self.answer(self.machine_file(configuration="W/acxyBz/T"), status=1)["rank"], 1)

    def test_invalid_limits_are_refused(self):
        for limits, said in (("a=30:-30", "hold 0"), ("a=1:2", "hold 0"), ("a=-181:0", "180"), ("c=-200:161", "360"),
                             ("b=-1:1", "limits of theta, c, phi, a"), ("a=-1:1,phi=-1:1", "once"), ("a=-1", "LO:HI"),
                             ("a=-1:1:2", "LO:HI"), ("a=x:1", "LO:HI"), ("a=nan:1", "LO:HI"), ("a", "list such as"),
                             ("a=-1:1,", "list such as"), ("=1:2", "list such as")):
            self.refused("W/caxyBz/T", "--limits", limits, words=["--limits", said])
        self.refused("W/axyBz/T", "--limits", "theta=-1:1", words=["phi, a"])
        self.refused("W/xyBz/T", "--limits", "phi=0:0", words=["no rotary axis"])
        self.refused("W/abxyBz/T", "--limits", "theta=-1:181", words=["180"])
        self.answer("W/caxyBz/T", "--limits", "c=-270:90")

    def test_files_with_invalid_limits_are_refused(self):
        for limits, said in (({"a_deg": [1, 2]}, "hold 0"), ({"c_deg": [0, 1000001]}, "-1e+06 to 1e+06"),
                             ({"b_deg": [-1, 1]}, "does not have")):
            key = next(iter(limits))
            self.refused(self.machine_file(configuration="W/caxyBz/T", limits=limits), status=3,
                         words=[f"/limits/{key}", said])

    def test_files_with_values_of_the_wrong_type_are_refused(self):
        for key, value, place in (("configuration", 3, "configuration"), ("limits", [], "limits"),
                                  ("limits", {"a_deg": 1}, "limits/a_deg"), ("limits", {"a_deg": ["x", 1]}, "limits/a_deg/0"),
                                  ("limits", {"a_deg": [9, -9]}, "limits/a_deg/1"), ("pivot_mm", "3", "pivot_mm"),
                                  ("limits", {"x_mm": [True, 5]}, "limits/x_mm/0"), ("spindle", 3, "spindle"),
                                  ("table_offset_mm", [1, 2], "table_offset_mm"), ("extra", 1, "extra")):
            given = {"configuration": "W/caxyBz/T", key: value}
            self.refused(self.machine_file(**given), status=3, words=[f"m.json:/{place}: "])
        self.refused(self.file("{", "m.json"), status=3, words=["m.json:1:2"])
        self.refused(self.folder, status=3, words=["directory"])

    def test_invalid_machine_does_not_hide_other_errors(self):
        for option in (("--limits", "a=1:2"), ("--limits", "b=-1:1"), ("--limits", "a"), ("--at", "b=1"), ("--at", "a")):
            self.refused("W/acxyBz/T", *option, words=[option[0]])

    def test_invalid_directions_and_positions_are_refused(self):
        for option in ("--contains", "--inverse"):
            for text in ("1", "1,2,3", "x,1", "0,181", "0,-1", "nan,1"):
                self.refused("W/caxyBz/T", option, text, words=[option, "AZIMUTH,POLAR"])
        for at in ("b=1", "a=1,a=2", "a=x", "a", "phi=1"):
            self.refused("W/caxyBz/T", "--at", at, words=["--at"])
        self.refused("W/caxyBz/T", "--point", "1,2,3", words=["--at or --inverse"])
        self.refused("W/caxyBz/T", "--at", "a=1", "--length", 5, words=["--point"])
        self.refused("W/caxyBz/T", "--at", "a=1", "--point", "1,2", words=["X,Y,Z"])


if __name__ == "__main__":
    unittest.main()
