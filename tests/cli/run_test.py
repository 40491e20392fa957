# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill run and demo: the chain of a job, what is repeated, and what survives an interruption.

The test of interruptions kills 6 runs at random instants, with ENDMILL_FAULTS=long 100 runs.
"""
import json
import os
import random
import re
import shutil
import signal
import subprocess
import time
import unittest

from program import ENDMILL, ROOT, ProgramTest, endmill, plane

JOBS = ROOT / "datasets/jobs"
KILLS = 100 if os.environ.get("ENDMILL_FAULTS") == "long" else 6
MEASURED = re.compile(r'"(\w+_m?s)": [-+.e\d]+')  # a measured time in JSON


def content(folder):
    """Every file below a folder, with measured times replaced."""
    files = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            text = path.read_bytes()
            if path.suffix == ".json":
                text = MEASURED.sub(r'"\1": 0', text.decode()).encode()
            files[str(path.relative_to(folder))] = text
    return files


class RunTest(ProgramTest):
    def job(self, **keys):
        """A job over a small plane, with these keys beside."""
        self.file(plane(), "plane.json")
        return self.file({"format": "endmill-job/1", "name": "small", "part": {"file": "plane.json"},
                          "tool": "ball:10", "tolerances": {"scallop_mm": 0.5},
                          "feed_mm_per_min": 800, "plan": {"bound": "none"}, "verify": {"resolution": 1},
                          **keys}, "small-job.json")

    def run_job(self, *arguments, status=0, **keys):
        return self.summary("run", self.job(**keys), "-o", "out", *arguments, status=status)

    def states(self, summary):
        return {step: told["state"] for step, told in summary["steps"].items()}


class Chain(RunTest):
    def test_a_path_and_a_program_come_out(self):
        summary = self.run_job(spindle_rpm=6000)
        self.assertEqual(self.states(summary), {
            "setup": "not needed", "plan": "done", "trim": "not needed", "feed": "not needed", "verify": "done",
            "clamp": "not needed", "post": "done"})
        program = (self.folder / "out/07-post/toolpath.ngc").read_text()
        self.assertIn("F800", program)
        self.assertIn("S6000", program)
        verdict = json.loads((self.folder / "out/05-verify/summary.json").read_text())["verdict"]
        self.assertEqual(verdict, "clean")

    def test_a_step_writes_the_same_files_as_its_command(self):
        self.run_job()
        record = json.loads((self.folder / "out/job.json").read_text())["steps"]["plan"]
        done = endmill(*record["command"], "-o", "by-hand", cwd=self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(content(self.folder / "out/by-hand"), content(self.folder / "out/02-plan"))

    def test_nothing_is_repeated_until_something_changes(self):
        self.run_job()
        before = content(self.folder / "out")
        self.assertEqual(set(self.states(self.run_job()).values()), {"up to date", "not needed"})
        again = self.states(self.run_job("--set", "verify.resolution=2"))
        self.assertEqual((again["plan"], again["verify"], again["post"]), ("up to date", "done", "up to date"))
        self.run_job()
        after = content(self.folder / "out")
        del before["job.json"], after["job.json"]
        self.assertEqual(after, before)

    def test_a_dry_run_says_why(self):
        summary = self.run_job("--dry-run")
        self.assertEqual(summary["steps"]["plan"]["reason"], "there is no earlier run")
        self.assertFalse((self.folder / "out").exists())
        self.run_job()
        summary = self.run_job("--dry-run", "--set", "plan.scallop=0.4")
        self.assertEqual(summary["steps"]["plan"], {"state": "would run", "reason": "its options have changed"})

    def test_a_path_in_doubt_gets_no_program(self):
        job = self.job(plan={"mode": "paper", "direction": "u"}, verify={"resolution": 1, "tolerance": 0.001},
                       tolerances={"chord_mm": 0.05})
        shutil.copy(ROOT / "datasets/surfaces/wavy.json", self.folder / "plane.json")
        done = endmill("run", job, "-o", "out", "--quiet", "--set", "tool=ball:6", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"error: (plan|verify): .*accept_no")
        self.assertFalse((self.folder / "out/07-post").exists())

    def test_a_program_does_not_outlive_the_verdict_on_its_path(self):
        self.run_job()
        self.assertTrue((self.folder / "out/07-post").exists())
        stricter = ("--set", "tolerances.scallop_mm=0.6", "--set", "verify.scallop=0.0001")
        self.assertEqual(endmill("run", self.job(), "-o", "out", *stricter, cwd=self.folder).returncode, 1)
        self.assertFalse((self.folder / "out/07-post").exists())
        done = endmill("run", self.job(), "-o", "out", "--only", "post", *stricter, cwd=self.folder)
        self.assert_refused(done, 2, "the step verify failed")

    def test_a_dry_run_leaves_out_what_is_not_needed(self):
        states = self.states(self.run_job("--dry-run"))
        self.assertEqual(states, {"setup": "not needed", "plan": "would run", "trim": "not needed",
                                  "feed": "not needed", "verify": "would run", "clamp": "not needed",
                                  "post": "would run"})

    def test_progress_for_programs_is_json(self):
        done = endmill("run", self.job(), "-o", "out", "--json-progress", cwd=self.folder)
        lines = [json.loads(line)["progress"] for line in done.stderr.splitlines() if line.startswith("{")]
        ended = [line["step"] for line in lines if line.get("state") == "done"]
        self.assertEqual(ended, ["plan", "verify", "post"])
        self.assertEqual([line["step"] for line in lines if line.get("state") == "not needed"],
                         ["setup", "trim", "feed", "clamp"])
        done = endmill("run", self.job(), "-o", "other", cwd=self.folder)
        self.assertRegex(done.stderr, r"(?m)^endmill: 02-plan: done in \d+\.\d s")

    def test_every_delivered_job_is_read(self):
        for job in sorted(JOBS.glob("*.json")):
            with self.subTest(job=job.name):
                summary = self.summary("run", job, "-o", "out", "--dry-run")
                self.assertIn("would run", self.states(summary).values())

    def test_the_demo_ends_with_a_picture_and_a_program(self):
        done = endmill("demo", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("picture of the path", "picture of the remaining stock", "G-code"):
            name = re.search(rf"^{word}: (.+)$", done.stdout, re.M).group(1)
            self.assertGreater((self.folder / name).stat().st_size, 1000)
        picture = re.search(r"^picture of the path: (.+)$", done.stdout, re.M).group(1)
        posted = json.loads((self.folder / "endmill-demo/job.json").read_text())["steps"]["post"]["command"][1]
        self.assertEqual(os.path.dirname(picture), "endmill-demo/" + os.path.dirname(posted))


class BadInput(RunTest):
    def refused(self, status, *words, arguments=(), **keys):
        self.assert_refused(endmill("run", self.job(**keys), "-o", "out", *arguments, cwd=self.folder), status, *words)

    def test_keys_and_values_are_read_strictly(self):
        self.refused(3, "small-job.json", "tolerance", 'did you mean "tolerances"?', tolerance=1)
        self.refused(3, "/plan", "scalop", 'did you mean "scallop"?', plan={"scalop": 1})
        self.refused(3, "/part/file", "none.stl, which does not exist", part={"file": "none.stl"})
        self.refused(3, "/verify", "expected true, false or an object", verify=3)
        self.refused(3, "/feed_mm_per_min", "true; expected a number", feed_mm_per_min=True)
        self.refused(3, "/feed_mm_per_min", feed_mm_per_min=0)
        self.refused(3, "/control", "fanukk", 'did you mean "fanuc"?', control="fanukk")
        self.refused(3, "/plan/strategy", 'did you mean "planar"?', plan={"strategy": "planer"})
        self.refused(3, "/part/file", ", which is no file; expected a file", part={"file": "."})
        self.refused(3, "/part/file", "an empty name", part={"file": ""})
        self.refused(3, "/trim", "polyline", trim={"polyline": "plane.json"})
        self.refused(2, "--set", "KEY=VALUE", arguments=("--set", "plan"))
        self.refused(2, "--from and --only", arguments=("--from", "plan", "--only", "post"))
        self.assert_nothing_left("plane.json", "small-job.json")

    def test_every_option_that_names_a_file_is_one(self):
        """Its content counts for what is up to date, so that it must exist when the job is read."""
        for step, keys in {"setup": ("skip_facets", "tool"), "plan": ("protect", "skip_facets", "tool"),
                           "feed": ("material", "tool", "tools", "part"),
                           "verify": ("part", "protect", "skip_facets", "tool", "tools"),
                           "post": ("tools", "tool")}.items():
            for key in keys:
                with self.subTest(step=step, key=key):
                    self.refused(3, f"/{step}/{key}", "none.json, which does not exist", **{step: {key: "none.json"}})

    def test_a_folder_of_another_origin_is_kept(self):
        (self.folder / "out").mkdir()
        (self.folder / "out/letter.txt").write_text("Dear")
        self.refused(2, "out is not empty and has no job.json that a run wrote")
        self.assertEqual(os.listdir(self.folder / "out"), ["letter.txt"])

    def test_a_job_json_of_another_origin_is_kept(self):
        (self.folder / "out/02-plan").mkdir(parents=True)
        for name in ("job.json", "02-plan/mine.txt"):
            (self.folder / "out" / name).write_text("{}")
        self.refused(2, "has no job.json that a run wrote")
        self.refused(2, "02-plan exists and is of no run of a job", arguments=("--force", "--quiet"))
        self.assertEqual((self.folder / "out/02-plan/mine.txt").read_text(), "{}")

    def test_a_wrong_value_names_its_key(self):
        self.refused(2, "error: plan: --scallop: ", "(plan.scallop in ", arguments=("--quiet",),
                     plan={"scallop": "abc"})

    def test_a_job_without_a_path(self):
        done = endmill("run", self.job(plan=False), "-o", "out", "--only", "verify", cwd=self.folder)
        self.assert_refused(done, 2, "--only verify", "there is no path")

    def test_files_that_depend_on_each_other_are_refused(self):
        done = endmill("run", self.job(), "-o", ".", "--force", cwd=self.folder)
        self.assert_refused(done, 2, "is in this folder for its results")

    def test_a_part_that_a_step_refuses(self):
        job = self.job(plan={"strategy": "iso"})
        (self.folder / "plane.json").write_text("{}")
        done = endmill("run", job, "-o", "out", "--quiet", cwd=self.folder)
        self.assert_refused(done, 3, "error: plan: ", "plane.json")
        record = json.loads((self.folder / "out/job.json").read_text())
        self.assertEqual(record["steps"]["plan"]["state"], "failed")
        self.assertEqual(record["steps"]["post"]["state"], "not run")
        done = endmill("run", job, "-o", "out", "--quiet", "--json-errors", cwd=self.folder)
        self.assertEqual(json.loads(done.stderr)["error"]["exit"], 3)

    def test_nothing_of_a_job_reaches_a_shell(self):
        self.refused(2, "error: plan: ", arguments=("--quiet",), plan={"cutter": "$(touch hacked); `touch hacked`"})
        self.assertFalse((self.folder / "hacked").exists())


class Interruption(RunTest):
    def start(self, job):
        return subprocess.Popen([ENDMILL, "run", job, "-o", "out", "--quiet"], cwd=self.folder,
                                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def slow_job(self):
        return self.job(plan={"bound": "none", "strategy": "planar"}, verify={"resolution": 0.5},
                        tolerances={"scallop_mm": 0.1})

    def test_a_second_run_names_the_first_one(self):
        job = self.slow_job()
        with self.start(job) as first:
            try:
                while not (self.folder / "out/.endmill-lock").exists() or \
                        not (self.folder / "out/.endmill-lock").read_text():
                    time.sleep(0.001)
                first.send_signal(signal.SIGSTOP)
                done = endmill("run", job, "-o", "out", cwd=self.folder)
                self.assert_refused(done, 5, f"process {first.pid}")
            finally:
                first.kill()
        self.assertEqual(endmill("run", job, "-o", "out", cwd=self.folder).returncode, 0)

    def test_an_interrupted_run_ends_its_step(self):
        with self.start(self.slow_job()) as process:
            while not (self.folder / "out/job.json").exists():
                time.sleep(0.001)
            process.terminate()
            self.assertEqual(process.wait(timeout=60), 143)
        time.sleep(0.1)
        self.assertFalse((self.folder / "out/02-plan").exists())

    def test_a_killed_run_goes_on_to_the_same_bytes(self):
        job = self.slow_job()
        start = time.monotonic()
        self.assertEqual(endmill("run", job, "-o", "out", cwd=self.folder).returncode, 0)
        duration = time.monotonic() - start
        whole = content(self.folder / "out")
        chance = random.Random(7)
        for kill in range(KILLS):
            shutil.rmtree(self.folder / "out")
            for _ in range(chance.randint(1, 3)):  # the run that goes on may be killed too
                with self.start(job) as process:
                    time.sleep(chance.random() * 1.1 * duration)
                    process.kill()
                    process.wait()
            done = endmill("run", job, "-o", "out", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            again = content(self.folder / "out")
            # A run that was killed after its end leaves only what is up to date.
            again["job.json"] = again["job.json"].replace(b'"up to date"', b'"done"')
            self.assertEqual(again.keys(), whole.keys(), f"kill {kill}")
            for name in whole:
                self.assertEqual(again[name], whole[name], f"kill {kill}: {name}")


if __name__ == "__main__":
    unittest.main()
