# SPDX-License-Identifier: GPL-3.0-or-later
"""The installed build: its files, and a project that uses it before and after the prefix is moved.

The tests run in the order of their names. The prefix is moved between the two builds.
"""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("ENDMILL_BUILD", ROOT / "build/release"))
# What jobs and commands find beside the installed program.
DATA = ("cad", "controls", "jobs", "machines", "materials", "meshes", "surfaces", "sweeps", "tools")
SURFACE = ROOT / "datasets/surfaces/net_rot24_7D.json"


def run(*command, **options):
    """Runs a command and returns the finished process, also after a failure."""
    return subprocess.run([*map(str, command)], capture_output=True, text=True, check=False,
                          timeout=600, stdin=subprocess.DEVNULL, **options)


def modules():
    """The names of the modules."""
    return sorted(path.name for path in (ROOT / "src/endmill").iterdir() if path.is_dir())


class InstalledTest(unittest.TestCase):
    """A test with a temporary installation."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name).resolve()
        cls.prefix = cls.folder / "first"
        done = run("cmake", "--install", BUILD, "--prefix", cls.prefix)
        if done.returncode:
            raise RuntimeError(done.stdout + done.stderr)

    def succeed(self, *command, **options):
        """The output of a command that must succeed."""
        done = run(*command, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def build(self, source, build, *options):
        """Builds a project against the prefix, in a clean folder."""
        self.succeed("cmake", "-S", source, "-B", build, "-G", "Ninja",
                     f"-DCMAKE_PREFIX_PATH={self.prefix}", *options)
        self.succeed("cmake", "--build", build)

    def headers(self):
        """The installed headers, as in an #include."""
        include = self.prefix / "include"
        return sorted(str(path.relative_to(include)) for path in include.rglob("*.h"))


class WhatIsInstalled(InstalledTest):
    def test_program_libraries_licence_and_data_are_installed(self):
        files = {str(path.relative_to(self.prefix)) for path in self.prefix.rglob("*")
                 if path.is_file() and path.suffix != ".h"}
        package = {path for path in files if "/cmake/endmill/" in path}
        libraries = {path for path in files if path.endswith(".a")}
        self.assertEqual({Path(path).name for path in libraries},
                         {f"libendmill_{module}.a" for module in modules()})
        self.assertEqual({Path(path).name for path in package},
                         {"endmillConfig.cmake", "endmillConfigVersion.cmake",
                          "endmillTargets.cmake", "endmillTargets-release.cmake"})
        # What is there only with pybind11, npm, MPI or OpenCASCADE.
        optional = {path for path in files if path.startswith(("lib/python", "share/endmill/page/"))}
        optional |= {"bin/endmill-mpi", "bin/endmill-cad"}
        data = {f"share/endmill/{kind}/{path.name}" for kind in DATA
                for path in (ROOT / "datasets" / kind).iterdir()}
        self.assertEqual(files - package - libraries - optional,
                         {"bin/endmill", "share/doc/endmill/LICENSE", "share/man/man1/endmill.1",
                          "share/bash-completion/completions/endmill"} | data)

    def test_all_headers_except_internal_ones_are_installed(self):
        source = ROOT / "src"
        public = [*source.glob("endmill/*.h"), *source.glob("endmill/*/*.h")]
        self.assertEqual(self.headers(), sorted(str(path.relative_to(source)) for path in public))
        self.assertFalse([header for header in self.headers() if "/detail/" in header])

    def test_modules_are_components_with_their_dependencies(self):
        self.build(ROOT / "tests/consumer/whole", self.folder / "whole",
                   f"-DMODULES={';'.join(modules())}")

    def test_package_does_not_name_local_folders(self):
        for path in self.prefix.rglob("*.cmake"):
            text = path.read_text(encoding="utf-8")
            for folder in (ROOT, BUILD, self.folder):
                self.assertNotIn(str(folder), text, path.name)

    def test_version_is_that_of_the_program_and_excludes_other_minors(self):
        script = self.folder / "find.cmake"
        script.write_text("find_package(endmill 0.999 QUIET)\n"
                          "message(STATUS ${endmill_CONSIDERED_VERSIONS})\n", encoding="utf-8")
        said = self.succeed("cmake", f"-DCMAKE_PREFIX_PATH={self.prefix}", "-P", script)
        version = self.succeed(self.prefix / "bin/endmill", "--version").split()[1]
        self.assertEqual(said.split()[-1], version)


class Consumer(InstalledTest):
    def built(self, name):
        """The consumer, built against the prefix."""
        self.build(ROOT / "tests/consumer", self.folder / name)
        return self.folder / name / "consumer"

    def assert_plans_as_the_program(self, consumer):
        # Plan with the options of the consumer. The path of mode paper gouges this part, so the exit code is 1.
        facts = json.loads(run(
            self.prefix / "bin/endmill", "plan", SURFACE, "--mode", "paper", "--cutter", "ball:15", "--direction", "u",
            "--chord-tolerance", "0.5", "--scallop", "0.5", "--force", "--json", cwd=self.folder).stdout)
        self.assertEqual(self.succeed(consumer, SURFACE), f"{facts['ncl']}\n")

    def test_1_consumer_plans_like_the_program(self):
        consumer = self.built("build")
        self.assert_plans_as_the_program(consumer)
        done = run(consumer, "no_such_file.json")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("no_such_file.json", done.stderr)

    def test_2_consumer_builds_after_the_prefix_is_moved(self):
        moved = self.folder / "a place/moved"
        moved.parent.mkdir()
        type(self).prefix = self.prefix.rename(moved)
        self.assert_plans_as_the_program(self.built("build-moved"))


if __name__ == "__main__":
    unittest.main()
