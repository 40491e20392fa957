# SPDX-License-Identifier: GPL-3.0-or-later
"""setup, trim and sweep under mpirun: the files of one process, errors from one rank, and the end of a run whose rank dies."""
import json
import math
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from program import ENDMILL, ROOT, ProgramTest, endmill

sys.path.insert(0, str(ROOT / "tests/faults"))
from faults import contents, difference  # noqa: E402

MESHES = ROOT / "datasets/meshes"
MPI_PROGRAM = Path(ENDMILL).with_name("endmill-mpi")
# Any number of ranks on any number of cores, also if root starts them.
MPIRUN = ["mpirun", "--oversubscribe", "--allow-run-as-root"]


def mpirun(ranks, *arguments, program=ENDMILL, **options):
    """Runs the program on several ranks. Returns the finished process."""
    command = [*MPIRUN, "-n", str(ranks), program, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=600, stdin=subprocess.DEVNULL,
                          **options)


def error_lines(text):
    """The lines of an error output that report an error of ours."""
    return [line for line in text.splitlines() if line.startswith("endmill: error:")]


def family(count, seed, spacing):
    """A file of random curves with folds, some of them closed; `spacing` is the distance of their beginnings."""
    draw = random.Random(seed)
    rows = ["s_mm,z_mm,curve"]
    for number in range(count):
        begin = spacing * number
        points = [(begin + i + draw.choice((0, 0, 2)), draw.randrange(40) / 4) for i in range(12)]
        if draw.random() < 0.2:
            points.append(points[0])
        rows += [f"{s},{z},{number}" for s, z in points]
    return "\n".join(rows) + "\n"


def bumpy_part(cells):
    """A mesh of 2 x cells x cells facets with bumps of two wave lengths."""
    def height(x, y):
        return 4 * math.sin(x / 5) * math.cos(y / 4) + 1.5 * math.sin((x + 0.7 * y) / 2)
    places = [(120 * i / cells - 60, 80 * j / cells - 40) for j in range(cells + 1) for i in range(cells + 1)]
    corners = [j * (cells + 1) + i for j in range(cells) for i in range(cells)]
    lines = [f"OFF\n{len(places)} {2 * len(corners)} 0", *(f"{x} {y} {height(x, y)}" for x, y in places)]
    for a in corners:
        lines += [f"3 {a} {a + 1} {a + cells + 2}", f"3 {a} {a + cells + 2} {a + cells + 1}"]
    return "\n".join(lines) + "\n"


class WithoutMpi(ProgramTest):
    def test_endmill_does_not_link_mpi(self):
        libraries = subprocess.run(["ldd", ENDMILL], capture_output=True, text=True, check=True).stdout
        self.assertNotRegex(libraries, r"libmpi|libopen-|libpmi|boost_mpi")

    def test_program_without_endmill_mpi_beside_it_names_the_packages(self):
        alone = shutil.copy(ENDMILL, self.folder / "endmill")
        for rank in "0", "1":
            done = subprocess.run([alone, "setup", "part.off", "--machine", "all"], capture_output=True, text=True,
                                  check=False, env={**os.environ, "OMPI_COMM_WORLD_SIZE": "2",
                                                    "OMPI_COMM_WORLD_RANK": rank})
            if rank == "0":
                self.assert_refused(done, 2, "openmpi-bin", "libopenmpi-dev", "libboost-mpi-dev", "build endmill again")
            else:
                self.assertEqual((done.returncode, done.stdout, done.stderr), (2, "", ""))
        said = subprocess.run([alone, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertRegex(said, r"^endmill \S+ \(without endmill-mpi, with(out)? endmill-cad\)\n$")

    def test_other_commands_and_single_processes_stay_endmill(self):
        alone = shutil.copy(ENDMILL, self.folder / "endmill")
        for words, count in ((["machine", "W/caxyBz/T"], "2"), (["setup", "--help"], "1")):
            done = subprocess.run([alone, *words], capture_output=True, text=True, check=False,
                                  env={**os.environ, "OMPI_COMM_WORLD_SIZE": count, "OMPI_COMM_WORLD_RANK": "0"})
            self.assertEqual(done.returncode, 0, done.stderr)


@unittest.skipUnless(MPI_PROGRAM.exists() and shutil.which("mpirun"),
                     "endmill-mpi was not built: scripts/setup.sh mpi installs what it needs")
class Mpi(ProgramTest):
    def assert_same_files(self, name, *words, status=0):
        """Asserts that four ranks print and write what one process does."""
        outputs, written = [], []
        for ranks in (1, 4):
            folder = self.folder / f"{name} {ranks}"
            folder.mkdir()
            done = (mpirun(ranks, *words, "-o", "out", cwd=folder) if ranks > 1 else
                    subprocess.run([ENDMILL, *map(str, words), "-o", "out"], capture_output=True, text=True, check=False,
                                   stdin=subprocess.DEVNULL, cwd=folder))
            self.assertEqual(done.returncode, status, done.stderr)
            outputs.append(re.sub(r"[\d.]+ (ms|s)\b", "", done.stdout))
            written.append(contents(folder / "out"))
        self.assertEqual("", difference(*written), name)
        return outputs

    def status_of(self, *words):
        """The answer of one process: 0 or 1."""
        done = subprocess.run([ENDMILL, *map(str, words), "--force", "-o", "status", "--quiet"], capture_output=True,
                              text=True, check=False, cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return done.returncode

    def test_setup_writes_the_files_of_one_process(self):
        teapot = MESHES / "teapot-288.off"
        one, four = self.assert_same_files("teapot", "setup", teapot, "--machine", "W/caxyBz/T", "--sphere", "hex:5",
                                           "--write-bsm-csv")
        self.assertEqual(one, four)
        call = ["setup", teapot, "--machine", "all", "--sphere", "hex:3", "--visibility", "local", "--incidence-deg", "70"]
        self.assert_same_files("local", *call, status=self.status_of(*call))

    def test_setup_with_the_body_of_a_tool(self):
        tool = ROOT / "datasets/tools/ball-10-shrink-fit.json"
        call = ["setup", MESHES / "dome.stl", "--machine", "W/caxyBz/T", "--tool", tool, "--sphere", "hex:2"]
        self.assert_same_files("tool", *call, status=self.status_of(*call))

    def test_search_of_a_large_part_writes_the_files_of_one_process(self):
        """A part of which each rank searches a share of the facets: for every mode, both families, and within travel."""
        part = self.file(bumpy_part(240), "bumpy.off")
        self.assert_same_files("large", "setup", part, "--machine", "W/caxyBz/T", "--sphere", "hex:5", "--write-bsm-csv")
        with open(self.folder / "large 1/out/visibility.csv", encoding="utf-8") as rows:
            different_cones = len({row.partition(",")[2] for row in rows}) - 1
        self.assertGreater(different_cones, 3 * 24_576)  # enough for a share on each of three ranks; the fourth has none
        stored = self.folder / "large 1/out/visibility.bsm"
        call = ["setup", part, "--from-visibility", stored]
        searches = (["--family", "AB", "--mode", "paper-literal"], ["--family", "CA", "--mode", "corrected"],
                    ["--family", "CA", "--mode", "set", "--gap", "0.5"],
                    ["--machine", ROOT / "datasets/machines/ca-table-table.json", "--within-travel"],
                    ["--machine", "all", "--max-setups", "2"])
        for number, words in enumerate(searches):
            with self.subTest(words):
                words = [*call, *words]
                self.assert_same_files(f"search {number}", *words, status=self.status_of(*words))

    def test_setup_from_a_stored_map_and_for_points_is_that_of_one_process(self):
        teapot = MESHES / "teapot-288.off"
        self.assert_same_files("stored", "setup", teapot, "--machine", "W/caxyBz/T", "--sphere", "hex:3")
        stored = self.folder / "stored 4/out/visibility.bsm"
        self.assert_same_files("again", "setup", teapot, "--machine", "W/caxyBz/T", "--from-visibility", stored)
        points = self.file("azimuth_deg,polar_deg\n0,10\n90,20\n", "points.csv")
        self.assert_same_files("points", "setup", "--points", points, "--family", "CA")

    def test_trim_of_curves_writes_the_files_of_one_process(self):
        apart = self.file(family(80, 1, 14), "apart.csv")
        together = self.file(family(80, 2, 0.25), "together.csv")
        for name, file in (("apart", apart), ("together", together)):
            for method in ("1", "2", "3", "3r", "envelope", "winding"):
                self.assert_same_files(f"{name} {method}", "trim", "--polyline", file, "--method", method, "--explain",
                                       status=self.status_of("trim", "--polyline", file, "--method", method))
            self.assert_same_files(f"{name} all", "trim", "--polyline", file, "--method", "all", "--figure", "worst",
                                   status=self.status_of("trim", "--polyline", file, "--method", "all"))

    def test_trim_of_profiles_writes_the_files_of_one_process(self):
        rows = ["s_mm,z_mm,curve"]
        for number in range(20):
            rows += [f"{50 * number + s},{z},{number}" for s, z in ((0, 9), (8, 0), (16, 7), (20, 7), (30, 1))]
        profiles = self.file("\n".join(rows) + "\n", "profiles.csv")
        for words in (["--method", "envelope"], ["--method", "all"], ["--mode", "paper"]):
            call = ["trim", "--polyline", profiles, "--offset", "4", *words]
            self.assert_same_files("profiles " + words[1], *call, status=self.status_of(*call))

    def test_trim_of_planes_writes_the_files_of_one_process(self):
        """Curves in planes of their own, one by one; fewer planes than ranks, and many of different lengths."""
        draw = random.Random(4)
        for planes in (2, 3, 50):
            rows = ["plane,s_mm,z_mm"]
            for plane in range(planes):
                rows += [f"{plane},{i + draw.choice((0, 0, 2))},{draw.randrange(40) / 4}"
                         for i in range(draw.randrange(3, 60))]
            file = self.file("\n".join(rows) + "\n", f"planes-{planes}.csv")
            for method in ("3", "envelope", "all"):
                call = ["trim", "--polyline", file, "--method", method]
                self.assert_same_files(f"planes {planes} {method}", *call, status=self.status_of(*call))

    def test_bad_input_is_reported_once_with_its_exit_code(self):
        broken = self.file("OFF\n3 1 0\n0 0 0\n1 0 x\n", "broken.off")
        curves = self.file("s_mm,z_mm\n1,2\n3,x\n", "broken.csv")
        for words, status, word in ((["setup", broken, "--machine", "W/caxyBz/T"], 3, "broken.off"),
                                    (["trim", "--polyline", curves], 3, "broken.csv:3"),
                                    (["setup", "missing.off", "--machine", "W/caxyBz/T"], 3, "missing.off"),
                                    (["setup", MESHES / "dome.stl", "--machine", "nonsense"], 2, "nonsense"),
                                    (["trim", "--polyline", curves, "--colour"], 2, "--colour")):
            with self.subTest(words):
                done = mpirun(4, *words, cwd=self.folder)
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertEqual(done.stdout, "")
                self.assertEqual(len(error_lines(done.stderr)), 1, done.stderr)
                self.assertIn(word, error_lines(done.stderr)[0])
        self.assert_nothing_left("broken.off", "broken.csv")

    def test_summary_is_printed_once(self):
        done = mpirun(3, "setup", MESHES / "teapot-288.off", "--machine", "W/caxyBz/T", "--sphere", "hex:3", "--json",
                      cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("visibility_s", json.loads(done.stdout))
        self.assertEqual(mpirun(3, "setup", "--help").stdout.count("Example:"), 1)

    def test_failure_of_one_rank_ends_all_with_its_exit_code(self):
        # Rank 1 alone gets too little memory for its part.
        limited = self.file('#!/bin/sh\n[ "$OMPI_COMM_WORLD_RANK" = 1 ] && set -- "$@" --max-memory 1e-6\n'
                            f'exec {ENDMILL} "$@"\n', "limited.sh")
        limited.chmod(0o755)
        done = mpirun(3, "setup", MESHES / "teapot-288.off", "--machine", "W/caxyBz/T", program=limited, cwd=self.folder)
        self.assertEqual(done.returncode, 6, done.stderr)
        self.assertEqual(len(error_lines(done.stderr)), 1, done.stderr)
        self.assertIn("rank 1: ", done.stderr)
        self.assert_nothing_left("limited.sh")

    def test_death_of_a_rank_ends_the_run_and_the_next_one_leaves_nothing(self):
        process = subprocess.Popen([*MPIRUN, "-n", "3", ENDMILL, "setup", MESHES / "walled-saddle.off", "--machine",
                                    "W/caxyBz/T", "--sphere", "hex:60"], stdin=subprocess.DEVNULL, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        os.kill(self.rank_of(process.pid, 1), signal.SIGKILL)
        _, error = process.communicate(timeout=120)
        self.assertNotEqual(process.returncode, 0, error)
        self.assertIn("signal 9", error)
        self.assertFalse((self.folder / "walled-saddle-setup").exists())
        # mpirun kills the other ranks if they do not end within some seconds. The next run removes what they left.
        done = endmill("setup", MESHES / "walled-saddle.off", "--machine", "W/caxyBz/T", "--sphere", "hex:2",
                       cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["walled-saddle-setup"])

    def rank_of(self, launcher, rank):
        """The process number of a rank, as soon as it computes."""
        for _ in range(600):
            for status in Path("/proc").glob("[0-9]*/status"):
                try:
                    parent = re.search(r"^PPid:\s+(\d+)$", status.read_text(), re.M)
                    if int(parent[1]) == launcher:
                        variables = (status.parent / "environ").read_bytes().split(b"\0")
                        program = os.readlink(status.parent / "exe")
                        if f"OMPI_COMM_WORLD_RANK={rank}".encode() in variables and program.endswith("endmill-mpi"):
                            time.sleep(0.5)
                            return int(status.parent.name)
                except OSError:
                    continue
            time.sleep(0.1)
        raise RuntimeError("no such rank")


class Sweeps(ProgramTest):
    """A sweep on four ranks, whole or killed. With ENDMILL_FAULTS=long it is killed 100 times, else 8 times."""

    CASES = 120
    KILLS = 100 if os.environ.get("ENDMILL_FAULTS") == "long" else 8

    def setUp(self):
        super().setUp()
        if not MPI_PROGRAM.exists():
            self.skipTest("endmill-mpi was not built")
        self.plan = self.file({"format": "endmill-sweep/1", "command": "coefficients",
                               "options": {"material": str(ROOT / "datasets/materials/steel.json"), "flutes": 2,
                                           "lambda_deg": 20, "pick_feed_ratio": 0.5, "mu_deg": 0},
                               "random": {"count": self.CASES, "seed": 3, "parameters": {
                                   "cutter": {"one_of": ["ball:10", "ball:6", "ball:x"]},
                                   "depth_ratio": {"from": 0.1, "to": 1}, "feed_per_tooth": {"from": 0.01, "to": 0.1}}},
                               "columns": ["torque_n_m"]}, "plan.json")

    def results(self, folder):
        """The rows without times, and what else is in the folder."""
        place = self.folder / folder
        rows = [line.rpartition(b",")[0] for line in (place / "results.csv").read_bytes().splitlines()]
        return rows, sorted(path.name for path in place.iterdir())

    def one_process(self):
        subprocess.run([ENDMILL, "sweep", self.plan, "-o", self.folder / "one", "--quiet"], check=True)
        return self.results("one")

    def test_results_are_those_of_one_process(self):
        expected = self.one_process()
        self.assertEqual(len(expected[0]), self.CASES + 1)
        done = mpirun(4, "sweep", self.plan, "-o", self.folder / "four")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.results("four"), expected)
        self.assertEqual(done.stdout.count("written to"), 1)

    def test_bad_plans_are_reported_once(self):
        bad = self.file({"format": "endmill-sweep/1", "command": "mill"}, "bad.json")
        done = mpirun(4, "sweep", bad, "-o", self.folder / "bad")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertEqual(len(error_lines(done.stderr)), 1, done.stderr)
        self.assert_nothing_left("plan.json", "bad.json")

    @staticmethod
    def ranks_of(launcher):
        """The process numbers of the ranks by rank."""
        numbers = {}
        for place in Path("/proc").glob("[0-9]*"):
            try:
                words = (place / "stat").read_text().rpartition(")")[2].split()
                variables = (place / "environ").read_bytes().split(b"\0")
            except (OSError, IndexError):
                continue
            rank = [word.partition(b"=")[2] for word in variables if word.startswith(b"OMPI_COMM_WORLD_RANK=")]
            if int(words[1]) == launcher and rank:
                numbers[int(rank[0])] = int(place.name)
        return numbers

    def test_a_sweep_whose_rank_was_killed_goes_on(self):
        expected = self.one_process()
        chance = random.Random(11)
        killed = 0
        for kill in range(self.KILLS):
            shutil.rmtree(self.folder / "four", ignore_errors=True)
            command = [*MPIRUN, "-n", "4", ENDMILL, "sweep", self.plan, "-o", self.folder / "four", "--resume"]
            with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as process:
                while process.poll() is None and not (self.folder / "four").exists():
                    time.sleep(0.01)
                time.sleep(chance.random())
                number = self.ranks_of(process.pid).get(kill % 4)
                if number and process.poll() is None:
                    os.kill(number, signal.SIGKILL)
                killed += process.wait(timeout=120) != 0
            # It goes on by any number of processes.
            command = [ENDMILL, "sweep", self.plan, "-o", self.folder / "four", "--resume", "--quiet"]
            done = mpirun(4, *command[1:]) if kill % 2 else subprocess.run(command, capture_output=True, text=True,
                                                                           check=False, timeout=120)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(self.results("four"), expected, f"kill {kill}")
        self.assertGreater(killed, self.KILLS // 4)


if __name__ == "__main__":
    unittest.main()
