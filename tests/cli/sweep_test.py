# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill sweep: the same results whatever ran when, after any interruption, and from shards; errors of plans and
limits of cases. With ENDMILL_FAULTS=long the sweep is killed 100 times, else 20 times."""
import csv
import errno
import hashlib
import json
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from program import ENDMILL, ROOT, ProgramTest, endmill

IS_LONG = os.environ.get("ENDMILL_FAULTS") == "long"
KILLS = 100 if IS_LONG else 20
LIBRARY = os.environ.get("ENDMILL_FAILING_CALLS", "")
STEEL = ROOT / "datasets/materials/steel.json"
NET = ROOT / "datasets/surfaces/net_rot24_7D.json"
FIXED = {"material": str(STEEL), "flutes": 2, "lambda_deg": 20, "pick_feed_ratio": 0.5}


def share(seed, key, case):
    """The documented rule of random values."""
    return (int.from_bytes(hashlib.sha256(f"{seed}/{key}/{case}".encode()).digest()[:8], "big") >> 11) / 2**53


class SweepTest(ProgramTest):
    def plan(self, name="plan.json", **keys):
        whole = {"format": "endmill-sweep/1", "command": "coefficients", "options": FIXED, **keys}
        return self.file({key: value for key, value in whole.items() if value is not None}, name)

    def small_plan(self, count=30, **keys):
        """Fast cases, some of which fail: a depth ratio above 2 is refused."""
        return self.plan(random={"count": count, "seed": 5, "parameters": {
            "cutter": {"one_of": ["ball:10", "ball:6", "ball:x"]}, "depth_ratio": {"from": 0.1, "to": 1},
            "feed_per_tooth": {"from": 0.01, "to": 0.1, "scale": "log"}, "mu_deg": {"from": 0, "to": 30, "whole": True}}},
            columns=["torque_n_m"], **keys)

    def sweep(self, plan, folder, *options, status=0, **settings):
        done = endmill("sweep", plan, "-o", self.folder / folder, *options, cwd=self.folder, **settings)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def rows(self, folder):
        with open(self.folder / folder / "results.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def results(self, folder):
        """The content of the results without times, and the names of the files."""
        place = self.folder / folder
        lines = (place / "results.csv").read_bytes().splitlines()
        facts = json.loads((place / "sweep.json").read_text())
        del facts["wall_s"]
        return [line.rpartition(b",")[0] for line in lines], facts, sorted(path.name for path in place.iterdir())

    def test_results_do_not_depend_on_jobs_and_shards(self):
        plan = self.small_plan()
        self.sweep(plan, "one")
        expected = self.results("one")
        self.assertEqual(expected[2], ["results.csv", "sweep.json"])
        self.assertEqual(len(expected[0]), 31)
        self.assertEqual(len({row["exit_code"] for row in self.rows("one")}), 2)
        for jobs in (2, 4):
            self.sweep(plan, f"jobs-{jobs}", "--jobs", jobs)
            self.assertEqual(self.results(f"jobs-{jobs}"), expected)
        for shard in (1, 2, 3):
            self.sweep(plan, f"shard-{shard}", "--shard", f"{shard}/3", "--jobs", 2)
        done = endmill("sweep", "--merge", "shard-2", "shard-3", "shard-1", "-o", "whole", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.results("whole"), expected)

    def test_values_follow_the_documented_rule(self):
        self.sweep(self.small_plan(count=5), "results")
        for number, row in enumerate(self.rows("results")):
            self.assertEqual(row["case"], str(number))
            self.assertEqual(row["cutter"], ["ball:10", "ball:6", "ball:x"][int(3 * share(5, "cutter", number))])
            self.assertEqual(float(row["depth_ratio"]), 0.1 + 0.9 * share(5, "depth_ratio", number))
            self.assertEqual(int(row["mu_deg"]), math.floor(31 * share(5, "mu_deg", number)))
            self.assertAlmostEqual(float(row["feed_per_tooth"]), 0.01 * 10 ** share(5, "feed_per_tooth", number),
                                   delta=1e-14)

    def test_a_case_is_the_command(self):
        self.sweep(self.small_plan(count=8), "results", "--keep", "all")
        for row in self.rows("results"):
            case = json.loads((self.folder / f"results/cases/{int(row['case']):07}/case.json").read_text())
            done = endmill(*case["arguments"], "--json", cwd=self.folder)
            self.assertEqual(str(done.returncode), row["exit_code"])
            if row["exit_code"] == "0":
                self.assertEqual(json.loads(done.stdout)["torque_n_m"], float(row["torque_n_m"]))
            else:
                self.assertEqual(json.loads(done.stderr)["error"]["message"], row["message"])
                self.assertEqual(row["torque_n_m"], "")

    def test_inputs_and_lists(self):
        for name, length in (("a", 10), ("b", 20)):
            self.file({"format": "endmill-surface/1", "name": name, "source": "a test", "type": "bezier", "patches_u": 1,
                       "patches_v": 1, "control_points": [[[length * i / 3, j, 0] for i in range(4)]
                                                          for j in range(4)]}, f"{name}.json")
        self.file("input,max_extent\na.json,\nb.json,100\nb.json,15\n", "cases.csv")
        plan = self.plan(command="info", options=None, list="cases.csv", columns=["size_mm.0", "continuity"])
        self.sweep(plan, "results")
        rows = self.rows("results")
        self.assertEqual([row["size_mm.0"] for row in rows], ["10", "20", ""])
        self.assertEqual([row["exit_code"] for row in rows], ["0", "0", "3"])
        self.assertEqual(rows[0]["max_extent"], "")

    def test_the_folder_of_a_kept_case_can_be_used(self):
        """Its files name others relative to themselves. Commands look for these where the case has moved to."""
        shutil.copy(NET, self.folder / "net.json")
        plan = self.plan(command="plan", input="net.json", options={"cutter": "ball:20"}, grid=[{"scallop": [2]}])
        self.sweep(plan, "kept", "--keep", "all")
        case = self.folder / "kept/cases/0000000"
        self.assertFalse(list((self.folder / "kept").glob(".endmill*")))
        part = json.loads((case / "summary.json").read_text())["part"]
        self.assertEqual((case / part).resolve(), (self.folder / "net.json").resolve())
        done = endmill("verify", case / "toolpath.csv", "--resolution", 1, "-o", "verified", cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)

    def test_killed_sweeps_go_on(self):
        plan = self.small_plan(count=40)
        start = time.monotonic()
        self.sweep(plan, "sound", "--jobs", 2, "--keep", "failed")
        duration = time.monotonic() - start
        expected = self.results("sound")
        chance = random.Random(1)
        interrupted = 0
        for number in range(KILLS):
            shutil.rmtree(self.folder / "killed", ignore_errors=True)
            command = [ENDMILL, "sweep", plan, "-o", self.folder / "killed", "--jobs", "2", "--keep", "failed", "--quiet",
                       "--resume"]
            with subprocess.Popen(command, stdin=subprocess.DEVNULL, cwd=self.folder) as process:
                time.sleep(chance.uniform(0, duration))
                process.send_signal(chance.choice((signal.SIGKILL, signal.SIGKILL, signal.SIGTERM)))
                status = process.wait()
            interrupted += status != 0
            self.assertIn(status, (0, -signal.SIGKILL, 128 + signal.SIGTERM), number)
            self.sweep(plan, "killed", "--resume", "--jobs", 2, "--keep", "failed")
            self.assertEqual(self.results("killed"), expected, number)
            self.assertEqual(self.cases("killed"), self.cases("sound"), number)
        self.assertGreater(interrupted, KILLS / 2)

    def cases(self, folder):
        """The content of the folders of cases."""
        return {path.relative_to(self.folder / folder): path.read_bytes().replace(folder.encode(), b"F")
                for path in (self.folder / folder).rglob("case.json")}

    def test_folder_with_results(self):
        plan = self.small_plan(count=3)
        self.sweep(plan, "results")
        self.assert_refused(self.sweep(plan, "results", status=2), 2,
                            "results has the results of this plan; expected --resume, or a new folder")
        before = self.results("results")
        self.assertIn("3 done before", self.sweep(plan, "results", "--resume").stdout)
        self.assertEqual(self.results("results"), before)
        other = self.small_plan(count=4)
        hashes = [hashlib.sha256(f"{before[1]['version']}\0".encode() + plan.read_bytes() + b"\0\0").hexdigest()]
        done = self.sweep(other, "results", "--resume", status=2)
        self.assert_refused(done, 2, "has results of another plan or version, with the hash " + before[1]["plan_sha256"],
                            "expected " + hashes[0])

    def test_limits_make_rows(self):
        plan = self.plan(command="plan", input=str(NET), options={"cutter": "ball:10"}, grid=[{"scallop": [0.001, 0.002]}])
        self.sweep(plan, "slow", "--limit-seconds", 0.2, "--jobs", 2)
        for row in self.rows("slow"):
            self.assertEqual((row["exit_code"], row["message"]),
                             ("6", "ended after 0.2 s; expected less time (--limit-seconds)"))
        self.sweep(plan, "big", "--limit-gib", 0.001, "--jobs", 2)
        for row in self.rows("big"):
            self.assertIn(row["exit_code"], ("6", "134", "139"), row)
            if row["exit_code"] == "6":
                self.assertIn("0.001 GiB", row["message"])

    def test_a_crash_is_a_row(self):
        """The case is killed from outside, as by the system for its memory."""
        plan = self.plan(command="plan", input=str(NET), options={"cutter": "ball:10"}, grid=[{"scallop": [0.001]}])
        with subprocess.Popen([ENDMILL, "sweep", plan, "-o", self.folder / "results", "--quiet"],
                              stdin=subprocess.DEVNULL) as process:
            children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
            for _ in range(1000):
                found = children.read_text().split()
                if found and b"plan" in Path(f"/proc/{found[0]}/cmdline").read_bytes():
                    break
                time.sleep(0.01)
            os.kill(int(found[0]), signal.SIGKILL)
            self.assertEqual(process.wait(), 0)
        self.assertEqual([(row["exit_code"], row["message"]) for row in self.rows("results")],
                         [("137", "ended by signal 9, as by the system if there is no memory")])

    def test_full_disk(self):
        """The journal meets the largest size of a file: the sweep stops as a whole, and goes on with more."""
        plan = self.small_plan(count=20)
        self.sweep(plan, "sound")
        done = self.sweep(plan, "full", status=5, preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (2048, 2048)))
        self.assertIn("File too large", done.stderr)
        self.assertFalse((self.folder / "full/results.csv").exists())
        self.sweep(plan, "full", "--resume")
        self.assertEqual(self.results("full"), self.results("sound"))

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("mount"), "mounting needs root")
    def test_full_file_system(self):
        place = self.folder / "small"
        place.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", place], check=False).returncode != 0:
            self.skipTest("no file system may be mounted")
        self.addCleanup(subprocess.run, ["umount", "-l", place], check=False)
        plan = self.small_plan(count=60)
        self.sweep(plan, "sound", "--keep", "all")
        done = self.sweep(plan, "small/results", "--keep", "all", status=5)
        self.assertIn(os.strerror(errno.ENOSPC), done.stderr)
        subprocess.run(["mount", "-o", "remount,size=4m", place], check=True)
        self.sweep(plan, "small/results", "--keep", "all", "--resume")
        self.assertEqual(self.results("small/results"), self.results("sound"))

    def test_nothing_is_given_to_a_shell(self):
        trap = self.folder / "trap"
        self.sweep(self.plan(options=None, grid=[{"cutter": [f"$(touch {trap})", f"; touch {trap}", f"`touch {trap}`"]}]),
                   "results")
        self.assertFalse(trap.exists())

    def test_two_sweeps_in_one_folder(self):
        plan = self.plan(command="plan", input=str(NET), options={"cutter": "ball:10"}, grid=[{"scallop": [0.001]}])
        with subprocess.Popen([ENDMILL, "sweep", plan, "-o", self.folder / "results", "--quiet"]) as process:
            while not (self.folder / "results/.endmill-journal.jsonl").exists():
                time.sleep(0.01)
            done = self.sweep(plan, "results", "--resume", status=5)
            self.assert_refused(done, 5, f"a sweep is at work in this folder, process {process.pid}")
            process.terminate()
            self.assertEqual(process.wait(), 143)

    def test_wrong_plans(self):
        grid = [{"mu_deg": [1]}]
        many = [{key: list(range(1000))} for key in ("mu_deg", "depth_ratio", "feed_per_tooth")]
        self.file("mu_deg\n1\n", "list.csv")
        for keys, message in (
                ({"grid": grid, "gird": 1}, '/gird: unknown key; expected "format"'),
                ({"grid": [{"mu_degg": [1]}]}, '/grid/0/mu_degg: unknown key "mu_degg"; expected'),
                ({"grid": [{"mu_degg": [1]}]}, 'did you mean "mu_deg"?'),
                ({"grid": many}, "/grid: a grid of 1000000000 cases; expected at most 10000000"),
                ({"grid": [{"mu_deg": [1, 2], "depth_ratio": [1]}]}, "/grid/0/mu_deg: 2 values; expected 1 as for"),
                ({"list": "plan.json"}, '/list: "plan.json", the plan itself; expected a CSV file'),
                ({"list": "none.csv"}, "none.csv"),
                ({"grid": grid, "list": "list.csv"}, "the keys grid and list; expected exactly one of grid, list"),
                ({"grid": grid, "command": "pln"}, '/command: "pln"; expected'),
                ({"grid": grid, "input": "x.json"}, '/input: unknown key "input"'),
                ({"grid": grid, "command": "info", "options": None, "input": "x.json"},
                 "/input: found " + str(self.folder / "x.json") + ", which does not exist; expected a file"),
                ({"grid": grid, "command": "info", "options": None, "input": "plan.json"}, "the plan itself"),
                ({"grid": [{"max_extent": [1]}], "command": "info", "options": None},
                 "no input; expected the key input with a file, or a parameter input")):
            with self.subTest(message):
                done = self.sweep(self.plan(**keys), "results", status=3)
                self.assert_refused(done, 3, message)
                self.assertFalse((self.folder / "results").exists())

    def test_a_job_that_names_the_plan(self):
        self.file({"format": "endmill-job/1", "part": {"file": "plan.json"}, "tool": "ball:10"}, "job.json")
        plan = self.plan(command="run", options=None, input="job.json", grid=[{"plan.scallop": [1]}])
        self.assert_refused(self.sweep(plan, "results", status=3), 3, "the plan itself")
        plan = self.plan(command="run", options=None, input="job.json", grid=[{"plan.scalop": [1]}])
        self.assert_refused(self.sweep(plan, "results", status=3), 3, 'did you mean "scallop"?')

    def job_plan(self, **keys):
        """A plan over a job."""
        shutil.copy(NET, self.folder / "net.json")
        self.file({"format": "endmill-job/1", "part": {"file": "net.json"}, "tool": "ball:10"}, "job.json")
        return self.plan(command="run", options=None, input="job.json", **keys)

    def test_wrong_jobs(self):
        """The message names the plan and its key: the file of the job does not have it."""
        self.file("plan.scallop,tolerances.scalop_mm\n1,\n1,\n1,0.1\n", "late.csv")
        self.file("plan.scallop,part.file\n1,net.json\n2,net.json\n1,none.json\n", "files.csv")
        none = f"part.file: {self.folder}/none.json, which does not exist"
        for keys, message in (
                ({"grid": [{"tolerances.scalop_mm": [0.1]}]}, "case 0: tolerances.scalop_mm: unknown key; expected"),
                ({"grid": [{"tolerance.scallop_mm": [0.1]}]}, "case 0: tolerance: unknown key; expected"),
                ({"list": "late.csv"}, "case 2: tolerances.scalop_mm: unknown key; expected"),
                ({"list": "files.csv"}, "case 2: " + none),
                ({"grid": [{"part.file": ["net.json", "none.json"]}, {"plan.scallop": [1, 2]}]}, "case 2: " + none),
                ({"grid": [{"plan.setup": ["x.json"]}]}, '/grid/0/plan.setup: unknown key "setup"')):
            with self.subTest(message):
                done = self.sweep(self.job_plan(**keys), "results", status=3)
                self.assert_refused(done, 3, "plan.json:", message)
                self.assertNotIn("job.json", done.stderr)
                self.assertFalse((self.folder / "results").exists())

    def test_wrong_options(self):
        plan = self.small_plan(count=3)
        for shard in ("0/4", "5/4", "1", "1/", "a/b", "1/0", "-1/2", "1/2/3", "1/1000001"):
            self.assert_refused(self.sweep(plan, "results", "--shard=" + shard, status=2), 2,
                                f"--shard: found {shard}; expected I/N with I from 1 to N and N at most 1000000, such as 2/8")
        self.assert_refused(endmill("sweep", "-o", "x", cwd=self.folder), 2, "found neither a plan nor --merge")
        self.assert_refused(endmill("sweep", "--merge", "x", cwd=self.folder), 2, "expected --output")
        self.assert_refused(endmill("sweep", "--merge", "x", "-o", "y", cwd=self.folder), 2, "x has no sweep.json")
        self.assert_nothing_left("plan.json")

    def test_progress_for_programs(self):
        done = self.sweep(self.small_plan(count=20), "results", "--json-progress")
        lines = [json.loads(line)["progress"] for line in done.stderr.splitlines()]
        self.assertEqual([*lines[-1]], ["done", "cases", "failed", "elapsed_s", "left_s"])
        self.assertEqual((lines[0]["done"], lines[-1]["done"], lines[-1]["cases"]), (0, 20, 20))


if __name__ == "__main__":
    unittest.main()
