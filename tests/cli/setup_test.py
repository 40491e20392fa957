# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill setup: directions and teapot of docs/methods/five-axis-setup.md, section 9, convex parts,
machines of every kind, and refused input."""
import json
import math
import shutil
import subprocess
import unittest

from program import ENDMILL, ROOT, SURFACES, ProgramTest, endmill

TEAPOT = ROOT / "datasets/meshes/teapot-288.off"
MACHINES = ROOT / "datasets/machines"
HEADER = "azimuth_deg,polar_deg\n"

# A unit cube without its bottom, as five faces of two triangles.
CUBE = """OFF
8 10 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
3 4 5 6
3 4 6 7
3 0 1 5
3 0 5 4
3 1 2 6
3 1 6 5
3 2 3 7
3 2 7 6
3 3 0 4
3 3 4 7
"""


def ring(count, polar):
    return [(360 * k / count, polar) for k in range(count)]


class Setup(ProgramTest):
    def fit(self, family, directions, *options, status=0):
        """The answer of --points for directions (azimuth, polar angle)."""
        path = self.file(HEADER + "".join(f"{a!r},{p!r}\n" for a, p in directions), "points.csv")
        done = endmill("setup", "--points", path, "--family", family, *options, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout)

    def found(self, part, *options, status=0):
        """Runs setup on a part and returns the summary."""
        done = endmill("setup", part, *options, "-o", "out", "--force", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertNotIn("NaN", done.stdout)
        return json.loads(done.stdout)

    def refused(self, *arguments, status=2, words=()):
        self.assert_refused(endmill("setup", *arguments, "-o", "out", cwd=self.folder), status, *words)

    def test_sectors_of_directions_have_their_closed_form(self):
        found = self.fit("CA", [(0, 30), (100, 40), (200, 50)])
        self.assertAlmostEqual(found["area_deg2"], 8000, delta=1e-8)
        self.assertAlmostEqual(found["width_deg"], 100, delta=1e-9)
        self.assertEqual([round(phi, 9) for phi in found["phi_deg"]], [30, 50])
        self.assertAlmostEqual(self.fit("CA", ring(12, 15))["area_deg2"], 4500, delta=1e-7)
        self.assertEqual(self.fit("CA", [(77, 25)])["area_deg2"], 0)
        limited = ("--limits", "phi=0:30")
        self.assertFalse(self.fit("CA", ring(3, 20), *limited, status=1)["machinable"])
        wide = self.fit("CA", ring(3, 20), *limited, "--mode", "corrected")
        self.assertAlmostEqual(wide["area_deg2"], 4800, delta=1e-7)

    def test_feasible_pose_may_differ_from_the_least_pose(self):
        found = self.fit("CA", [(0, 60), (20, 20), (170, 25)], "--limits", "phi=-5:65")
        self.assertTrue(found["machinable"])
        self.assertAlmostEqual(found["area_deg2"], 10200, delta=1e-8)
        self.assertAlmostEqual(found["mar"]["area_deg2"], 2550, delta=1e-8)

    def test_rectangles_of_directions_have_the_areas_of_the_test_vectors(self):
        rings = ((4, 10, 200.505460, 200.505460), (5, 20, 1382.215474, 1377.159686), (3, 30, 2365.859632, 2363.094775))
        for count, polar, paper, corrected in rings:
            for mode, area in (("paper", paper), ("corrected", corrected)):
                found = self.fit("AB", ring(count, polar), "--mode", mode)
                self.assertAlmostEqual(found["area_deg2"] / area, 1, delta=1e-6)
        low = [(0, 30), (120, 95), (240, 20)]
        none = self.fit("AB", low, status=1)
        self.assertEqual((none["status"], none["area_deg2"]), ("not in an open hemisphere", None))
        self.assertAlmostEqual(self.fit("AB", low, "--mode", "corrected")["area_deg2"] / 4602.510064, 1, delta=1e-6)

    def test_rigid_part_is_not_mirrored(self):
        corners = []
        for alpha, beta in ((-10, -30), (-10, 15), (40, -30), (40, 15)):
            a, b = math.radians(alpha), math.radians(beta)
            x, y, z = math.sin(b), -math.sin(a) * math.cos(b), math.cos(a) * math.cos(b)
            corners.append((math.degrees(math.atan2(y, x)), math.degrees(math.acos(z))))
        limits = ("--limits", "phi=-15:45,theta=-20:35")
        paper = self.fit("AB", corners, *limits)
        self.assertEqual((paper["machinable"], paper["rigid"]), (True, False))
        self.assertAlmostEqual(paper["area_deg2"], 2250, delta=1e-6)
        self.assertFalse(self.fit("AB", corners, *limits, "--mode", "corrected", status=1)["machinable"])
        other = self.fit("AB", corners, "--limits", "phi=-15:45,theta=-35:20", "--mode", "corrected")
        self.assertAlmostEqual(other["area_deg2"], 2250, delta=1e-6)

    def test_teapot_has_the_areas_of_the_test_vectors(self):
        areas = {("CA", "paper"): 18988.30, ("AB", "paper-literal"): 8760.23, ("AB", "paper"): 9161.98,
                 ("AB", "corrected"): 9151.83}
        self.found(TEAPOT, "--family", "CA")
        saved = self.folder / "saved.bsm"
        saved.write_bytes((self.folder / "out/visibility.bsm").read_bytes())
        for (family, mode), area in areas.items():
            found = self.found(TEAPOT, "--family", family, "--mode", mode, "--from-visibility", saved)
            self.assertTrue(found["machinable"])
            self.assertEqual((found["facets"], found["cells"], found["empty_cones"]), (288, 1200, []))
            self.assertAlmostEqual(found["area_deg2"], area, delta=0.005)
            self.assertGreater(found["tool_axis"][0], 0)  # the tool axis leans towards the spout

    def test_mode_set_keeps_the_gap_to_its_bound(self):
        found = self.found(TEAPOT, "--family", "AB", "--mode", "set")
        self.assertLessEqual(found["lower_bound_deg2"], 931.92)  # a pose of section 8.4
        self.assertGreaterEqual(found["objective_deg2"], 929.24)  # the bound of that pose
        self.assertLessEqual(found["objective_deg2"], 1.05 * found["lower_bound_deg2"] * (1 + 1e-12))
        self.assertAlmostEqual(found["floored_area_deg2"], found["objective_deg2"], delta=1e-9)

    def test_cube_is_set_up_on_machines_of_all_kinds(self):
        cube = self.file(CUBE, "cube.off")
        cone = ("--incidence-deg", 80)
        three = self.found(cube, "--machine", "W/xyBz/T", *cone, status=1)
        self.assertEqual((three["machinable"], three["status"]), (False, None))  # a status needs a pose
        four = self.found(cube, "--machine", "W/axyBz/T", *cone)
        self.assertEqual((four["type"], four["area_deg2"], four["objective_deg2"]), ("4-axis", 0, 0))
        four = self.found(cube, "--machine", "W/axyBz/T", *cone, "--mode", "set")
        self.assertAlmostEqual(four["objective_deg2"], four["floored_area_deg2"], delta=1e-9)
        sectors = self.found(cube, "--machine", "W/caxyBz/T", *cone)
        self.assertLessEqual(sectors["area_deg2"], 1800.1)  # at z; other poses may need less
        set_search = self.found(cube, "--machine", "W/caxyBz/T", "--incidence-deg", 75, "--mode", "set",
                                "--gap", 0.005)
        self.assertAlmostEqual(set_search["objective_deg2"] / 385.806, 1, delta=0.006)
        none = self.found(cube, "--machine", "W/xyzBbc/T", *cone, status=1)
        self.assertIn("turns it about itself", none["reason"])

    def test_holder_reduces_the_visibility(self):
        """A wide holder keeps the tool away from the foot of a step, but not from its top."""
        step = self.file("""OFF
9 5 0
0 -1 0
1 -1 0
1 2 0
0 2 0
0 -1 30
0 2 30
-9 -9 30
-9 9 30
1 -1 0
3 0 1 2
3 0 2 3
3 0 3 5
3 0 5 4
3 4 5 7
""", "step.off")
        holder = self.file({"format": "endmill-tool/1", "cutter": "ball:1", "holder": [
            {"diameter_mm": 40, "from_mm": 10, "to_mm": 90}]}, "tool.json")
        free = self.found(step, "--family", "CA", "--incidence-deg", 60)
        self.assertEqual(free["empty_cones"], [])
        wide = self.found(step, "--family", "CA", "--incidence-deg", 60, "--tool", holder, status=1)
        self.assertTrue({0, 1} & set(wide["empty_cones"]))
        self.assertNotIn(4, wide["empty_cones"])
        saved = self.folder / "saved.bsm"
        saved.write_bytes((self.folder / "out/visibility.bsm").read_bytes())
        again = self.found(step, "--family", "CA", "--from-visibility", saved, "--tool", holder, status=1)
        self.assertEqual(again["empty_cones"], wide["empty_cones"])
        self.refused(step, "--family", "CA", "--from-visibility", saved, "--force", words=("another tool",))
        other = self.file(CUBE, "cube.off")
        self.refused(other, "--family", "CA", "--from-visibility", saved, "--force", status=3, words=("saved.bsm",))

    def test_several_setups_cover_the_part(self):
        found = self.found(TEAPOT, "--machine", "W/xyBz/T", "--max-setups", 6, status=1)
        self.assertEqual(len(found["setups"]), 4)
        self.assertEqual((found["uncovered"], found["setups_lower_bound"]), ([], 1))
        facets = sorted(facet for setup in found["setups"] for facet in setup["facets"])
        self.assertEqual(facets, list(range(288)))
        proved = self.found(TEAPOT, "--machine", "W/xyBz/T", "--max-setups", 6, "--mode", "set", status=1)
        self.assertEqual(proved["setups_lower_bound"], 2)
        few = self.found(TEAPOT, "--machine", "W/xyBz/T", "--max-setups", 2, status=1)
        self.assertGreater(len(few["uncovered"]), 0)

    def test_linear_travel_is_checked(self):
        cube = self.file(CUBE, "cube.off")
        def machine(**limits):
            return self.file({"format": "endmill-machine/1", "configuration": "W/caxyBz/T", "limits": limits}, "m.json")
        wide = self.found(cube, "--machine", machine(x_mm=[-5, 5], y_mm=[-5, 5], z_mm=[-5, 5]), "--incidence-deg", 80)
        self.assertTrue(wide["travel_ok"])
        for axis in "xyz":
            low, high = wide["travel_mm"][axis]
            self.assertLessEqual(abs(low), math.sqrt(3))  # the tip stays within the diagonal of the cube
            self.assertLessEqual(low, high)
        far = self.found(cube, "--machine", machine(x_mm=[-5, 5]), "--incidence-deg", 80, "--clamp", "100,0,0",
                         status=1)
        self.assertEqual((far["machinable"], far["rotary_ok"], far["travel_ok"]), (False, True, False))
        printed = endmill("setup", cube, "--machine", machine(x_mm=[-5, 5]), "--incidence-deg", 80, "--clamp", "100,0,0",
                       "-o", "out-2", cwd=self.folder).stdout
        self.assertIn("beyond the limits of the linear axes", printed)
        self.assertIn(": not machinable at this clamping on W/caxyBz/T", printed)  # exit 1 never says machinable
        self.assertIn("--mode set", printed)
        clamp = ",".join(str(x) for x in far["clamp_centred_mm"])
        self.assertTrue(self.found(cube, "--machine", machine(x_mm=[-5, 5]), "--incidence-deg", 80, "--clamp",
                                   clamp)["travel_ok"])

    def test_travel_bounds_the_search(self):
        """A plane with centroids at (0, 0) and (90, 30) mm on a machine of three axes: the travel is the difference
        of the centroids in machine axes, and half of what is left of each axis is its slack."""
        part = self.file("OFF\n6 2 0\n-1 -1 0\n2 -1 0\n-1 2 0\n89 29 0\n92 29 0\n89 32 0\n"
                         "3 0 1 2\n3 3 4 5\n", "plane.off")

        def machine(x, y, z):
            return self.file({"format": "endmill-machine/1", "configuration": "W/xyBz/T",
                              "limits": {"x_mm": x, "y_mm": y, "z_mm": z}}, "m.json")
        cone = ("--incidence-deg", 30)
        found = self.found(part, "--machine", machine([0, 40], [0, 95], [0, 60]), *cone, "--within-travel")
        self.assertTrue(found["travel_ok"] and found["within_travel"]["fits"])
        rows = found["part_to_machine"]
        for row, axis, room in zip(rows, "xyz", (40, 95, 60)):
            width = abs(90 * row[0] + 30 * row[1])
            self.assertAlmostEqual(found["within_travel"]["slack_mm"][axis], (room - width) / 2, delta=1e-5)
            low, high = found["travel_mm"][axis]
            self.assertGreaterEqual(low, -1e-6)
            self.assertLessEqual(high, room + 1e-6)
        self.assertEqual(found["clamp_mm"], found["within_travel"]["clamp_mm"])
        clamp = ",".join(map(repr, found["clamp_mm"]))
        again = self.found(part, "--machine", machine([0, 40], [0, 95], [0, 60]), *cone, "--within-travel",
                           "--clamp", clamp)
        self.assertEqual(again["tool_axis"], found["tool_axis"])

        none = self.found(part, "--machine", machine([0, 30], [0, 30], [0, 30]), *cone, "--within-travel", status=1)
        self.assertEqual((none["machinable"], none["rotary_ok"], none["travel_ok"], none["within_travel"]["fits"]),
                         (False, True, False, False))
        self.assertLess(min(none["within_travel"]["slack_mm"].values()), 0)
        self.assertGreater(none["within_travel"]["poses"], 36)
        done = endmill("setup", part, "--machine", machine([0, 30], [0, 30], [0, 30]), *cone, "--within-travel",
                       "-o", "text", cwd=self.folder)
        self.assertIn(f"none of {none['within_travel']['poses']} poses fits the linear axes", done.stdout)
        self.assertIn(": not machinable within the travel of the linear axes on W/xyBz/T", done.stdout)

    def test_travel_cannot_bound_the_search_without_limits(self):
        for machine in (("--machine", "W/caxyBz/T"), ("--family", "CA")):
            self.refused(TEAPOT, *machine, "--within-travel", words=("--within-travel", "machine"))
        points = self.file(HEADER + "0,60\n", "points.csv")
        self.refused("--points", points, "--family", "CA", "--within-travel", words=("--within-travel", "PART"))

    def test_teapot_is_set_up_within_the_travel(self):
        free = self.found(TEAPOT, "--machine", MACHINES / "ca-head-head.json", status=1)
        self.assertFalse(free["travel_ok"])
        saved = self.folder / "saved.bsm"
        saved.write_bytes((self.folder / "out/visibility.bsm").read_bytes())
        found = self.found(TEAPOT, "--machine", MACHINES / "ca-head-head.json", "--from-visibility", saved,
                           "--within-travel")
        self.assertTrue(found["within_travel"]["fits"])
        self.assertGreaterEqual(found["area_deg2"], free["area_deg2"] - 1e-9)
        self.assertGreaterEqual(min(found["within_travel"]["slack_mm"].values()), 0)

    def test_all_machines_are_ranked(self):
        cube = self.file(CUBE, "cube.off")
        found = self.found(cube, "--machine", MACHINES, "--incidence-deg", 80)
        ranking = found["ranking"]
        self.assertEqual(len(ranking), len(list(MACHINES.glob("*.json"))))
        self.assertEqual(found["configuration"], ranking[0]["configuration"])
        order = [(not one["rotary_ok"], one["floored_area_deg2"] if one["floored_area_deg2"] is not None else math.inf,
                  one["configuration"]) for one in ranking]
        self.assertEqual(order, sorted(order))

    def test_machines_of_the_program_are_found(self):
        """The program finds its machines in the installation, the build tree or the current folder."""
        cube = self.file(CUBE, "cube.off")
        self.assertEqual(len(self.found(cube, "--machine", "all")["ranking"]), len(list(MACHINES.glob("*.json"))))
        program = self.folder / "bin/endmill"
        program.parent.mkdir()
        shutil.copy(ENDMILL, program)

        def moved(*arguments):
            return subprocess.run([program, "setup", cube, "--machine", "all", "-o", "out", "--force", *arguments],
                                  capture_output=True, text=True, check=False, cwd=self.folder)

        installed = self.folder / "share/endmill/machines"
        here = self.folder / "datasets/machines"
        self.assert_refused(moved(), 2, "--machine all", str(installed), "datasets/machines")
        for folder, word in ((here, "W/xyBz/T"), (installed, "W/axyBz/T")):
            folder.mkdir(parents=True)
            (folder / "m.json").write_text(json.dumps({"format": "endmill-machine/1", "configuration": word}))
            done = moved("--json", "--quiet")
            self.assertEqual(json.loads(done.stdout)["configuration"], word, done.stderr)

    def test_unreachable_facets_are_listed(self):
        inside = CUBE.replace("8 10 0", "12 12 0").replace("3 4 5 6\n", """.2 .2 .5
.8 .2 .5
.8 .8 .5
.2 .8 .5
3 8 9 10
3 8 10 11
3 4 5 6
""", 1)
        closed = inside.replace("12 12 0", "12 14 0") + "3 0 2 1\n3 0 3 2\n"
        found = self.found(self.file(closed, "box.off"), "--family", "AB", "--incidence-deg", 80, status=1)
        self.assertEqual(found["machinable"], False)
        self.assertIn(0, found["empty_cones"])
        self.assertIn(1, found["empty_cones"])
        self.assertEqual(set(found["empty_cones"]) - set(found["missed_facets"]), set())
        first = found["hidden_facets"][0]
        self.assertEqual(first["facet"], found["empty_cones"][0])
        text = endmill("setup", self.folder / "box.off", "--family", "AB", "--incidence-deg", 80, "-o", "text",
                       cwd=self.folder).stdout
        self.assertIn(": not machinable in one setup on AB", text)
        self.assertIn(f"facet {first['by']} hides 0", text)
        self.assertIn("% of the area)", text)

    def test_facets_that_one_setup_misses_are_named(self):
        """On a machine of three axes the cube's best setup reaches three of its five sides: of ten facets it misses
        four, two fifths of the area."""
        cube = self.file(CUBE, "cube.off")
        found = self.found(cube, "--machine", "W/xyBz/T", "--incidence-deg", 80, status=1)
        self.assertEqual((len(found["missed_facets"]), found["empty_cones"], found["hidden_facets"]), (4, [], []))
        self.assertAlmostEqual(found["missed_area_share"], 0.4, delta=1e-12)
        done = endmill("setup", cube, "--machine", "W/xyBz/T", "--incidence-deg", 80, "-o", "text", cwd=self.folder)
        numbers = " ".join(map(str, found["missed_facets"]))
        self.assertIn("  reason       a 3-axis machine cuts from one direction, and the best one misses 4 facets: "
                      f"{numbers} (40 % of the area)\n", done.stdout)
        good = self.found(cube, "--family", "AB", "--incidence-deg", 80)
        self.assertEqual((good["missed_facets"], good["missed_area_share"]), (None, None))

    def test_mode_that_finds_no_pose_is_named_with_a_better_one(self):
        machine = ROOT / "datasets/machines/ca-table-table.json"
        done = endmill("setup", TEAPOT, "--units", "mm", "--machine", machine, "-o", "paper", cwd=self.folder)
        self.assertIn("  reason       mode paper finds no pose within the limits, though one exists; expected --mode set, "
                      "which searches all poses\n", done.stdout)
        self.assertTrue(self.found(TEAPOT, "--units", "mm", "--machine", machine, "--mode", "set")["machinable"])

    def test_points_are_reported_in_sentences(self):
        """Three directions on a circle of 30 degrees: a pose of C,A tilts by 30 to both sides and turns C by 60."""
        points = self.file(HEADER + "0,30\n120,30\n240,30\n", "points.csv")
        done = endmill("setup", "--points", points, "--machine", "W/caxyBz/T", cwd=self.folder)
        first, ranges, azimuth = done.stdout.splitlines()
        self.assertEqual(first, f"{points}: 3 directions can be reached in one setup on W/caxyBz/T, mode paper")
        self.assertIn("ranges       phi -30 to 30, theta -60 to 60 degrees; area 7200 deg^2", ranges)
        self.assertIn("30 degrees: R2", azimuth)
        done = endmill("setup", "--points", points, "--family", "CA", "--limits", "phi=0:10", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("needed       phi -30 to 30, theta -60 to 60 degrees (limits 0 to 10 and -180 to 180)",
                      done.stdout)

    def test_sampled_surface_gives_no_warning(self):
        done = endmill("setup", SURFACES / "saddle.json", "--machine", "W/caxyBz/T", "--sphere", "hex:3", "-o", "out",
                       "--json", cwd=self.folder)
        self.assertEqual(done.stderr, "")
        self.assertIn("the surface is sampled as 2304 triangles", " ".join(json.loads(done.stdout)["remarks"]))

    def test_part_without_reachable_facets_is_reported(self):
        """Every mode lists the facets, for both families and for words that begin with b."""
        cube = self.file(CUBE, "cube.off")
        modes = [("--mode", mode) for mode in ("paper", "corrected", "set")]
        for word, choices in (("caxyBz", modes), ("abxyBz", modes), ("baxyBz", modes), ("axyBz", [(), modes[-1]]),
                              ("xyBz", [()])):
            for mode in choices:
                found = self.found(cube, "--machine", f"W/{word}/T", *mode, "--sphere", "hex:2",
                                   "--incidence-deg", 1, status=1)
                self.assertEqual((found["machinable"], found["empty_cones"]), (False, list(range(10))))

    def test_facets_keep_their_numbers(self):
        """A degenerate face keeps its number, but has no cone."""
        degenerate = CUBE.replace("8 10 0", "9 11 0").replace("3 4 5 6\n", ".5 0 0\n3 0 8 1\n3 4 5 6\n", 1)
        found = self.found(self.file(degenerate, "cube.off"), "--family", "AB", "--incidence-deg", 80)
        same = self.found(self.file(CUBE, "cube.off"), "--family", "AB", "--incidence-deg", 80)
        self.assertEqual((found["facets"], same["facets"]), (11, 10))
        self.assertEqual((found["empty_cones"], found["area_deg2"]), ([], same["area_deg2"]))
        self.found(self.file(degenerate, "cube.off"), "--family", "AB", "--incidence-deg", 80)
        rows = (self.folder / "out/cones.csv").read_text().splitlines()
        self.assertEqual((len(rows), rows[1]), (12, "0,"))

    def test_limits_in_force_are_reported(self):
        keys = ("limits_phi_deg", "limits_theta_deg")
        machine_file = self.file({"format": "endmill-machine/1", "configuration": "W/cxyBza/T",
                                  "limits": {"a_deg": [-9, 9], "c_deg": [-180, 180]}}, "m.json")
        machine = ("--machine", machine_file, "--limits", "phi=-5:95")
        points = self.file(HEADER + "0,60\n", "points.csv")
        done = endmill("setup", "--points", points, *machine, "--json", cwd=self.folder)
        fitted = json.loads(done.stdout)
        self.assertEqual([fitted[key] for key in keys], [[-5, 95], [-180, 180]])
        whole = self.found(self.file(CUBE, "cube.off"), *machine, "--incidence-deg", 80)
        self.assertEqual([whole[key] for key in keys], [fitted[key] for key in keys])
        self.assertEqual((whole["machine"], whole["type"]), (fitted["machine"], fitted["type"]))

    def test_options_without_effect_are_refused(self):
        five, four, three = (("--machine", f"W/{axes}/T") for axes in ("caxyBz", "axyBz", "xyBz"))
        search = (("--gap", 0.1), ("--max-nodes", 9), ("--objective", "tilt"))
        for option in search:
            self.refused(TEAPOT, *five, *option, words=(option[0], "--mode paper", "expected --mode set"))
            self.refused(TEAPOT, *four, "--mode", "set", *option, words=(option[0], "two rotary axes"))
        for machine in (five, three, ("--family", "AB")):
            self.refused(TEAPOT, *machine, "--arc-tolerance-deg", 2, words=("--arc-tolerance-deg", "one rotary axis"))
        self.refused(TEAPOT, "--family", "AB", "--clamp", "0,0,0", words=("--clamp", "--machine"))
        for machine, modes in ((four, ("paper", "paper-literal", "corrected")), (three, ("paper", "corrected", "set"))):
            for mode in modes:
                self.refused(TEAPOT, *machine, "--mode", mode, words=("--mode", machine[1], "two rotary axes"))
        points = self.file(HEADER + "0,60\n", "points.csv")
        for option in (*search, ("--sphere", "hex:4"), ("--visibility", "local"), ("--incidence-deg", 80),
                       ("--floor-deg", 1), ("--max-setups", 1), ("--write-bsm-csv",), ("--clamp", "0,0,0"),
                       ("--arc-tolerance-deg", 2), ("--tool", "t.json"), ("--from-visibility", "v.bsm"),
                       ("--chord-tolerance", 1), ("--units", "inch"), ("--up", "x")):
            self.refused("--points", points, "--family", "CA", *option, words=(option[0],))
        cube = self.file(CUBE, "cube.off")
        self.assertIsNone(self.found(cube, *four, "--arc-tolerance-deg", 2, "--incidence-deg", 80)["mode"])
        self.assertEqual(self.found(cube, *four, "--mode", "set", "--incidence-deg", 80)["mode"], "set")
        self.found(cube, "--machine", MACHINES, "--arc-tolerance-deg", 2)

    def test_invalid_machine_does_not_hide_other_errors(self):
        word = ("--machine", "W/acxyBz/T")
        points = self.file(HEADER + "0,60\n", "points.csv")
        for part in ((TEAPOT,), ("--points", points)):
            for option in (("--limits", "a=1:2"), ("--limits", "b=-1:1"), ("--gap", 0.1), ("--limits", "phi")):
                self.refused(*part, *word, *option, words=(option[0],))
        done = endmill("setup", "--points", points, *word, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("turns it about itself", json.loads(done.stdout)["reason"])

    def test_bad_input_is_refused(self):
        self.refused(TEAPOT, words=("--machine", "--family"))
        self.refused("--family", "CA", words=("PART",))
        self.refused(TEAPOT, "--machine", "W/caxyz/T", words=("B",))
        self.refused(TEAPOT, "--machine", "W/caxyBz", words=("/T",))
        self.refused(TEAPOT, "--machine", "W/ccxyBz/T", words=("c",))
        self.refused(TEAPOT, "--family", "CA", "--limits", "phi=30:-30", words=("--limits",))
        self.refused(TEAPOT, "--family", "CA", "--limits", "theta=-200:200", words=("--limits",))
        self.refused(TEAPOT, "--family", "CA", "--sphere", "hex:0", words=("hex",))
        self.refused(TEAPOT, "--family", "CA", "--objective", "tilt", words=("--mode set",))
        self.refused(self.file("OFF\n0 0 0\n", "empty.off"), "--family", "CA", status=3)
        self.refused(self.file(CUBE.replace("1 1 1", "1 nan 1"), "nan.off"), "--family", "CA", status=3,
                     words=("nan.off",))
        self.refused("--points", self.file(HEADER + "1,200\n", "p.csv"), "--family", "CA", status=3, words=("p.csv:2",))
        self.refused(TEAPOT, "--family", "CA", "--incidence-deg", 0, words=("--incidence-deg", "above 0, at most 90"))
        self.refused(TEAPOT, "--family", "CA", "--sphere", "hex:200", "--max-memory", 0.02, status=6,
                     words=("288 facets", "480000 directions", "--max-memory", "--sphere"))
        folder = self.folder / "machines"
        folder.mkdir()
        self.refused(TEAPOT, "--machine", folder, status=3, words=("machines",))
        (folder / "m.json").mkdir()
        self.refused(TEAPOT, "--machine", folder, status=3, words=("m.json", "directory"))
        self.assert_nothing_left("empty.off", "nan.off", "p.csv", "machines")

    def test_invalid_directions_are_refused(self):
        path = self.folder / "p.csv"
        for text, place, said in (("", "", "empty"), (HEADER, ":1", "no row"), ("a,b\n1,2\n", ":1", '"a"'),
                                  ("azimuth_deg\n1\n", ":1", "no column polar_deg"), (HEADER + "0,1\n1\n", ":3", "1 cell"),
                                  (HEADER + "nan,1\n", ":2", "azimuth_deg"), (HEADER + "0,\n", ":2", "polar_deg"),
                                  (HEADER + "0,1e400\n", ":2", "polar_deg")):
            path.write_text(text)
            self.refused("--points", path, "--family", "AB", status=3, words=(f"p.csv{place}: ", said))
        self.refused("--points", self.folder, "--family", "AB", status=3, words=("directory",))
        path.write_text(HEADER + "0,1\n" * 1000)
        self.refused("--points", path, "--family", "AB", "--max-memory", 1e-6, status=6, words=("p.csv",))

    def test_damaged_visibility_is_refused(self):
        cube = self.file(CUBE, "cube.off")
        self.found(cube, "--family", "CA", "--sphere", "hex:2", "--incidence-deg", 80)
        whole = (self.folder / "out/visibility.bsm").read_bytes()
        shutil.rmtree(self.folder / "out")
        flipped = bytearray(whole)
        flipped[len(whole) // 2] ^= 1
        other_part = bytearray(whole)
        other_part[40] ^= 1  # the byte belongs to the checksum of the part: docs/file-formats.md
        for content, said in ((b"", "empty"), (whole[:40], "header"), (whole[:-8], f"expected {len(whole)}"),
                              (whole + bytes(8), f"expected {len(whole)}"), (b"x" + whole[1:], "EMILLBSM"),
                              (bytes(flipped), "checksum"), (bytes(other_part), "checksum")):
            saved = self.file(content, "saved.bsm")
            self.refused(cube, "--family", "CA", "--from-visibility", saved, status=3, words=("saved.bsm", said))
        self.refused(cube, "--family", "CA", "--from-visibility", self.folder, status=3, words=("directory",))
        self.assert_nothing_left("cube.off", "saved.bsm")

    def test_defective_meshes_give_remarks(self):
        """Open meshes, edges of three triangles and duplicate triangles are accepted."""
        odd = CUBE.replace("8 10 0", "8 12 0") + "3 4 5 1\n3 3 4 7\n"
        done = endmill("setup", self.file(odd, "odd.off"), "--family", "AB", "--sphere", "hex:2", "-o", "out", "--json",
                       cwd=self.folder)
        remarks = " ".join(json.loads(done.stdout)["remarks"])
        for said in ("the part is open", "more than two triangles", "1 triangle repeats an earlier triangle"):
            self.assertIn(said, remarks)
            self.assertIn(said, done.stderr)

    def test_unwritable_results_are_reported(self):
        cube = self.file(CUBE, "cube.off")
        call = (cube, "--family", "CA", "--sphere", "hex:2", "--incidence-deg", 80)
        for out, status in ((cube, 2), (self.folder, 2), (cube / "out", 5), ("/proc/out", 5)):
            self.assert_refused(endmill("setup", *call, "-o", out, cwd=self.folder), status)
        machine = self.file({"format": "endmill-machine/1", "configuration": "W/caxyBz/T"}, "summary.json")
        self.assert_refused(endmill("setup", cube, "--machine", machine, "-o", ".", "--force", cwd=self.folder), 2,
                            "input file")
        self.assert_nothing_left("cube.off", "summary.json")
        (self.folder / "out/summary.json").mkdir(parents=True)
        self.assert_refused(endmill("setup", *call, "-o", "out", "--force", cwd=self.folder), 5, "summary.json")
        self.assertEqual([path.name for path in (self.folder / "out").iterdir()], ["summary.json"])
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([ENDMILL, "setup", *map(str, call), "-o", "out-2", "--json"], stdout=full,
                                  stderr=subprocess.PIPE, text=True, check=False, cwd=self.folder)
        self.assertEqual(done.returncode, 5, done.stderr)


if __name__ == "__main__":
    unittest.main()
