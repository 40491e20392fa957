# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package by pip, in a virtual environment with the packages of the system.

pip builds the whole program, which takes 10 minutes on two cores. scripts/test.sh --all runs this file.
"""
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = """
import endmill, numpy as np
from endmill import _child
print(_child.program())
part = endmill.Surface.height_grid([0, 10, 20], [0, 10, 20], np.zeros((3, 3)))
print(endmill.verify(endmill.plan(part, cutter="ball:6", scallop=0.5))["verdict"])
"""


def run(*command, **options):
    """The output of a command that must succeed."""
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False,
                          stdin=subprocess.DEVNULL, **options)
    if done.returncode:
        raise RuntimeError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


class Pip(unittest.TestCase):
    def test_the_commands_of_the_guide_install_package_and_program(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name).resolve()
            run("git", "clone", "-q", ROOT, folder / "clone")
            run("/usr/bin/python3", "-m", "venv", "--system-site-packages", "my-environment", cwd=folder / "clone")
            run("my-environment/bin/pip", "install", "--no-build-isolation", ".", cwd=folder / "clone")
            environment = folder / "clone/my-environment"
            said = run(environment / "bin/python", "-c", SCRIPT, cwd=folder, env={"PATH": "/usr/bin:/bin"})
            self.assertEqual(said.splitlines(), [str(environment / "bin/endmill"), "clean"])


if __name__ == "__main__":
    unittest.main()
