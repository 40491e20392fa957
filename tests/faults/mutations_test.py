# SPDX-License-Identifier: GPL-3.0-or-later
"""Input files of every kind with random faults, from a fixed seed. The program reads them or names the fault, soon,
and within a limit of memory."""
import random
import resource
import subprocess
import unittest
from pathlib import Path

from faults import ENDMILL, IS_LONG, MESH, PLAN, PLANE, ROOT, STEEL, FaultTest, environment, timed_run

MUTANTS = 31_200 if IS_LONG else 90
SECONDS = 30
MEMORY_BYTES = 4 << 30
NUMBERS = (b"0", b"-1", b"1e308", b"-1e308", b"1e-320", b"nan", b"inf", b"2147483648", b"99999999999999999999", b"1e5",
           b"0.1", b"")

# The kinds of input: a sound file, and the command that reads its mutant FILE. PATH stands for a planned path.
KINDS = {
    "surface": (PLANE, ["plan", "FILE", "--strategy", "iso", *PLAN]),
    "net": (ROOT / "datasets/surfaces/teapot.json", ["info", "FILE"]),
    "obj": (MESH, ["trim", "FILE", "--cutter", "ball:6", "--planes", "4", "--grid", "9"]),
    "off": (MESH.with_suffix(".off"), ["info", "FILE"]),
    "ply": (MESH.with_suffix(".ply"), ["setup", "FILE", "--machine", "W/caxyBz/T", "--sphere", "hex:3"]),
    "stl": (ROOT / "datasets/meshes/v-groove.stl", ["info", "FILE"]),
    "path": ("PATH", ["verify", "FILE", "--part", PLANE, "--resolution", "4", "--max-refine", "0"]),
    "path for post": ("PATH", ["post", "FILE", "--arcs", "--lead-in", "ramp"]),
    "path for feed": ("PATH", ["feed", "FILE", "--material", STEEL, "--flutes", "2", "--stock-top", "1", "--cutter",
                               "ball:20"]),
    "gcode": ("GCODE", ["verify", "FILE", "--cutter", "ball:20", "--resolution", "4", "--part", "none"]),
    "apt": ("APT", ["info", "FILE"]),
    "material": (STEEL, ["feed", "PATH", "--material", "FILE", "--flutes", "2", "--stock-top", "1"]),
    "machine": (ROOT / "datasets/machines/ca-table-table.json", ["machine", "FILE"]),
    "control": (ROOT / "datasets/controls/fanuc.json", ["post", "PATH", "--control", "FILE"]),
    "stock": ("STOCK", ["verify", "PATH", "--stock", "FILE", "--resolution", "4", "--max-refine", "0"]),
    "summary": ("SUMMARY", ["info", "COPY"]),
}


def mutant(content, chance):
    """The content with one to three faults."""
    for _ in range(chance.randint(1, 3)):
        lines = content.split(b"\n")
        begin = chance.randrange(len(content) + 1)
        end = min(len(content), begin + chance.choice((1, 1, 4, 50)))
        act = chance.randrange(8)
        if act == 0:
            content = content[:begin] + bytes([chance.randrange(256)]) + content[end:]
        elif act == 1:
            content = content[:begin] + content[end:]
        elif act == 2:
            content = content[:begin] + content[begin:end] * chance.choice((2, 2, 100)) + content[end:]
        elif act == 3:
            content = content[:begin]
        elif act == 4:
            chance.shuffle(lines)
            content = b"\n".join(lines)
        elif act == 5:
            lines[chance.randrange(len(lines))] = chance.choice(lines)
            content = b"\n".join(lines)
        else:
            content = with_other_number(content, begin, chance)
    return content


def with_other_number(content, begin, chance):
    """The number behind `begin` becomes an extreme one."""
    digits = b"0123456789"
    while begin < len(content) and content[begin] not in digits:
        begin += 1
    end = begin
    while end < len(content) and content[end] in digits + b".eE+-":
        end += 1
    return content[:begin] + chance.choice(NUMBERS) + content[end:]


class MutationTest(FaultTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        path = cls.place / "path/u/toolpath.csv"
        cls.sources = {"PATH": path, "SUMMARY": path.parent / "summary.json"}
        for name, words in (("gcode", ["post", path, "--feed", "800", "--spindle-rpm", "6000"]),
                            ("apt", ["post", path, "--feed", "800", "--spindle-rpm", "6000", "--format", "apt"]),
                            ("stock", ["verify", path, "--resolution", "4", "--max-refine", "0", "--write-stock"])):
            subprocess.run([ENDMILL, *words, "--quiet", "-o", cls.place / name], check=False)
            written = [each for each in (cls.place / name).iterdir() if each.suffix in (".ngc", ".apt", ".vti")]
            cls.sources[name.upper()] = written[0]

    def check(self, number):
        chance = random.Random(number)
        kind = sorted(KINDS)[number % len(KINDS)]
        source, words = KINDS[kind]
        source = Path(self.sources.get(source, source))

        def act(folder):
            copy = folder.parent / source.name
            copy.write_bytes(mutant(source.read_bytes(), chance))
            beside = folder.parent / "toolpath.csv"
            if kind == "summary":
                beside.write_bytes(self.sources["PATH"].read_bytes())
            places = {"FILE": copy, "PATH": self.sources["PATH"], "COPY": beside}
            command = [ENDMILL, *(str(places.get(word, word)) for word in words), "-o", str(folder)]
            case = f"mutant {number} ({kind})"
            status, lines = timed_run(command, SECONDS, env=environment(), preexec_fn=lambda: resource.setrlimit(
                resource.RLIMIT_AS, (MEMORY_BYTES,) * 2))
            self.assertIsNotNone(status, f"{case}: longer than {SECONDS} s")
            self.assert_answered(case, status, lines, folder)
        self.in_new_place(act)

    def test_mutants(self):
        self.in_parallel(self.check, [(number,) for number in range(MUTANTS)])


if __name__ == "__main__":
    unittest.main()
