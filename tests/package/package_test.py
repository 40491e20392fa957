# SPDX-License-Identifier: GPL-3.0-or-later
"""The Debian package: its contents and dependencies, and its program, manual and libraries.

As root, the test installs the package, runs it and removes it. Without root, the test unpacks it.
Build the target `package` first. scripts/test.sh --all runs this file.
"""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("ENDMILL_BUILD", ROOT / "build/release"))


def run(*command, **options):
    """Runs a command and returns the finished process, also after a failure."""
    return subprocess.run([*map(str, command)], capture_output=True, text=True, check=False,
                          timeout=900, stdin=subprocess.DEVNULL, **options)


def succeed(*command, **options):
    """The output of a command that must succeed."""
    done = run(*command, **options)
    if done.returncode:
        raise RuntimeError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def package_file():
    """The newest package of the build."""
    files = sorted(BUILD.glob("endmill_*.deb"), key=lambda path: path.stat().st_mtime)
    if not files:
        raise RuntimeError(f"no package in {BUILD}: cmake --build {BUILD} --target package")
    return files[-1]


def can_install():
    """Whether the package may be installed: as root, and without an installed endmill."""
    return os.geteuid() == 0 and shutil.which("apt-get") and run("dpkg", "-s", "endmill").returncode


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name).resolve()
        cls.file = package_file()
        if can_install():
            cls.addClassCleanup(succeed, "dpkg", "--purge", "endmill")
            succeed("apt-get", "install", "-y", "--no-install-recommends", cls.file,
                    env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"})
            cls.prefix = Path("/usr")
        else:
            succeed("dpkg-deb", "--extract", cls.file, cls.folder / "unpacked")
            cls.prefix = cls.folder / "unpacked/usr"

    def test_package_depends_on_libraries_and_suggests_those_of_headers(self):
        depends = succeed("dpkg-deb", "--field", self.file, "Depends")
        for library in ("libc6", "libstdc++6", "libfmt9"):
            self.assertRegex(depends, rf"\b{re.escape(library)}\b")
        suggests = succeed("dpkg-deb", "--field", self.file, "Suggests")
        self.assertIn("libeigen3-dev", suggests)

    def test_package_has_program_machines_manual_completion_headers_and_libraries(self):
        for name in ("bin/endmill", "share/endmill/machines", "share/man/man1/endmill.1",
                     "share/bash-completion/completions/endmill", "share/doc/endmill/LICENSE",
                     "include/endmill/core/vec.h", "lib/libendmill_core.a",
                     "lib/cmake/endmill/endmillConfig.cmake"):
            self.assertTrue((self.prefix / name).exists(), name)

    def test_program_runs_and_finds_its_machines(self):
        endmill = self.prefix / "bin/endmill"
        version = succeed("dpkg-deb", "--field", self.file, "Version").strip()
        self.assertEqual(succeed(endmill, "--version").split()[1], version)
        said = succeed(endmill, "setup", ROOT / "datasets/meshes/teapot-288.off", "--machine", "all",
                       "--sphere", "hex:4", "--json", cwd=self.folder)
        self.assertIn("{", said)

    def test_manual_names_every_command(self):
        manual = (self.prefix / "share/man/man1/endmill.1").read_text(encoding="utf-8")
        helped = succeed(self.prefix / "bin/endmill", "--help")
        commands = re.findall(r"^  ([a-z]+) +\S", helped.split("Subcommands:")[1].split("\n\n")[0],
                              re.MULTILINE)
        self.assertGreaterEqual(len(commands), 10)
        for command in commands:
            self.assertTrue(f"\n.SS endmill {command}\n" in manual, command)

    def test_completion_offers_commands_options_and_values(self):
        script = f"""source {self.prefix}/share/bash-completion/completions/endmill
            COMP_WORDS=(endmill trim --order '') COMP_CWORD=3
            _endmill && echo "${{COMPREPLY[@]}}" """
        self.assertEqual(succeed("bash", "-c", script).split(), ["zigzag", "one-way"])

    def test_libraries_build_a_project_in_another_folder(self):
        build = self.folder / "consumer"
        succeed("cmake", "-S", ROOT / "tests/consumer", "-B", build, "-G", "Ninja",
                f"-DCMAKE_PREFIX_PATH={self.prefix}")
        succeed("cmake", "--build", build)
        said = succeed(build / "consumer", ROOT / "datasets/surfaces/net_rot24_7D.json")
        self.assertRegex(said, r"^\d+\n$")


if __name__ == "__main__":
    unittest.main()
