# SPDX-License-Identifier: GPL-3.0-or-later
"""The revision and the machine that produced a result."""
import os
import re
import subprocess


def first_line(command, root):
    """The first line of the output of `command`, or "unknown" if it fails."""
    try:
        done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True)
        return done.stdout.splitlines()[0]
    except (OSError, subprocess.CalledProcessError, IndexError):
        return "unknown"


def revision(root):
    """The commit, with -dirty appended if files differ from it."""
    return first_line(["git", "describe", "--always", "--dirty"], root)


def cpu_model():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            match = re.search(r"^model name\s*:\s*(.+)$", file.read(), re.M)
    except OSError:
        match = None
    return match.group(1).strip() if match else "unknown"


def compiler(root):
    """The version of the compiler that the release build is configured with."""
    try:
        cache = (root / "build/release/CMakeCache.txt").read_text(encoding="utf-8")
    except OSError:
        return "unknown"
    match = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.+)$", cache, re.M)
    return first_line([match.group(1), "--version"], root) if match else "unknown"


def describe(root):
    """The machine as run.json records it; a high load average makes measured times unreliable."""
    return {
        "cpu": cpu_model(),
        "cores": len(os.sched_getaffinity(0)),
        "load_average": [round(load, 2) for load in os.getloadavg()],
        "compiler": compiler(root),
    }
