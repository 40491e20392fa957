# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that shows what an experiment is about in 3D: "view" of its params.json is a command of endmill."""
import subprocess

from .fault import Fault

FOLDER = "view"  # in the results of the experiment
PAGE = f"{FOLDER}/page.html"
PROGRAM = "build/release/src/cli/endmill"
ANSWERS = (0, 1)  # exit codes with results
MISSING = "the script of the page is missing"  # a build without npm or esbuild


def words_of(params):
    """The words of the command, none without one."""
    words = params.get("view", [])
    if not isinstance(words, list) or not all(isinstance(word, str) for word in words):
        raise Fault('params.json: "view" is a list of texts: a command of endmill with its input and options')
    return words


def make_view(experiment):
    """Runs the command of an experiment and writes its page. A build that has no page makes none."""
    words = words_of(experiment.params())
    if not words:
        return
    command = [str(experiment.root / PROGRAM), *words, "--html", "--force", "--quiet", "-o",
               str(experiment.results / FOLDER)]
    done = subprocess.run(command, cwd=experiment.root, capture_output=True, text=True, check=False)
    if done.returncode not in ANSWERS and MISSING not in done.stderr:
        raise Fault(f"view: {done.stderr.strip()}")


def link(experiment):
    """The address of the page, relative to results/report.html; empty without one."""
    return f"{experiment.name}/{PAGE}" if (experiment.results / PAGE).is_file() else ""
