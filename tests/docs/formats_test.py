# SPDX-License-Identifier: GPL-3.0-or-later
"""The program reads every example of an input file in docs/file-formats.md.

The info string of the fenced block of an example names its format.
"""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("ENDMILL", ROOT / "build/release/src/cli/endmill")).resolve()
MESH = ROOT / "datasets/meshes/prism.off"
PAGE = ROOT / "docs/file-formats.md"
BLOCK = re.compile(r"^```(\w+ [\w/-]+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)

# Maps an info string to the name of the file and the command that reads it.
READERS = {
    "json endmill-surface/1": ("surface.json", "info FILE"),
    "stl mesh": ("mesh.stl", "info FILE"),
    "obj mesh": ("mesh.obj", "info FILE"),
    "off mesh": ("mesh.off", "info FILE"),
    "ply mesh": ("mesh.ply", "info FILE"),
    "csv tool-path": ("path.csv", "post FILE --feed 500"),
    "gcode program": ("path.ngc", "post FILE --feed 500"),
    "canonical program": ("path.ngc", "post FILE --feed 500"),
    "apt program": ("path.apt", "post FILE --feed 500"),
    "json endmill-machine/1": ("machine.json", "machine FILE"),
    "json endmill-control/1": ("control.json", "post PATH --feed 500 --control FILE"),
    "json endmill-material/1": ("material.json",
                                "coefficients --material FILE --cutter ball:10 --flutes 2 --feed-per-tooth 0.05"
                                " --mu-deg 10 --lambda-deg 20 --pick-feed-ratio 0.5 --depth-ratio 1"),
    "json endmill-tool/1": ("tool.json", "verify PATH --part none --tool FILE"),
    "json endmill-job/1": ("job.json", "run FILE --dry-run"),
    "json endmill-sweep/1": ("sweep.json", "sweep FILE"),
    "json endmill-tools/1": ("tools.json", "verify PATH --part none --tools FILE"),
    "tbl tool-table": ("tools.tbl", "verify PATH --part none --tools FILE --tools-units mm"),
    "csv polyline": ("curves.csv", "trim --polyline FILE"),
    "csv tool-life": ("speeds.csv", "toollife FILE --tool-change-min 1 --tool-cost 5"
                      " --machine-cost-per-min 0.5"),
    "text facet-list": ("facets.txt", "setup MESH --machine W/xyBz/T --sphere ico:0 --skip-facets FILE"),
    "csv directions": ("directions.csv", "setup --points FILE --family CA"),
}


class Formats(unittest.TestCase):
    def test_program_reads_every_example(self):
        examples = BLOCK.findall(PAGE.read_text(encoding="utf-8"))
        self.assertGreater(len(examples), 10)
        for kind, text in examples:
            with self.subTest(kind=kind), tempfile.TemporaryDirectory() as folder:
                self.assertIn(kind, READERS)
                name, command = READERS[kind]
                (Path(folder) / name).write_text(text, encoding="utf-8")
                shutil.copy(MESH, folder)  # the part of the job
                (Path(folder) / "tips.csv").write_text("tip_x_mm,tip_y_mm,tip_z_mm,tool\n0,0,0,1\n10,0,0,1\n")
                words = command.replace("FILE", name).replace("PATH", "tips.csv").replace("MESH", str(MESH)).split()
                done = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True,
                                      check=False, stdin=subprocess.DEVNULL, timeout=60)
                self.assertIn(done.returncode, (0, 1), f"{kind}: {words}\n{text}\n{done.stderr}")

    def test_every_format_has_an_example(self):
        kinds = {kind for kind, _ in BLOCK.findall(PAGE.read_text(encoding="utf-8"))}
        self.assertEqual(kinds, set(READERS))


if __name__ == "__main__":
    unittest.main()
