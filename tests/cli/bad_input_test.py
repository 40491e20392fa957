# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input of every kind gives one line of error and its exit code, and leaves no partial output."""
import json
import os
import resource
import shutil
import signal
import subprocess
import time
import unittest

from program import ENDMILL, SURFACES, ProgramTest, endmill, plane

PLAN = ["--mode", "paper", "--cutter", "ball:10", "--chord-tolerance", "0.5", "--scallop", "1", "-o", "out"]


def changed(**keys):
    surface = plane()
    surface.update(keys)
    return {key: value for key, value in surface.items() if value is not None}


def with_point(value):
    surface = plane()
    surface["control_points"][2][1] = value
    return surface


class BadFiles(ProgramTest):
    def assert_input_refused(self, content, *words):
        path = self.file(content)
        for command in (["info"], ["plan", *PLAN]):
            done = endmill(command[0], path, *command[1:], cwd=self.folder)
            self.assert_refused(done, 3, "surface.json", *words)
        self.assert_nothing_left("surface.json")

    def test_syntax_error_is_refused_with_its_place(self):
        self.assert_input_refused('{"format": "endmill-surface/1",\n "type": bezier}', ":2:10: invalid literal")

    def test_empty_and_blank_files_are_refused(self):
        self.assert_input_refused("", "file is empty")
        self.assert_input_refused(" \n\t", "file is empty")

    def test_compressed_file_is_refused(self):
        self.assert_input_refused(b"\x1f\x8b\x08\x00more", "compressed input is not accepted")

    def test_file_of_another_format_is_refused_by_name(self):
        self.assert_input_refused("solid x\nfacet normal 0 0 1\n", "looks like STL", "endmill-surface/1")

    def test_duplicate_key_is_refused(self):
        text = json.dumps(plane()).replace('"patches_u": 1', '"patches_u": 1, "patches_u": 1')
        self.assert_input_refused(text, 'duplicate key "patches_u"')

    def test_unknown_key_is_refused_with_a_suggestion(self):
        self.assert_input_refused(changed(patches_w=1), "/patches_w: unknown key", 'did you mean "patches_u"?')

    def test_missing_key_is_refused(self):
        self.assert_input_refused(changed(patches_v=None), 'key "patches_v" is missing')

    def test_wrong_types_and_ranges_are_refused(self):
        shown = (("1", '"1"'), (-1, "-1"), (0, "0"), (2.9, "2.9"), (1.0, "1.0"), (None, "null"),
                 ([], "an array of 0"), (True, "true"), (10**30, "1e+30"), (1e300, "1e+300"))
        for value, found in shown:
            surface = plane()
            surface["patches_u"] = value
            self.assert_input_refused(surface, f"/patches_u: {found}; expected a whole number from 1 to 10000")

    def test_invalid_numbers_are_refused(self):
        before, after = json.dumps(with_point("HERE"), indent=1).split('"HERE"')
        line, point = before.count("\n") + 1, "/control_points/2/1"
        for text, *words in (("NaN", f":{line}:", " NaN is not a JSON number; expected a finite number"),
                             ("Infinity", f":{line}:", " Infinity is not a JSON number; expected a finite"),
                             ("-Infinity", f":{line}:", " -Infinity is not a JSON number; expected a finite"),
                             ("1e999", f":{line}:", "overflow", "'1e999'"),
                             ("0x10", f":{line}:", "invalid literal"),
                             ("1e-999", f"{point}/0: 1e-999 underflows to zero"),
                             ('"1"', f'{point}/0: "1"; expected a number'),
                             ("null", f"{point}/0: null; expected a number"),
                             ("1,5", f"{point}: a point of 4 numbers; expected 3")):
            self.assert_input_refused(f"{before}[{text}, 0, 0]{after}", *words)

    def test_huge_coordinate_is_refused_unless_max_extent_allows_it(self):
        self.assert_input_refused(with_point([1e7, 0, 0]),
                                  "/control_points/2/1/0: coordinate 10000000.0", "--max-extent")
        self.assertEqual(endmill("info", self.folder / "surface.json", "--max-extent", "1e8").returncode, 0)

    def test_wrong_counts_of_points_are_refused(self):
        ragged = plane()
        ragged["control_points"][1].pop()
        self.assert_input_refused(ragged, "/control_points/1: row has 3 points; expected 4")
        short = plane()
        short["control_points"].pop()
        self.assert_input_refused(short, "/control_points: net has 3 rows; expected 4")
        self.assert_input_refused(with_point([1, 2]), "/control_points/2/1: a point of 2 numbers; expected 3")

    def test_huge_declared_size_is_refused(self):
        self.assert_input_refused(changed(patches_u=10000, patches_v=10000),
                                  "/control_points: net has 4 rows; expected 30001")
        self.assert_input_refused(changed(patches_u=2**62), f"/patches_u: {2**62}; expected")

    def test_deep_nesting_and_bad_utf8_are_refused(self):
        self.assert_input_refused("[" * 100_000 + "]" * 100_000, ":1:65: nested deeper than 64")
        text = json.dumps(plane()).replace("a test", "a \xff")
        column = text.index("\xff") + 1
        self.assert_input_refused(text.encode("latin-1"), f":1:{column}: ", "ill-formed UTF-8")

    def test_net_of_equal_points_is_refused(self):
        surface = plane(size=(0, 0))
        self.assert_input_refused(surface, "/control_points: all control points are equal")

    def test_newer_format_is_refused(self):
        self.assert_input_refused(changed(format="endmill-surface/2"), "/format: ", "a newer version",
                                  "endmill-surface/1")

    def test_missing_file_and_directory_are_refused(self):
        self.assert_refused(endmill("info", self.folder / "none.json"), 3, "none.json", "No such file")
        self.assert_refused(endmill("info", self.folder), 3, str(self.folder), "is a directory; expected a file")

    def test_pipe_is_refused_and_does_not_hang(self):
        os.mkfifo(self.folder / "pipe.json")
        self.assert_refused(endmill("info", self.folder / "pipe.json"), 3, "pipe.json: is a device or a pipe")

    def test_control_characters_of_a_file_do_not_reach_the_terminal(self):
        done = endmill("info", self.file(changed(**{"\x1b[31mkey": 1})))
        self.assert_refused(done, 3, "surface.json:/[31mkey: unknown key")
        self.assertNotIn("\x1b", done.stderr)

    def test_json_errors_are_objects_with_code_and_place(self):
        done = endmill("info", self.file(changed(patches_u=-1)), "--json-errors")
        error = json.loads(done.stderr)["error"]
        self.assertEqual((error["code"], error["place"], error["exit"]), ("E_JSON", "/patches_u", 3))
        done = endmill("plan", "x", "--unknown", "--json-errors")
        self.assertEqual(json.loads(done.stderr)["error"]["code"], "E_PARAM")


class AnotherUser(ProgramTest):
    """Permission errors. Root passes permission checks, so these tests run as another user."""

    def setUp(self):
        super().setUp()
        self.program = shutil.copy(ENDMILL, self.folder / "endmill")
        self.user = {"user": "nobody", "group": "nogroup", "extra_groups": []} if os.geteuid() == 0 else {}
        self.folder.chmod(0o755)

    def run_as_user(self, *arguments):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True,
                              check=False, timeout=600, cwd=self.folder, **self.user)

    def test_file_without_read_permission_is_refused(self):
        path = self.file(plane())
        path.chmod(0o000)
        self.assert_refused(self.run_as_user("info", path), 3, "surface.json: cannot open: permission denied")

    def test_folder_without_write_permission_is_refused(self):
        path = self.file(plane())
        (self.folder / "locked").mkdir(mode=0o555)
        for target in ("locked", "locked/new"):
            done = self.run_as_user("plan", path, *PLAN[:-1], target)
            self.assert_refused(done, 5, f"output folder {target}: Permission denied")
        self.assert_nothing_left("endmill", "locked", "surface.json")


class BadArguments(ProgramTest):
    def refused(self, status, *arguments, words=()):
        done = endmill("plan", self.file(plane()), *arguments, "-o", "out", cwd=self.folder)
        self.assert_refused(done, status, *words)
        self.assert_nothing_left("surface.json")

    def test_numbers_outside_their_domain_are_refused(self):
        for cutters, expected in ((("ball:0", "ball:-1"), "a diameter above 0 mm"),
                                  (("ball", "ball:", "ball:nan", "ball:1:2", "x"), "ball:DIAMETER, flat:DIAMETER or bull:"),
                                  (("ball:10mm",), "numbers in mm without a unit, as in ball:10")):
            for cutter in cutters:
                self.refused(2, "--cutter", cutter, words=[f'--cutter: found "{cutter}"; expected ', expected])
        for option in ("--chord-tolerance", "--scallop", "--feed", "--cross-step", "--max-memory"):
            for number in ("0", "-1", "nan", "inf", "1e999", "", "1,5", "0x10", "1 "):
                self.refused(2, option, number, words=[f'{option}: found "{number}"; expected a number above 0'])
        for cutter in ("flat:3", "bull:10:2"):
            self.refused(2, "--cutter", cutter, "--strategy", "iso",
                         words=[f"--cutter {cutter} with --strategy iso: expected ball:DIAMETER, or --strategy planar"])
        self.refused(2, "--cutter", "ball:10", "--scallop", "10", words=["--scallop 10: expected ", "10 mm"])
        self.refused(2, "--threads", "0", words=['--threads: found "0"; expected a whole number from 1 to 1024'])
        self.refused(2, "--safe-height", "nan", words=['--safe-height: found "nan"; expected a number'])

    def test_numbers_beyond_every_machine_are_refused(self):
        for option in ("--chord-tolerance", "--scallop", "--feed", "--cross-step"):
            for number in ("1e300", "1.01e9"):
                self.refused(2, option, number, words=[f'{option}: found "{number}"; expected a number above 0, at most'])
        for option in ("--inner-tolerance", "--outer-tolerance"):
            for number in ("1e300", "1.01e9", "-1", "-1e-9", "nan", "inf", ""):
                self.refused(2, option, number, words=[f'{option}: found "{number}"; expected a number from 0 to'])
        for number in ("1e300", "-1000001"):
            self.refused(2, "--safe-height", number, words=["--safe-height: found ", "at most 1e+06 mm (--max-extent)"])
        self.refused(2, "--safe-height", "11", "--max-extent", "10", words=["at most 10 mm (--max-extent)"])
        path, part = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n1,0,0\n", "p.csv"), self.file(plane())
        for arguments, words in ((("post", path, "--feed", "1e300"), '--feed: found "1e300"'),
                                 (("post", path, "--feed", "9", "--spindle-rpm", "1e10"), '--spindle-rpm: found "1e10"'),
                                 (("post", path, "--feed", "9", "--safe-height", "1e300"), "--safe-height: found "),
                                 (("trim", part, "--cutter", "ball:9", "--safe-height", "-1e7"), "--safe-height: found "),
                                 (("trim", part, "--cutter", "ball:9", "--pitch", "1e300"), '--pitch: found "1e300"'),
                                 (("trim", part, "--cutter", "ball:9", "--allowance", "1e10"), "--allowance: found "),
                                 (("verify", path, "--cutter", "ball:9", "--resolution", "1e300"), "--resolution: found ")):
            self.assert_refused(endmill(*arguments, "-o", "out", cwd=self.folder), 2, words)
            self.assert_nothing_left("p.csv", "surface.json")

    def test_unknown_words_are_refused_with_the_known_ones(self):
        self.refused(2, "--governing", "minn", words=['--governing: found "minn"', 'did you mean "min"?'])
        self.refused(2, "--mode", "exact", words=['--mode: found "exact"; expected "verified" or "paper"'])
        self.refused(2, "--cutter", "ball:10", "--mode", "verified", "--inner-tolerance", "5",
                     words=["--inner-tolerance 5: expected ", "5 mm"])
        self.refused(2, "--outer-tolerance", "0", "--inner-tolerance", "0",
                     words=["--inner-tolerance 0 with --outer-tolerance 0", "one of the two above 0"])
        for option in ("--inner-tolerance", "--outer-tolerance"):
            self.refused(2, option, "0", "--mode", "paper", words=[f"{option} 0: --mode paper", "expected --mode verified"])
        self.refused(2, "--cutter", "ball:10", "--inner-tolerance", "0", "--outer-tolerance", "5",
                     words=["--outer-tolerance 5: expected ", "5 mm, with --inner-tolerance 0"])
        self.refused(2, "--require", "g2", words=['--require: found "g2"; expected "g1"'])
        self.refused(2, "--axis", "0,0,0", words=['--axis: found "0,0,0"; expected a vector that is not zero'])
        self.refused(2, "--axis", "0,1", words=['--axis: found "0,1"; expected three numbers X,Y,Z'])
        self.refused(2, "--scalop", "1", words=['found "--scalop"', "did you mean --scallop?"])

    def test_ball_larger_than_the_limit_is_refused(self):
        done = endmill("plan", SURFACES / "parabolic-cylinder.json", "--cutter", "ball:40", cwd=self.folder)
        self.assert_refused(done, 4, "parabolic-cylinder.json", "--cutter ball:40: found radius 20 mm",
                            "smaller radius than the limit of the surface, 20 mm",
                            "u = ", "v = 1 ")
        self.assert_nothing_left()

    def test_axis_from_which_the_part_is_unreachable_is_refused(self):
        self.refused(4, "--axis", "1,0,0", words=["surface.json", "u = 0, v = 0 ", "normal . axis = 0; expected"])

    def test_overhang_is_refused_with_its_place(self):
        surface = plane(size=(60, 30))
        for row in surface["control_points"]:
            row[1][0], row[2][0] = 70, -10
        done = endmill("plan", self.file(surface), *PLAN, cwd=self.folder)
        self.assert_refused(done, 4, "surface.json", "cannot touch the surface at u = 0.5, ", "normal . axis = -1;")

    def test_degenerate_normals_are_refused_with_their_place(self):
        surface = plane()
        for row in surface["control_points"]:
            for i, point in enumerate(row):
                point[:] = [i, i, 0]
        done = endmill("plan", self.file(surface), *PLAN, cwd=self.folder)
        self.assert_refused(done, 4, "surface.json", "no normal at u = 0, v = 0 ")

    def test_g0_surface_gives_a_warning_with_the_place(self):
        surface = plane(patches_u=2)
        for row in surface["control_points"]:
            row[3][2] = 3
            row[2][2] = row[4][2] = 2
            row[1][2] = row[5][2] = 1
        path = self.file(surface)
        done = endmill("plan", path, *PLAN, "--direction", "u", cwd=self.folder)
        self.assertTrue((self.folder / "out/toolpath.csv").is_file(), done.stderr)
        self.assertIn("warning", done.stderr)
        self.assertNotIn("--require", done.stderr)
        self.assertIn("u = 1,", done.stderr)
        done = endmill("plan", path, *PLAN[:-1], "out2", "--require", "g1", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("--require g1 is not met: patches meet with a break of ", done.stderr)
        self.assertIn("u = 1,", done.stderr)
        self.assertFalse((self.folder / "out2").exists())


class Output(ProgramTest):
    def test_folder_that_is_not_empty_is_kept(self):
        path = self.file(plane())
        (self.folder / "out").mkdir()
        (self.folder / "out/mine.txt").write_text("mine")
        self.assert_refused(endmill("plan", path, *PLAN, cwd=self.folder), 2, "out is not empty", "--force")
        self.assertEqual(os.listdir(self.folder / "out"), ["mine.txt"])

    def test_file_in_place_of_the_output_folder_is_kept(self):
        path = self.file(plane())
        self.file("mine", "out")
        self.assert_refused(endmill("plan", path, *PLAN, cwd=self.folder), 2, "output folder out is a file")
        self.assertEqual((self.folder / "out").read_text(), "mine")

    def test_full_disk_leaves_nothing(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
        done = endmill("plan", SURFACES / "net_rot24_7D.json", "--mode", "paper", "-o", "out", cwd=self.folder,
                       preexec_fn=limit)
        self.assert_refused(done, 5, "out/u/toolpath.csv: File too large")
        self.assert_nothing_left()

    def test_full_standard_output_exits_5(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([ENDMILL, "info", SURFACES / "plane.json", "--json"], stdout=full,
                                  stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 5)
        self.assertIn("standard output", done.stderr)

    def test_too_many_points_are_refused_before_planning(self):
        done = endmill("plan", SURFACES / "net_rot24_7D.json", "--strategy", "iso", "--chord-tolerance", "1e-9", "-o", "out",
                       cwd=self.folder)
        self.assert_refused(done, 6, "CL points would need about", "GiB", "--max-memory")
        self.assert_nothing_left()

    def test_interrupt_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen([ENDMILL, "plan", SURFACES / "net_rot24_7D.json", "--strategy", "iso", "--chord-tolerance", "5e-4",
                                   "-o", "out"], cwd=self.folder, stderr=subprocess.PIPE,
                                  stdout=subprocess.PIPE) as process:
                while not list(self.folder.glob(".endmill-*")) and process.poll() is None:
                    time.sleep(0.01)
                process.send_signal(number)
                process.communicate(timeout=600)
            self.assertEqual(process.returncode, 128 + number)
            self.assert_nothing_left()

    def test_the_end_of_the_processor_time_leaves_nothing(self):
        """Also a hard limit, at which the system kills."""
        for limit in ((1, 1), (1, resource.RLIM_INFINITY)):
            with self.subTest(limit=limit):
                done = endmill("plan", SURFACES / "net_rot24_7D.json", "--strategy", "iso", "--chord-tolerance", "5e-4", "-o", "out",
                               cwd=self.folder, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, limit))
                self.assertEqual(done.returncode, 128 + signal.SIGXCPU, done.stderr)
                self.assert_nothing_left()


if __name__ == "__main__":
    unittest.main()
