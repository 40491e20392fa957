# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared code of the tests of faults: the commands that write, and runs in which the system fails.

The tests run in a short form. With ENDMILL_FAULTS=long they run many times as often, for about an hour on two cores.
ENDMILL_FAULT_RUNS names a file to which each test without a finding adds a line: its name and its number of runs. Runs
whose fault did not occur, since the program does not make that call, do not count."""
import concurrent.futures
import errno
import functools
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
from program import ENDMILL, ROOT  # noqa: E402

IS_LONG = os.environ.get("ENDMILL_FAULTS") == "long"
LIBRARY = os.environ.get("ENDMILL_FAILING_CALLS", "")
RUNS = os.environ.get("ENDMILL_FAULT_RUNS", "")
STAGING = ".endmill-"
NOT_FINITE = re.compile(rb"(?i)(?<![a-z])-?(nan|inf)(?![a-z])")
STRING = re.compile(rb'"(?:[^"\\]|\\.)*"')
# A time that a run took, as a member of a summary.
TIME = re.compile(rb'("\w+_m?s": )[0-9.e+-]+')
SURFACE = ROOT / "datasets/surfaces/saddle.json"
CAD_PART = ROOT / "datasets/cad/bracket-inch.step"
PLANE = ROOT / "datasets/surfaces/plane.json"
MESH = ROOT / "datasets/meshes/prism.obj"
STEEL = ROOT / "datasets/materials/steel.json"
PLAN = ["--cutter", "ball:20", "--scallop", "1"]

# Every command that writes files: its arguments, where PATH stands for a planned path and FOLDER for the
# output folder. A new command joins by one line.
COMMANDS = {
    "sample": ["sample", SURFACE, "--chord-tolerance", "1", "-o", "FOLDER"],
    "plan": ["plan", PLANE, "--strategy", "iso", *PLAN, "-o", "FOLDER"],
    "plan --strategy best": ["plan", PLANE, "--strategy", "best", "--bound", "none", "--cutter", "ball:60", "--scallop",
                             "5", "-o", "FOLDER"],
    "trim": ["trim", MESH, "--cutter", "ball:6", "--planes", "5", "--grid", "20", "-o", "FOLDER"],
    "trim --method all": ["trim", PLANE, "--method", "all", "--cutter", "ball:6", "--planes", "3", "--grid", "9",
                          "-o", "FOLDER"],
    "verify": ["verify", "PATH", "--resolution", "4", "--max-refine", "0", "--write-stock", "-o", "FOLDER"],
    "post": ["post", "PATH", "--feed", "800", "--spindle-rpm", "6000", "-o", "FOLDER"],
    "feed": ["feed", "PATH", "--material", STEEL, "--flutes", "2", "--helix-deg", "30", "--max-force-n", "500",
             "-o", "FOLDER"],
    "setup": ["setup", MESH, "--machine", "W/caxyBz/T", "--sphere", "hex:4", "-o", "FOLDER"],
    "info": ["info", SURFACE, "-o", "FOLDER"],
    "machine": ["machine", "W/caxyBz/T", "-o", "FOLDER"],
    "cite": ["cite", "-o", "FOLDER"],
}
if Path(ENDMILL).with_name("endmill-cad").exists():
    COMMANDS["import"] = ["import", CAD_PART, "-o", "FOLDER"]

EXTREMES = ("0", "-0", "-1", "1e-320", "1e-9", "0.5", "65536", "2147483648", "9223372036854775808", "1e19", "1e100",
            "1e308", "-1e308", "1e999", "nan", "inf", "1,2", "x", "")
# An option with a value: at the beginning of a line of the help, with the name of the value in capitals.
OPTION = re.compile(r"^  (?:-\w,)?(--[\w-]+) [^ a-z]*[A-Z]", re.MULTILINE)


@functools.cache
def options_of(command):
    said = subprocess.run([ENDMILL, command, "--help"], capture_output=True, text=True, check=True).stdout
    return sorted(set(OPTION.findall(said)) - {"--output"})


def usual_value(chance):
    """A number as a user may give it, of the size of a part or of a tolerance."""
    number = 10 ** chance.uniform(-1.5, 1.5)
    return chance.choice((f"{number:.6g}", f"{number:.2g}", str(math.ceil(number))))


def random_value(chance):
    """An extreme value, or a number of any magnitude."""
    kind = chance.randrange(4)
    if kind == 0:
        return chance.choice(EXTREMES)
    number = 10 ** chance.uniform(-6, 6) if kind == 1 else 10 ** chance.uniform(-1, 2)
    return str(round(number)) if kind == 3 else f"{chance.choice((1, 1, 1, -1)) * number:.6g}"


def with_random_options(seed, counts, value):
    """The name of a command, and some of its options, counts[0] to counts[1], with values value(chance)."""
    chance = random.Random(seed)
    name = sorted(COMMANDS)[seed % len(COMMANDS)]
    options = options_of(COMMANDS[name][0])
    chosen = chance.sample(options, min(len(options), chance.randint(*counts)))
    return name, *(f"{option}={value(chance)}" for option in chosen)


# A line of progress, and an estimate in it.
PROGRESS = re.compile(r"^endmill: (?!error: |warning: )")
ESTIMATE = re.compile(r", about .+ left$")
# The program prints its first line after one second, if it knows the share that is done, and then one every ten seconds.
# The rest is for a busy machine.
FIRST_LINE_S = 20
NEXT_LINE_S = 25


def timed_run(command, seconds, **settings):
    """Runs a command with its standard error in a pipe. Returns its exit status, None if it took longer than `seconds`, and
    the lines of standard error with the times at which they came, in s since the start."""
    start = time.monotonic()
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          **settings) as process:
        lines = []

        def read():
            for line in process.stderr:
                lines.append((time.monotonic() - start, line.decode(errors="replace").rstrip("\n")))
        reader = threading.Thread(target=read)
        reader.start()
        try:
            status = process.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            status = None
        reader.join()
    return status, lines


class Finished:
    """A run that has ended: status (negative: the number of the signal), error text, whether the fault that was asked
    for occurred, and the content of the output folder by file, without staging folders, whose number is in `left`."""

    def __init__(self, status, error, occurred, folder):
        self.status = status
        self.error = error
        self.occurred = occurred
        self.left = len(list(folder.parent.rglob(STAGING + "*")))
        self.files = contents(folder)


def contents(folder):
    """The files of a folder by name, and its folders with "/" behind the name, staging folders left out; None if there
    is no folder."""
    if not folder.is_dir():
        return None
    paths = {str(path.relative_to(folder)): path for path in sorted(folder.rglob("*"))}
    return {name + "/" * path.is_dir(): b"" if path.is_dir() else TIME.sub(rb"\1", path.read_bytes())
            for name, path in paths.items() if STAGING not in name}


def difference(found, expected):
    """The names of the files that differ; empty if none does."""
    if found is None or expected is None:
        return "" if found is expected else "one folder is missing"
    return ", ".join(sorted(name for name in {*found, *expected} if found.get(name) != expected.get(name)))


def not_finite(files):
    """The names of the text files that contain a number that is not finite. Strings of JSON may quote an input."""
    texts = {name: content for name, content in (files or {}).items() if name.endswith((".csv", ".json", ".ngc", ".svg"))}
    return [name for name, content in texts.items()
            if NOT_FINITE.search(STRING.sub(b"", content) if name.endswith(".json") else content)]


def calls(counts):
    """How often a run made each call, from the file that it wrote at its end."""
    lines = counts.read_text(encoding="utf-8").splitlines() if counts.exists() else []
    return {call: int(count) for call, count in map(str.split, lines)}


def made_call(fault, counts):
    """Whether a run that ended made the call that should fail."""
    call, number, _ = fault.split(":")
    return calls(counts).get(call, 0) >= int(number.rstrip("+"))


def environment(fault=None, counts=None, alone=False):
    settings = {**os.environ, "LD_PRELOAD": LIBRARY}
    if alone:
        settings["ENDMILL_FAULT_ALONE"] = "1"
    if fault:
        settings["ENDMILL_FAULT"] = fault
    if counts:
        settings["ENDMILL_FAULT_COUNTS"] = str(counts)
    return settings


class FaultTest(unittest.TestCase):
    """Has a planned path, and runs commands in folders of their own."""

    @classmethod
    def setUpClass(cls):
        if not LIBRARY:
            raise unittest.SkipTest("ENDMILL_FAILING_CALLS does not name the library of failing calls")
        cls.place = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.place)
        subprocess.run([ENDMILL, "plan", PLANE, "--strategy", "iso", *PLAN, "--quiet", "-o", cls.place / "path"], check=True)

    def setUp(self):
        self.runs = 0

    def tearDown(self):
        failed = self._outcome.result.failures + self._outcome.result.errors
        if RUNS and not any(self.id() == test.id().split(" ")[0] for test, _ in failed):
            with open(RUNS, "a", encoding="utf-8") as file:
                file.write(f"{self.id().rpartition('.')[2]} {self.runs}\n")

    def command(self, name, folder):
        """The words of a command."""
        path = self.place / "path/u/toolpath.csv"
        return [str(word) for word in (ENDMILL, *({"PATH": path, "FOLDER": folder}.get(word, word)
                                                  for word in COMMANDS[name]))]

    def run_command(self, name, folder, *options, fault=None, counts=None, timeout=120, **settings):
        counts = counts or folder.parent / "counts"
        done = subprocess.run([*self.command(name, folder), *options], capture_output=True, check=False,
                              stdin=subprocess.DEVNULL, timeout=timeout, cwd=folder.parent,
                              env=environment(fault, counts), **settings)
        occurred = not fault or done.returncode < 0 or made_call(fault, counts)
        return Finished(done.returncode, done.stderr.decode(errors="replace"), occurred, folder)

    def assert_answered(self, case, status, lines, folder):
        """A run with a faulty input ends with an exit code, names the error, and writes finite numbers only."""
        text = "\n".join(line for _, line in lines)
        self.assertIn(status, range(7), f"{case}: {text[-300:]}")
        if status > 1:
            self.assertRegex(text, "(?m)^endmill: error: ", case)
        self.assertEqual(not_finite(contents(folder)), [], case)

    def assert_not_silent(self, case, seconds, lines):
        """A run that took longer than `seconds` said soon what it does, went on to do so, and estimated the time left."""
        progress = [(at, line) for at, line in lines if PROGRESS.match(line)]
        times = [at for at, _ in progress] + [seconds]
        self.assertLess(times[0], FIRST_LINE_S, f"{case}: the first line of progress")
        self.assertLess(max((late - early for early, late in zip(times, times[1:])), default=0), NEXT_LINE_S,
                        f"{case}: silence between lines at {times}")
        self.assertTrue(any(ESTIMATE.search(line) for _, line in progress), f"{case}: no estimate in {progress}")

    def in_new_place(self, act):
        """The result of act(folder), where the folder does not exist yet; its parent is removed afterwards."""
        with tempfile.TemporaryDirectory(dir=self.place) as parent:
            return act(Path(parent) / "results")

    def sound(self, name):
        """A run without faults: what it wrote, and how often it made each call."""
        def act(folder):
            counts = folder.parent / "counts"
            done = self.run_command(name, folder, counts=counts)
            self.assertIn(done.status, (0, 1), f"{name}: {done.error}")
            return done.files, calls(counts)
        return self.in_new_place(act)

    def in_parallel(self, act, cases):
        """act(*case) for all cases, on as many threads as there are processors. It returns the number of runs that count,
        or nothing for one."""
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for done in [pool.submit(act, *case) for case in cases]:
                count = done.result()
                self.runs += 1 if count is None else int(count)


def some_of(count, short):
    """Numbers from 1 to `count`: all of them up to 300 in the long form, else `short` of them."""
    if IS_LONG:
        return list(range(1, min(count, 300) + 1))
    if count <= short:
        return list(range(1, count + 1))
    return sorted({1 + round(k * (count - 1) / (short - 1)) for k in range(short)})


# The errors of a call of the system: once, or from that call on ("+").
FAILURES = [(number, later) for number in (errno.ENOSPC, errno.EIO, errno.EACCES, errno.EROFS) for later in ("", "+")]
FAILURES = FAILURES if IS_LONG else FAILURES[:1]
NO_MEMORY = errno.ENOMEM
NO_MORE_THREADS = errno.EAGAIN
