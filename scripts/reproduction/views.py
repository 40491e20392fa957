# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that shows what an experiment is about in 3D.

"view" of its params.json is a command of endmill with its input and options, or a list of commands of which the last
one makes the page. In it "@" is the folder of the experiment's results, "@/NAME" a file there.
"""
import subprocess

from .fault import Fault

FOLDER = "view"  # in the results of the experiment
PAGE = f"{FOLDER}/page.html"
PROGRAM = "build/release/src/cli/endmill"
ANSWERS = (0, 1)  # exit codes with results
MISSING = "the script of the page is missing"  # a build without npm or esbuild


def is_command(words):
    return isinstance(words, list) and bool(words) and all(isinstance(word, str) for word in words)


def commands_of(params):
    """The commands of the view, none without one."""
    view = params.get("view", [])
    commands = [view] if is_command(view) else view
    if not isinstance(commands, list) or not all(is_command(words) for words in commands):
        raise Fault('params.json: "view" is a list of texts, a command of endmill with its input and options; '
                    "or a list of such commands")
    return commands


def make_view(experiment):
    """Runs the commands of an experiment, which write its page. A build that has no page makes none."""
    commands = commands_of(experiment.params())
    results = str(experiment.results)
    for number, words in enumerate(commands, 1):
        command = [results + word[1:] if word == "@" or word.startswith("@/") else word for word in words]
        if number == len(commands):
            is_view = words[0] == "view"
            command += ["-o", f"{results}/{PAGE}"] if is_view else ["--html", "-o", f"{results}/{FOLDER}"]
        done = subprocess.run([str(experiment.root / PROGRAM), *command, "--force", "--quiet"], cwd=experiment.root,
                              capture_output=True, text=True, check=False)
        if MISSING in done.stderr:
            return
        if done.returncode not in ANSWERS:
            raise Fault(f"view: {done.stderr.strip()}")


def link(experiment):
    """The address of the page, relative to results/report.html; empty without one."""
    return f"{experiment.name}/{PAGE}" if (experiment.results / PAGE).is_file() else ""
