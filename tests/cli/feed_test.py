# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill feed: a slot and rasters in closed form, the files, and refused input."""
import csv
import json
import math
import re
import unittest

from program import ROOT, SURFACES, ProgramTest, endmill, plane

STEEL = ROOT / "datasets/materials/steel.json"
MACHINE = ROOT / "datasets/machines/milling-machine-steel.json"
TOOL = ROOT / "datasets/tools/ball-10-steel-and-aluminium.json"
HEADER = ("pass,point,length_mm,mu_deg,lambda_deg,pick_feed_mm,pick_feed_horizontal_mm,depth_mm,"
          "engaged_angle_deg,feed_per_tooth_mm,peak_factor,limit,speed_limit,cutting_force_n,thrust_n,"
          "torque_n_m,power_w")
# docs/methods/ball-end-milling.md, section 9, A14: one straight horizontal slot.
SLOT = {"format": "endmill-material/1", "specific_resistance_n_per_mm2": 2000, "edge_thickness_mm": 0.016,
        "r1": 0.4, "r2": 0.4, "r3": 0.2, "r4": 0.6, "alpha": 0.368, "v1_m_per_min": 28.4313}
TWO_FLUTES = ["--cutter", "ball:10", "--flutes", "2"]


def rows(path):
    with path.open(encoding="ascii", newline="") as file:
        return list(csv.DictReader(file))


def raster(passes, pick=2.5, moves=3, length=30, y=1):
    """A one-way raster along x at z = 0 as CSV. Passes advance along the sign of `y`."""
    lines = ["pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm"]
    for k in range(passes):
        place = y * k * pick
        lines += [f"{k},0,rapid,0,{place},30", f"{k},1,plunge,0,{place},0"]
        lines += [f"{k},{i + 1},cut,{length * i / moves},{place},0" for i in range(1, moves + 1)]
        lines += [f"{k},{moves + 2},retract,{length},{place},30"]
    return "\n".join(lines) + "\n"


class Feed(ProgramTest):
    def fed(self, path, *options, status=0):
        """Runs `feed` and returns its output folder and its summary."""
        done = endmill("feed", path, "--material", STEEL, *options, "-o", "out", "--force", "--json",
                       cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return self.folder / "out", json.loads(done.stdout)

    def test_slot_has_the_feed_and_speed_of_the_test_vector(self):
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n50,0,0\n", "slot.csv")
        facts = self.summary("feed", path, "--material", self.file(SLOT, "m.json"), *TWO_FLUTES, "--max-force-n",
                             "1200", "--stock-top", "5", "--peak", "constant:1.8", "-o", "out",
                             "--accuracy", "1e-10", "--noncut-min", "0")
        row = rows(self.folder / "out/engagement.csv")[0]
        self.assertAlmostEqual(float(row["feed_per_tooth_mm"]), 0.072097110475, delta=1e-11)
        told = rows(self.folder / "out/toolpath.csv")[1]
        self.assertAlmostEqual(float(told["spindle_rpm"]), 904.996386706, delta=1e-8)
        self.assertAlmostEqual(float(told["feed_mm_per_min"]), 130.495248944, delta=1e-8)
        self.assertEqual((told["limit"], row["speed_limit"]), ("cutting_force", "economic_speed"))
        self.assertAlmostEqual(facts["cut_min"], 50 / 130.495248944, delta=1e-11)
        self.assertEqual(facts["limits"]["cutting_force"], 1)
        self.assertEqual((facts["total_min"], facts["saving_percent"]), (facts["cut_min"], None))

    def test_files_and_keys_are_complete(self):
        path = self.file(raster(3), "raster.csv")
        out, facts = self.fed(path, "--machine", MACHINE, "--tool", TOOL, "--stock-top", "2")
        self.assertEqual(sorted(p.name for p in out.iterdir()),
                         ["engagement.csv", "feed.svg", "summary.json", "toolpath.csv"])
        self.assertEqual((out / "engagement.csv").read_text().splitlines()[0], HEADER)
        head = (out / "toolpath.csv").read_text().splitlines()[0]
        self.assertTrue(head.endswith(",feed_mm_per_min,spindle_rpm,limit"), head)
        self.assertTrue((out / "feed.svg").read_text().startswith("<svg"))
        for key in ("cut_min", "limits", "infeasible", "speed_limits", "max_torque_n_m", "max_power_w"):
            self.assertIn(key, facts)
        self.assertEqual([facts[k] for k in ("mode", "chip", "peak", "engagement")],
                         ["paper", "paper", "constant:1.8", "auto"])
        for key in ("noncut_min", "total_min", "constant_feed_min", "saving_percent"):
            self.assertIsNone(facts[key])
        self.assertEqual(facts["segments_by_passes"], 9)
        self.assertEqual(facts, json.loads((out / "summary.json").read_text()))
        self.assertAlmostEqual(sum(facts["limits"].values()), 1, delta=1e-12)

    def test_raster_has_the_engagement_of_its_pitch(self):
        for towards, pick in ((1, 2.5), (-1, 1.5)):
            out, _ = self.fed(self.file(raster(3, pick, y=towards), "raster.csv"), "--tool", TOOL,
                              "--stock-top", "5")
            cuts = rows(out / "engagement.csv")
            self.assertEqual(len(cuts), 9)
            self.assertEqual((cuts[0]["pick_feed_mm"], cuts[0]["mu_deg"]), ("", ""))
            self.assertEqual(float(cuts[0]["engaged_angle_deg"]), 180)
            for cut in cuts[3:]:
                self.assertAlmostEqual(float(cut["pick_feed_mm"]), pick, delta=1e-12)
                self.assertEqual((float(cut["mu_deg"]), float(cut["lambda_deg"])), (0, 0))
                self.assertAlmostEqual(float(cut["engaged_angle_deg"]),
                                       math.degrees(math.acos(1 - pick / 5)), delta=1e-8)
                self.assertEqual(float(cut["depth_mm"]), 5)

    def test_total_time_is_the_sum_of_its_parts(self):
        path = self.file(raster(2), "raster.csv")
        out, facts = self.fed(path, "--tool", TOOL, "--stock-top", "5", "--rapid-mm-per-min", "3000",
                              "--constant-feed-mm-per-min", "40", "--plunge-feed-mm-per-min", "100")
        points = rows(out / "toolpath.csv")
        self.assertEqual(points[1]["feed_mm_per_min"], "100")
        self.assertEqual(points[0]["feed_mm_per_min"], "")
        # Two plunges and two retracts of 30 mm at 100 mm/min; one return over 30 and 2.5 mm.
        noncut = 4 * 30 / 100 + math.hypot(30, 2.5) / 3000
        self.assertAlmostEqual(facts["noncut_min"], noncut, delta=1e-12)
        cut = sum(10 / float(p["feed_mm_per_min"]) for p in points if p["move"] == "cut")
        self.assertAlmostEqual(facts["cut_min"], cut, delta=1e-12)
        self.assertAlmostEqual(facts["constant_feed_min"], 60 / 40 + noncut, delta=1e-12)
        self.assertAlmostEqual(facts["saving_percent"],
                               100 * (1 - (cut + noncut) / (60 / 40 + noncut)), delta=1e-9)

    def test_passes_between_two_others_give_a_remark(self):
        text = raster(2, 5) + "".join(f"9,{i},cut,{x},2.5,0\n" for i, x in enumerate((0, 15, 30)))
        out, facts = self.fed(self.file(text.replace("9,0,cut", "9,0,plunge"), "raster.csv"), "--tool", TOOL,
                              "--stock-top", "5")
        self.assertEqual((out / "engagement.csv").read_text().splitlines()[0], HEADER)
        self.assertTrue([r for r in facts["remarks"] if r.startswith("2 segments have earlier passes on both sides")])

    def test_machine_program_is_written_with_the_new_feeds(self):
        program = self.file("%\nG21 G90\nT3 M6\nS1000 M3\nG0 X0 Y0 Z30\nG1 Z0 F50\nX30 F300\nG0 Z30\n"
                            "G0 X0 Y2.5\nG1 Z0 F50\nX30 F300\nG0 Z30\nM30\n%\n", "part.ngc")
        out, _ = self.fed(program, "--tool", TOOL, "--stock-top", "5")
        text = (out / "part-feed.ngc").read_text()
        told = [p for p in rows(out / "toolpath.csv") if p["move"] == "cut"]
        self.assertEqual(len(told), 2)
        for point in told:
            self.assertIn(f"F{float(point['feed_mm_per_min']):.4f}".rstrip("0"), text)
            self.assertIn(f"S{float(point['spindle_rpm']):.4f}".rstrip("0"), text)
        self.assertIn("F50", text)
        self.assertNotIn("F300", text)
        self.assertIn("T3 M6", text)

    def test_machine_program_keeps_its_comments_and_arcs(self):
        lines = ["%", "(roughing, F300)", "N10 G21 G90 G17", "T3 M6", "S1000 M3", "G0 X0 Y0 Z30 ; over the start",
                 "G1 Z0 F50", "G1 X30 F300", "G3 X30 Y20 I0 J10 (half a turn)", "G1 X0", "G0 Z30", "M30", "%"]
        program = self.file("\n".join(lines) + "\n", "part.ngc")
        out, facts = self.fed(program, "--tool", TOOL, "--stock-top", "5")
        written = (out / "part-feed.ngc").read_text().splitlines()
        self.assertGreater(facts["segments"], 60)  # the arc has chords within 0.001 mm
        bare = [re.sub(r" ?\b[FS][0-9.]+", "", line) for line in written if not line.startswith("(")]
        # The cut is a slot everywhere, so both lines and the arc have the same feed and speed.
        self.assertEqual(bare, [re.sub(r" ?\b[FS][0-9.]+", "", line) for line in lines if not line.startswith("(")])
        self.assertIn(lines[1], written)
        rpm, feed = (rows(out / "toolpath.csv")[2][key] for key in ("spindle_rpm", "feed_mm_per_min"))
        self.assertIn(f"S{float(rpm):.4f}".rstrip("0").rstrip(".") + " M3", written)
        self.assertIn(f"G1 X30 F{float(feed):.4f}".rstrip("0").rstrip("."), written)

    def test_arc_across_a_groove_is_split_at_its_border(self):
        # An arc crosses an earlier slot along x. Its feed changes where the stock is already removed.
        program = self.file("G21 G90 G17\nS1000 M3\nG0 X-30 Y0 Z30\nG1 Z0 F50\nX30 F300\nG0 Z30\nX-20 Y4\n"
                            "G1 Z0 F50\nG2 X20 Y4 R200 F300\nG0 Z30\nM30\n", "part.ngc")
        out, _ = self.fed(program, "--tool", TOOL, "--stock-top", "5", "--allow-infeasible")
        arcs = [line for line in (out / "part-feed.ngc").read_text().splitlines() if line.startswith("G2 ")]
        self.assertGreater(len(arcs), 1)
        self.assertTrue(all(" I" in arc and " J" in arc for arc in arcs), arcs)
        again = self.summary("verify", out / "part-feed.ngc", "--cutter", "ball:10", "--stock",
                             "-40,-20,-5,40,20,5", "--part", "none", "-o", "a", "--force")
        before = self.summary("verify", program, "--cutter", "ball:10", "--stock",
                              "-40,-20,-5,40,20,5", "--part", "none", "-o", "b", "--force")
        self.assertAlmostEqual(again["removed_mm3"], before["removed_mm3"], delta=0.1)

    def test_tool_comes_from_a_table(self):
        program = ("G21 G90 G17\nT{0} M6\nS1000 M3\nG0 X-30 Y0 Z30\nG1 Z0 F50\nX30 F300\nT{1} M6\nX30 Y9\n"
                   "G0 Z30\nM30\n")
        table = self.file({"format": "endmill-tools/1", "tools": [
            {"number": 4, "tool": json.loads(TOOL.read_text())}, {"number": 5, "tool": "ball:4"}]}, "tools.json")
        out, facts = self.fed(self.file(program.format(4, 4), "p.ngc"), "--tools", table, "--stock-top", "5",
                              "--allow-infeasible")
        self.assertEqual(facts["cutter"], "ball:10")
        for tool, status, word in ((5, 2, "several tools cut"), (6, 3, "no row with a cutter for tool 6")):
            done = endmill("feed", self.file(program.format(4, tool), "p.ngc"), "--material", STEEL, "--tools",
                           table, "--stock-top", "5", "-o", "none", cwd=self.folder)
            self.assert_refused(done, status, word)

    def test_contacts_of_the_path_are_used(self):
        surface = self.file(plane())
        done = endmill("plan", surface, "--mode", "paper", "--cutter", "ball:10", "--chord-tolerance", "0.5",
                       "--scallop", "0.5", "--direction", "u", "--order", "one-way", "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        path = self.folder / "plan/toolpath.csv"
        results = []
        for options in ([], ["--part", surface], ["--engagement", "passes"]):
            out, facts = self.fed(path, "--flutes", "2", "--max-force-n", "900", "--stock-top", "4", *options)
            kind = "passes" if "passes" in options else "contact"
            self.assertEqual(facts["segments_by_" + kind], facts["segments"])
            results.append([(r["mu_deg"], r["pick_feed_mm"], r["limit"]) for r in rows(out / "engagement.csv")
                            if r["pick_feed_mm"]])
            self.assertTrue(results[-1])
        for other in results[1:]:
            for one, two in zip(results[0], other):
                self.assertAlmostEqual(float(one[0]), float(two[0]), delta=1e-7)
                self.assertAlmostEqual(float(one[1]), float(two[1]), delta=1e-9)

    def test_written_path_is_verified_by_the_same_part(self):
        surface = self.file(plane())
        done = endmill("plan", surface, "--mode", "paper", "--cutter", "ball:10", "--chord-tolerance", "0.5",
                       "--scallop", "0.5", "--direction", "u", "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        out, facts = self.fed(self.folder / "plan/toolpath.csv", "--flutes", "2", "--max-force-n", "900",
                              "--stock-top", "4")
        self.assertEqual(facts["part"], "../surface.json")
        done = endmill("verify", out / "toolpath.csv", "--resolution", "1", "-o", "verified", "--json",
                       cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["verdict"], "clean")

    def test_engagement_by_stock_agrees_with_engagement_by_passes(self):
        path = self.file(raster(4), "raster.csv")
        common = ["--tool", TOOL, "--stock-top", "5", "--max-feed-per-tooth", "1", "--stock",
                  "-20,-20,-20,50,30,5"]
        out, facts = self.fed(path, *common)
        passes = rows(out / "engagement.csv")
        out, facts = self.fed(path, *common, "--engagement", "stock", "--resolution", "0.5")
        self.assertEqual(facts["segments_by_stock"], 12)
        stock = rows(out / "engagement.csv")
        for one, two in zip(passes[3:], stock[3:]):
            self.assertAlmostEqual(float(one["feed_per_tooth_mm"]), float(two["feed_per_tooth_mm"]),
                                   delta=0.05 * float(one["feed_per_tooth_mm"]))

    def test_modes_select_chip_and_peak_rules(self):
        path = self.file(raster(2), "raster.csv")
        common = ["--tool", TOOL, "--stock-top", "5"]
        _, corrected = self.fed(path, *common, "--mode", "corrected")
        self.assertEqual((corrected["chip"], corrected["peak"]), ("exact", "direct"))
        _, planned = self.fed(path, *common, "--mode", "planned", "--machine", MACHINE)
        self.assertGreaterEqual(planned["planned_min"], planned["cut_min"])
        _, torque = self.fed(path, *common, "--peak", "torque", "--chip", "exact")
        self.assertEqual((torque["mode"], torque["peak"], torque["chip"]), ("paper", "torque", "exact"))
        _, table = self.fed(path, *common, "--coefficients", "table")
        _, direct = self.fed(path, *common)
        self.assertAlmostEqual(table["cut_min"], direct["cut_min"], delta=0.1 * direct["cut_min"])

    def test_files_do_not_depend_on_the_number_of_threads(self):
        path = self.file(raster(40, 0.7, 40), "raster.csv")
        for threads in ("1", "4"):
            self.fed(path, "--tool", TOOL, "--stock-top", "5", "--threads", threads)
            (self.folder / "out").rename(self.folder / ("out" + threads))
        for name in ("toolpath.csv", "engagement.csv", "feed.svg"):
            self.assertEqual((self.folder / "out1" / name).read_bytes(),
                             (self.folder / "out4" / name).read_bytes())

    def test_infeasible_plan_reports_the_moves_and_sufficient_limits(self):
        path = self.file(raster(1), "raster.csv")
        common = ["--material", STEEL, *TWO_FLUTES, "--stock-top", "20", "-o", "out", "--force"]
        done = endmill("feed", path, *common, "--max-force-n", "100", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("3 of 3 segments", done.stderr)
        needed = done.stderr.split("cutting_force ")[1].split(" N")[0]
        self.assertTrue((self.folder / "out/toolpath.csv").exists())
        allowed = endmill("feed", path, *common, "--max-force-n", "100", "--allow-infeasible", cwd=self.folder)
        self.assertEqual(allowed.returncode, 0, allowed.stderr)
        self.assertNotIn("no feed", allowed.stderr)
        self.assertIn("  infeasible    no feed of at least 0.005 mm per tooth", allowed.stdout)
        enough = endmill("feed", path, *common, "--max-force-n", needed, cwd=self.folder)
        self.assertEqual(enough.returncode, 0, enough.stderr)

    def refused(self, status, *words, path=None, options=(), material=STEEL):
        path = path or self.file(raster(2), "raster.csv")
        done = endmill("feed", path, "--material", material, *options, "-o", "out", cwd=self.folder)
        self.assert_refused(done, status, *words)
        self.assertFalse((self.folder / "out").exists())

    def test_top_of_the_stock_is_found_from_the_path_or_its_part(self):
        """A raster goes down from z = 4; a plan of a plane at z = 0 is cut from 1 mm above it, as `verify` does."""
        path = self.file(raster(2).replace(",30\n", ",4\n"), "raster.csv")
        _, found = self.fed(path, "--tool", TOOL)
        _, given = self.fed(path, "--tool", TOOL, "--stock-top", "4")
        self.assertEqual((found["stock_top_mm"], found["cut_min"]), (4, given["cut_min"]))
        self.assertIn("first move at feed", found["stock_top_by"])
        self.assertEqual(given["stock_top_by"], "--stock-top")
        part = self.file(plane(), "plane.json")
        self.summary("plan", part, "--cutter", "ball:10", "--chord-tolerance", "0.1", "--direction", "u", "-o", "plan")
        _, found = self.fed(self.folder / "plan/toolpath.csv", "--tool", TOOL)
        self.assertEqual((found["stock_top_mm"], found["stock_top_by"]), (1, "1 mm above the part of the path"))
        part.unlink()
        moved = endmill("feed", self.folder / "plan/toolpath.csv", "--material", STEEL, "--tool", TOOL, "-o", "moved",
                        cwd=self.folder)
        self.assert_refused(moved, 3, "plane.json: cannot open")
        done = endmill("feed", path, "--material", STEEL, "--tool", TOOL, "-o", "text", cwd=self.folder)
        self.assertIn("top of the stock z 4 mm (at most, where the first move at feed goes down)", done.stdout)

    def test_wrong_command_lines_are_refused(self):
        top = ["--stock-top", "5"]
        self.refused(2, "--flutes", options=["--cutter", "ball:10", *top])
        self.refused(2, "--cutter", options=["--flutes", "2", *top])
        self.refused(2, "ball", options=["--cutter", "flat:10", "--flutes", "2", *top])
        self.refused(2, "--cutter", options=["--cutter", "ball:0", "--flutes", "2", *top])
        self.refused(2, "--flutes", options=["--cutter", "ball:10", "--flutes", "0", *top])
        self.refused(2, "helix", options=[*TWO_FLUTES, "--peak", "torque", *top])
        self.refused(2, "helix", options=[*TWO_FLUTES, "--mode", "corrected", *top])
        self.refused(2, "--peak", options=[*TWO_FLUTES, "--peak", "constant:0.5", *top])
        self.refused(2, "--peak", options=[*TWO_FLUTES, "--peak", "constant:nan", *top])
        slot = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n50,0,0\n", "slot.csv")
        self.refused(2, "--stock-top", path=slot, options=TWO_FLUTES)
        self.refused(2, "acceleration", options=["--tool", TOOL, "--mode", "planned", *top])
        self.refused(2, "--coefficients", options=["--tool", TOOL, "--peak", "direct", "--coefficients", "table",
                                                   *top])
        self.refused(2, "--noncut-min", options=[*TWO_FLUTES, *top, "--noncut-min", "1", "--rapid-mm-per-min", "9"])
        for accuracy in ("1", "1e-18"):
            self.refused(2, "--accuracy", accuracy, "1e-12", options=["--tool", TOOL, *top, "--accuracy", accuracy])
        self.refused(2, "--helix-deg", "90", "80", options=[*TWO_FLUTES, *top, "--helix-deg", "90"])
        steep = self.file({"format": "endmill-tool/1", "name": "t", "cutter": "ball:10", "flutes": 2,
                           "helix_deg": -85, "source": "t"}, "t.json")
        self.refused(2, "--helix-deg", "-85", options=["--tool", steep, *top])
        self.refused(2, "--min-feed-per-tooth", "0.5", "0.15", options=["--tool", TOOL, *top,
                                                                        "--min-feed-per-tooth", "0.5"])
        self.refused(2, "--max-feed-per-tooth", "0.001", options=["--tool", TOOL, *top,
                                                                  "--max-feed-per-tooth", "0.001"])
        mesh = self.file("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                         "endloop\nendfacet\nendsolid a\n", "part.stl")
        self.refused(2, "mesh", options=["--tool", TOOL, *top, "--part", mesh])

    def test_bad_files_are_refused(self):
        common = ["--tool", TOOL, "--stock-top", "5"]
        bad = dict(SLOT)
        del bad["r3"]
        self.refused(3, "r3", material=self.file(bad, "m.json"), options=common)
        self.refused(3, "specific_resistance", options=common,
                     material=self.file({**SLOT, "specific_resistance_n_per_mm2": 0}, "m.json"))
        self.refused(3, "tip_z_mm", path=self.file("tip_x_mm,tip_y_mm\n0,0\n1,1\n", "p.csv"), options=common)
        swapped = "pass,point,tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0,0,0\n0,2,1,0,0\n0,1,2,0,0\n"
        self.refused(3, "p.csv:4: point 1 of pass 0 after point 2", path=self.file(swapped, "p.csv"), options=common)
        back = "pass,point,tip_x_mm,tip_y_mm,tip_z_mm\n1,0,0,0,0\n0,0,1,0,0\n"
        self.refused(3, "pass 0 after point 0 of pass 1", path=self.file(back, "p.csv"), options=common)
        self.refused(3, "machine", options=[*common, "--machine", self.file({"format": "x"}, "machine.json")])

    def test_impossible_geometry_is_refused(self):
        common = ["--tool", TOOL]
        top = ["--stock-top", "5"]
        still = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n0,0,0\n0,0,-1\n", "p.csv")
        self.refused(4, "no move", path=still, options=[*common, *top])
        self.refused(4, "above the stock", options=[*common, "--stock-top", "-1"])
        self.refused(4, "contact", options=[*common, *top, "--engagement", "contact"])
        self.refused(4, "5e+06 mm deep", "--peak constant", "point 2 of pass 0",
                     options=[*common, "--stock-top", "5000000", "--peak", "direct"])
        relative = self.file("G21 G91\nS1000 M3\nG1 X5 F100\nX5\nM30\n", "p.ngc")
        self.refused(3, "no absolute X Y Z", path=relative, options=[*common, *top])
        leaning = self.file("tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z\n0,0,0,0,0,1\n1,0,0,0,0.6,0.8\n",
                            "p.csv")
        self.refused(4, "0,0,1", path=leaning, options=[*common, *top])
        surface = self.file(plane(size=(60, 30)))
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n5,5,0\n20,5,0.3\n", "p.csv")
        self.refused(4, "misses it by 0.2", path=path, options=[*common, *top, "--part", surface])
        done = endmill("feed", path, "--material", STEEL, *common, *top, "--part", surface,
                       "--contact-tolerance", "0.5", "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_contact_tolerance_without_contacts_is_refused(self):
        options = ["--tool", TOOL, "--stock-top", "5", "--contact-tolerance", "0.5"]
        self.refused(2, "--contact-tolerance: has no effect with a path without contacts; expected --part",
                     options=options)
        surface = self.file(plane(size=(60, 30)))
        self.refused(2, "--contact-tolerance: has no effect with --engagement passes",
                     options=[*options, "--part", surface, "--engagement", "passes"])

    def test_move_of_zero_length_is_left_out(self):
        text = "tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n5,0,0\n5,0,0\n9,0,0\n"
        out, facts = self.fed(self.file(text, "p.csv"), "--tool", TOOL, "--stock-top", "5")
        self.assertEqual((facts["segments"], facts["zero_length_segments"]), (2, 1))
        self.assertEqual(len(rows(out / "toolpath.csv")), 4)
        self.assertTrue([r for r in facts["remarks"] if r.startswith("1 cutting move has zero length")])

    def test_stock_that_the_path_never_meets_is_refused(self):
        for engagement in ("stock", "passes", "auto"):
            self.refused(4, "stays", "mm away", "1000", options=[
                "--tool", TOOL, "--engagement", engagement, "--stock", "1000,1000,0,1010,1010,10"])
        self.refused(4, "965 mm away", options=["--tool", TOOL, "--stock", "1000,-5,-5,1010,5,5"])
        _, facts = self.fed(self.file(raster(1), "raster.csv"), "--tool", TOOL, "--stock", "-5,-9,-9,40,9,3")
        self.assertEqual([facts[key] for key in ("stock", "stock_top_mm", "programmed_point", "arc_tolerance_mm",
                                                 "block_delete")], ["-5,-9,-9,40,9,3", 3, "tip", 0.001, False])

    def test_normals_without_contact_points_give_the_contact(self):
        head = "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm"
        tilt = math.radians(20)
        lines = [head + ",normal_x,normal_y,normal_z"]
        for k in range(3):
            y, z = 2 * k * math.cos(tilt), 2 * k * math.sin(tilt)
            for i, x in enumerate((0, 10, 20)):
                lines.append(f"{k},{i},{'cut' if i else 'plunge'},{x},{y!r},{z!r},0,{-math.sin(tilt)!r},"
                             f"{math.cos(tilt)!r}")
        path = self.file("\n".join(lines) + "\n", "normals.csv")
        for engagement in ("contact", "auto"):
            out, facts = self.fed(path, "--tool", TOOL, "--stock-top", "8", "--engagement", engagement,
                                  "--allow-infeasible")
            self.assertEqual((facts["segments_by_contact"], facts["segments_by_passes"]), (6, 0))
            for cut in rows(out / "engagement.csv")[2:]:
                self.assertAlmostEqual(abs(float(cut["mu_deg"])), 20, delta=1e-9)
                self.assertAlmostEqual(float(cut["pick_feed_mm"]), 2, delta=1e-12)
        # The written path gives the same plan.
        written = self.file((out / "toolpath.csv").read_text(), "written.csv")
        _, facts = self.fed(written, "--tool", TOOL, "--stock-top", "8", "--engagement", "contact",
                                "--allow-infeasible")
        self.assertEqual(facts["segments_by_contact"], 6)

    def test_cutter_other_than_that_of_the_path_is_refused(self):
        surface = self.file(plane())
        done = endmill("plan", surface, "--mode", "paper", "--cutter", "ball:10", "--chord-tolerance", "0.5",
                       "--scallop", "0.5", "--direction", "u", "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        path = self.folder / "plan/toolpath.csv"
        self.refused(2, "ball:8", "ball:10", path=path, options=["--cutter", "ball:8", "--flutes", "2",
                                                                 "--stock-top", "4"])
        # Contacts of a ball of 10 mm diameter on a slope, without a summary.
        tilt = math.radians(30)
        y, z = -5 * math.sin(tilt), 5 - 5 * math.cos(tilt)
        bare = self.file("tip_x_mm,tip_y_mm,tip_z_mm,u,v,contact_x_mm,contact_y_mm,contact_z_mm,normal_x,normal_y,"
                         "normal_z\n" + "".join(f"{x},0,0,0,0,{x},{y!r},{z!r},0,{math.sin(tilt)!r},"
                                                f"{math.cos(tilt)!r}\n" for x in (0, 9)), "bare.csv")
        self.refused(4, "from the centre of ball:8", "expected 4 mm", path=bare,
                     options=["--cutter", "ball:8", "--flutes", "2", "--stock-top", "4"])
        _, facts = self.fed(bare, *TWO_FLUTES, "--stock-top", "4", "--allow-infeasible")
        self.assertEqual(facts["cutter"], "ball:10")

    def test_sense_of_the_helix_gives_a_remark_where_it_matters(self):
        def helix_remarks(y, helix, *options):
            path = self.file(raster(3, y=y), "raster.csv")
            _, facts = self.fed(path, *TWO_FLUTES, "--max-force-n", "1200", "--stock-top", "5", "--helix-deg", helix,
                                *options, "--allow-infeasible")
            self.assertEqual(facts["helix_deg"], float(helix))
            return facts["cut_min"], [r for r in facts["remarks"] if "left-hand" in r]
        for rule in ("torque", "direct"):
            # The first of three passes is a slot, where the sense of the helix has no effect.
            down, remarks = helix_remarks(-1, "30", "--peak", rule)
            self.assertEqual([r[:30] for r in remarks], ["milled down on 6 of 9 segments"])
            self.assertIn("--helix-deg -30", remarks[0])
            other, remarks = helix_remarks(-1, "-30", "--peak", rule)
            self.assertEqual(remarks, [])
            self.assertGreater(abs(other / down - 1), 1e-3)
            # The model mirrors the cut on the other side, so the hand of the helix is the opposite one.
            up, remarks = helix_remarks(1, "30", "--peak", rule)
            self.assertEqual(remarks, [])
            self.assertAlmostEqual(up, down, delta=1e-9 * down)
            self.assertEqual(len(helix_remarks(1, "-30", "--peak", rule)[1]), 1)
        self.assertEqual(helix_remarks(-1, "30")[1], [])
        stock = ["--engagement", "stock", "--stock", "-20,-30,-20,50,30,5", "--resolution", "0.5", "--peak", "torque"]
        self.assertEqual(len(helix_remarks(-1, "30", *stock)[1]), 1)
        self.assertEqual(len(helix_remarks(-1, "-30", *stock)[1]), 0)

    def test_summary_states_the_error_of_the_table(self):
        path = self.file(raster(2), "raster.csv")
        _, facts = self.fed(path, "--tool", TOOL, "--stock-top", "5", "--coefficients", "table")
        self.assertEqual(facts["table_error"], 0.025)
        self.assertEqual(facts["helix_deg"], 30)
        self.assertIn("0.025", endmill("feed", "--help").stdout)


if __name__ == "__main__":
    unittest.main()
