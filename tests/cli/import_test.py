#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill import, and STEP and IGES files as parts of other commands.

Measures are compared with closed forms, surfaces with OpenCASCADE's own. With ENDMILL_FAULTS=long 2000 changed copies
of each of five files are imported, else 12.
"""
import csv
import json
import math
import os
import random
import re
import shutil
import struct
import subprocess
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from program import ENDMILL, ROOT, ProgramTest, endmill

CAD = ROOT / "datasets/cad"
CAD_PROGRAM = Path(ENDMILL).with_name("endmill-cad")
REFERENCE = os.environ.get("ENDMILL_CAD_REFERENCE", str(ROOT / "build/release/tests/cad_reference"))
IS_LONG = os.environ.get("ENDMILL_FAULTS") == "long"
needs_cad = unittest.skipUnless(CAD_PROGRAM.exists(), "endmill was built without OpenCASCADE")


def read_ply(path):
    """Points, triangles and face numbers of a mesh.ply that endmill wrote."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    counts = {line.split()[1]: int(line.split()[2]) for line in head.decode().splitlines() if line.startswith("element")}
    with_faces = b"face_number" in head
    with_normals = b"nx" in head
    size = 48 if with_normals else 24
    points = [struct.unpack_from("<3d", body, size * k) for k in range(counts["vertex"])]
    body = body[size * counts["vertex"]:]
    faces = list(struct.iter_unpack("<B3ii" if with_faces else "<B3i", body))
    return points, [face[1:4] for face in faces], [face[4] for face in faces] if with_faces else []


def basis(degree, knots, u):
    """The B-spline basis functions at u, by the recursion of Cox and de Boor."""
    last = max(k for k in range(len(knots) - 1) if knots[k] < knots[k + 1])
    value = [0.0] * (len(knots) - 1)
    value[next((k for k in range(last) if knots[k] <= u < knots[k + 1]), last)] = 1.0
    for p in range(1, degree + 1):
        for k in range(len(knots) - 1 - p):
            left, right = knots[k + p] - knots[k], knots[k + p + 1] - knots[k + 1]
            value[k] = ((u - knots[k]) / left * value[k] if left else 0) + \
                ((knots[k + p + 1] - u) / right * value[k + 1] if right else 0)
    return value[:len(knots) - 1 - degree]


def spline_point(surface, u, v):
    """A point of a surface file of type nurbs."""
    along_u = basis(surface["degree_u"], surface["knots_u"], u)
    along_v = basis(surface["degree_v"], surface["knots_v"], v)
    total, point = 0, [0, 0, 0]
    for j, row in enumerate(surface["control_points"]):
        for i, control in enumerate(row):
            weight = along_u[i] * along_v[j] * (surface["weights"][j][i] if "weights" in surface else 1)
            total += weight
            point = [point[c] + weight * control[c] for c in range(3)]
    return [coordinate / total for coordinate in point]


def ask_reference(path, queries):
    """The answers of OpenCASCADE to queries such as "value 1 0.5 0.5": lists of numbers."""
    kind = "iges" if path.suffix == ".iges" else "step"
    done = subprocess.run([REFERENCE, kind, path], input="\n".join(queries), capture_output=True, text=True, check=True)
    lines = done.stdout.splitlines()
    return [list(map(float, line.split())) for line in lines[lines.index("answers:") + 1:]]


class CadTest(ProgramTest):
    def imported(self, path, *options):
        """The folder, summary and rows of faces.csv of an import."""
        folder = self.folder / "imported"
        facts = self.summary("import", path, *options, "-o", folder, "--force")
        with (folder / "faces.csv").open() as file:
            return folder, facts, list(csv.DictReader(file))

    def faces(self, path):
        return self.imported(path)[2]


@needs_cad
class Import(CadTest):
    def test_box_is_exact(self):
        _, facts, faces = self.imported(CAD / "assembly.step", "--face", "1,2,3,4,5,6")
        self.assertEqual((facts["triangles"], facts["vertices"], facts["boundary_edges"]), (12, 8, 0))
        self.assertEqual(facts["size_mm"], [60, 40, 8])
        self.assertAlmostEqual(facts["area_mm2"], 2 * (60 * 40 + 60 * 8 + 40 * 8), delta=1e-9)
        self.assertEqual([face["kind"] for face in faces], ["plane"] * 6)

    def test_measures_converge_to_closed_forms_linearly_in_the_tolerance(self):
        cylinder, cone = 500 * math.pi, 260 * math.pi
        sphere, torus = 2048 / 3 * math.pi, 180 * math.pi ** 2
        volume = cylinder + cone + sphere + torus
        # of a cone's frustum: h / 4 (R² + 2 R r + 3 r²) / (R² + R r + r²) above its lower circle
        height = 15 / 4 * (36 + 24 + 12) / (36 + 12 + 4)
        centre = [(20 * cone + 45 * sphere + 75 * torus) / volume, 0,
                  (10 * cylinder + height * cone + 8 * sphere + 3 * torus) / volume]
        area = {1: 200 * math.pi, 4: math.pi * 8 * math.hypot(4, 15), 7: 256 * math.pi, 8: 120 * math.pi ** 2}
        for name in ("primitives.step", "primitives.iges"):
            errors = []
            for tolerance in (0.2, 0.0125):
                folder, facts, _ = self.imported(CAD / name, "--chord-tolerance", tolerance, "--angle-deg", 90)
                self.assertEqual((facts["boundary_edges"], facts["solids"]), (0, 4))
                points, triangles, numbers = read_ply(folder / "mesh.ply")
                meshed = dict.fromkeys(area, 0)
                for (a, b, c), number in zip(triangles, numbers):
                    if number in meshed:
                        meshed[number] += triangle_area(points[a], points[b], points[c])
                # all are convex, but for the inside of the torus
                self.assertLess(facts["volume_mm3"], volume)
                errors.append([volume - facts["volume_mm3"], *(abs(area[k] - meshed[k]) for k in area),
                               math.dist(facts["centre_mm"], centre)])
            for coarse, fine in zip(*errors):
                self.assertLess(fine, coarse / 16 ** 0.7, (name, errors))
            self.assertLess(errors[1][0] / volume, 0.005)
            for measured, expected in ((facts["of_faces"]["volume_mm3"], volume),
                                       (math.dist(facts["of_faces"]["centre_mm"], centre), 0)):
                self.assertAlmostEqual(measured, expected, delta=1e-5)

    def test_measures_of_a_free_form_converge_to_the_integrals_over_its_faces(self):
        for name in ("mould.step", "pillow.step", "bracket-inch.step", "assembly.step"):
            errors = []
            for tolerance in (0.1, 0.1 / 16):
                facts = self.imported(CAD / name, "--chord-tolerance", tolerance, "--angle-deg", 90)[1]
                self.assertEqual(facts["boundary_edges"], 0)
                true = facts["of_faces"]
                errors.append([abs(true["volume_mm3"] - facts["volume_mm3"]) / true["volume_mm3"],
                               abs(true["area_mm2"] - facts["area_mm2"]) / true["area_mm2"],
                               math.dist(true["centre_mm"], facts["centre_mm"]) / max(facts["size_mm"])])
                if name == "pillow.step":
                    # a rectangle from above, 12 mm high
                    self.assertAlmostEqual(facts["volume_mm3"], 12 * 40 * 30, delta=1200 * tolerance)
            for coarse, fine in zip(*errors):
                # OpenCASCADE's own integrals are this accurate
                self.assertLess(fine, max(coarse / 16 ** 0.6, 2e-5), (name, errors))

    @unittest.skipUnless(Path(REFERENCE).exists(), "cad_reference is not built")
    def test_surfaces_are_those_of_opencascade(self):
        for name in ("primitives.step", "primitives.iges", "pillow.step", "pillow.iges", "mould.step", "bracket-inch.step"):
            with self.subTest(name=name):
                folder, _, faces = self.imported(CAD / name)
                values, distances, points = [], [], []
                for face in faces:
                    if not face["surface"]:
                        continue
                    number = face["face"]
                    surface = json.loads((folder / face["surface"]).read_text())
                    self.summary("sample", folder / face["surface"], "--grid", 6, "--format", "ply", "-o",
                                 folder / f"sampled{number}", "--force")
                    for point in read_ply(folder / f"sampled{number}" / "mesh.ply")[0]:
                        distances.append(f"distance {number} {point[0]!r} {point[1]!r} {point[2]!r}")
                    if face["kind"] not in ("nurbs", "plane"):
                        continue
                    # the parameters are the same too
                    for i in range(8):
                        low_u, *_, high_u = surface["knots_u"]
                        low_v, *_, high_v = surface["knots_v"]
                        u, v = low_u + (high_u - low_u) * i / 7, low_v + (high_v - low_v) * (3 * i % 8) / 7
                        values.append(f"value {number} {u!r} {v!r}")
                        points.append(spline_point(surface, u, v))
                self.assertLess(max(answer[0] for answer in ask_reference(CAD / name, distances)), 1e-9)
                for answer, point in zip(ask_reference(CAD / name, values), points, strict=True):
                    self.assertLess(math.dist(answer, point), 1e-9)

    def test_surfaces_face_outwards(self):
        folder, facts, faces = self.imported(CAD / "pillow.step")
        self.assertEqual(facts["surfaces"], 6)
        sums = [0, 0]
        for face in faces:
            self.summary("sample", folder / face["surface"], "--grid", 40, "--format", "ply", "-o", folder / "sampled", "--force")
            points, triangles, _ = read_ply(folder / "sampled" / "mesh.ply")
            for a, b, c in triangles:
                sums[0] += triangle_area(points[a], points[b], points[c])
                sums[1] += tetrahedron(points[a], points[b], points[c])
        self.assertAlmostEqual(sums[0], facts["of_faces"]["area_mm2"], delta=1)
        self.assertAlmostEqual(sums[1], facts["of_faces"]["volume_mm3"], delta=20)

    def test_step_and_iges_have_the_same_faces(self):
        for name in ("primitives", "pillow", "mould"):
            described = [sorted((face["kind"], face["trimmed"], round(float(face["area_mm2"]), 2))
                                for face in self.faces(CAD / (name + extension))) for extension in (".step", ".iges")]
            self.assertEqual(len(described[0]), len(described[1]))
            for one, other in zip(*described):
                self.assertEqual(one[:2], other[:2])
                self.assertAlmostEqual(one[2], other[2], delta=0.02)

    def test_inches_are_converted_and_reported(self):
        _, facts, faces = self.imported(CAD / "bracket-inch.step")
        self.assertEqual(facts["unit"], "INCH")
        for size, inches in zip(facts["size_mm"], (3, 2, 0.5)):
            self.assertAlmostEqual(size, 25.4 * inches, delta=1e-9)
        # a quarter circle of radius 1/8 along 2 inches
        fillet = min(faces, key=lambda face: abs(float(face["area_mm2"]) - math.pi / 8 * 25.4 ** 2 * math.pi / 8))
        quarter = [face for face in faces if face["kind"] == "cylinder" and face["trimmed"] == "no"]
        self.assertIn(round(math.pi / 2 / 8 * 2 * 25.4 ** 2, 6), [round(float(face["area_mm2"]), 6) for face in quarter])
        self.assertIsNotNone(fillet)

    def test_assembly_has_each_part_where_it_stands_with_colours_and_names(self):
        folder, facts, faces = self.imported(CAD / "assembly.step")
        self.assertEqual((facts["solids"], facts["faces"]), (3, 12))
        self.assertAlmostEqual(facts["of_faces"]["volume_mm3"], 19200 + 1000 * math.pi, delta=1e-6)
        self.assertEqual([(face["face"], face["name"], face["colour"]) for face in faces if face["name"]],
                         [("6", "top", "#ff8000"), ("7", "shaft", "#808080"), ("10", "shaft", "#808080")])
        points, triangles, numbers = read_ply(folder / "mesh.ply")
        for number, x in ((7, 15), (10, 45)):
            used = {corner for triangle, face in zip(triangles, numbers) if face == number for corner in triangle}
            for corner in used:
                self.assertAlmostEqual(math.hypot(points[corner][0] - x, points[corner][1] - 20), 5, delta=1e-6)

    def test_largest_ball_of_a_hole_is_its_radius(self):
        holes = [face for face in self.faces(CAD / "bracket-inch.step") if face["ball"] == "limited"]
        self.assertEqual(len(holes), 2)
        for hole in holes:
            self.assertAlmostEqual(float(hole["max_cutter_radius_local_mm"]), 25.4 / 4, delta=1e-6)

    def test_largest_balls_of_trimmed_faces(self):
        # the top is the height 2 sin(x / 12) cos(y / 15), whose troughs have the radius 72 mm, through points 5 mm apart; the edges are
        # rounded by 6 mm
        for name in ("mould.step", "mould.iges"):
            faces = self.faces(CAD / name)
            self.assertEqual({face["ball"] for face in faces if face["kind"] != "nurbs"}, {"unlimited"})
            top = next(face for face in faces if face["kind"] == "nurbs")
            self.assertAlmostEqual(float(top["max_cutter_radius_local_mm"]), 72, delta=1.5)
        # an oblique hole of radius 4
        _, facts, faces = self.imported(CAD / "tray.step")
        self.assertAlmostEqual(facts["of_faces"]["volume_mm3"], 42400 - 440 * math.pi, delta=0.5)
        hole = [face for face in faces if face["kind"] == "cylinder" and face["trimmed"] == "yes"]
        self.assertEqual([face["ball"] for face in hole], ["limited"])
        self.assertAlmostEqual(float(hole[0]["max_cutter_radius_local_mm"]), 4, delta=1e-6)

    def test_mesh_reads_back_with_its_face_numbers(self):
        folder, facts, _ = self.imported(CAD / "mould.step", "--chord-tolerance", 0.1)
        back = self.summary("info", folder / "mesh.ply")
        self.assertEqual((back["triangles"], back["boundary_edges"]), (facts["triangles"], 0))
        self.assertAlmostEqual(back["volume_mm3"], facts["volume_mm3"], delta=1e-6)
        self.assertEqual(sorted(set(read_ply(folder / "mesh.ply")[2])), list(range(1, 11)))

    def test_some_faces(self):
        folder, facts, faces = self.imported(CAD / "pillow.step", "--face", "5", "2", "2")
        self.assertEqual([face["face"] for face in faces], ["2", "5"])
        self.assertEqual(sorted(path.name for path in (folder / "surfaces").iterdir()), ["face-2.json", "face-5.json"])
        self.assertEqual(sorted(set(read_ply(folder / "mesh.ply")[2])), [2, 5])
        self.assertEqual((facts["faces"], facts["faces_written"]), (6, 2))
        self.assertGreater(facts["boundary_edges"], 0)
        for word in ("0", "7", "x", "1.5"):
            self.assert_refused(endmill("import", CAD / "pillow.step", "--face", word, "-o", self.folder / "no"), 2, "--face")
        # a later import of fewer faces leaves no surface of an earlier one
        self.imported(CAD / "pillow.step", "--face", "1")
        self.assertEqual([path.name for path in (folder / "surfaces").iterdir()], ["face-1.json"])

    def test_bytes_do_not_depend_on_the_run_or_the_threads(self):
        texts = []
        for threads in (1, 2):
            folder = self.imported(CAD / "mould.step", "--threads", threads)[0]
            texts.append([(folder / name).read_bytes() for name in ("mesh.ply", "faces.csv", "summary.json")])
        self.assertEqual(texts[0], texts[1])

    def test_path_with_spaces_and_other_letters(self):
        name = self.folder / "Gehäuse № 1 (neu)" / "Teil ä.STP"
        name.parent.mkdir()
        shutil.copy(CAD / "assembly.step", name)
        self.assertEqual(self.imported(name)[1]["faces"], 12)
        self.assertEqual(self.summary("info", name)["triangles"], self.imported(name)[1]["triangles"])


def as_shell(text, only=None):
    """The text of a STEP file of one solid with a shell in its place, of all its faces or of one of them."""
    text = text.replace("ADVANCED_BREP_SHAPE_REPRESENTATION", "MANIFOLD_SURFACE_SHAPE_REPRESENTATION")
    text = re.sub(r"MANIFOLD_SOLID_BREP\('',(#\d+)\)", r"SHELL_BASED_SURFACE_MODEL('',(\1))", text)
    faces = re.search(r"CLOSED_SHELL\('',\(([^)]*)\)\)", text).group(1).split(",")
    return re.sub(r"CLOSED_SHELL\('',\([^)]*\)\)", f"OPEN_SHELL('',({','.join([faces[only - 1]] if only else faces)}))", text)


def pocket(upright_with_floor=False):
    """A mesh file (PLY) of a block of 60 by 40 by 20 mm with a pocket of 40 by 20 by 8 mm. Faces: 1 bottom, 2 to 5 outer sides, 6 top,
    7 to 10 sides of the pocket, 11 its floor, with the side at y = 10 if wanted."""
    block, hole, floor, top = ((0, 0), (60, 0), (60, 40), (0, 40)), ((10, 10), (50, 10), (50, 30), (10, 30)), 12, 20
    quads = [([(*corner, 0) for corner in reversed(block)], 1), ([(*corner, floor) for corner in hole], 11)]
    for k in range(4):
        after = (k + 1) % 4
        quads.append(([(*block[k], 0), (*block[after], 0), (*block[after], top), (*block[k], top)], 2 + k))
        quads.append(([(*block[k], top), (*block[after], top), (*hole[after], top), (*hole[k], top)], 6))
        side = 11 if upright_with_floor and k == 0 else 7 + k
        quads.append(([(*hole[k], top), (*hole[after], top), (*hole[after], floor), (*hole[k], floor)], side))
    points = sorted({corner for quad, _ in quads for corner in quad})
    triangles = [([quad[0], quad[m], quad[m + 1]], face) for quad, face in quads for m in (1, 2)]
    return "\n".join(["ply", "format ascii 1.0", f"element vertex {len(points)}", *(f"property double {axis}" for axis in "xyz"),
                      f"element face {len(triangles)}", "property list uchar int vertex_indices", "property int face_number", "end_header",
                      *(" ".join(map(str, point)) for point in points),
                      *(f"3 {' '.join(str(points.index(corner)) for corner in triangle)} {face}" for triangle, face in triangles)]) + "\n"


def triangle_area(a, b, c):
    u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
    return math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2


def tetrahedron(a, b, c):
    """The signed volume between a triangle and the origin."""
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6


@needs_cad
class PartsOfCommands(CadTest):
    def test_info_is_that_of_the_mesh_and_keeps_nothing(self):
        direct = self.summary("info", CAD / "mould.step")
        folder = self.imported(CAD / "mould.step")[0]
        through = self.summary("info", folder / "mesh.ply")
        self.assertEqual((direct["triangles"], direct["volume_mm3"]), (through["triangles"], through["volume_mm3"]))
        self.assert_nothing_left("imported")

    def test_plan_of_faces_in_two_commands(self):
        facts = self.summary("plan", CAD / "mould.step", "--face", 1, "--cutter", "ball:10", "--scallop", 0.3, "--strategy",
                             "planar", "--feed", 2000, "-o", "plan")
        self.assertEqual((facts["verdict"], facts["cut_faces"]), ("clean", [1]))
        self.assertLessEqual(facts["protected_max_gouge_mm"], facts["inner_tolerance_mm"])
        kept = list((self.folder / ".endmill-cad").iterdir())
        self.assertEqual(len(kept), 1)
        seen = self.summary("verify", "plan/toolpath.csv", "--resolution", 0.5, "-o", "seen")
        self.assertEqual((seen["verdict"], seen["cut_faces"]), ("clean", [1]))
        self.assertEqual(list((self.folder / ".endmill-cad").iterdir()), kept)
        # the mesh of the import gives the same path
        folder = self.imported(CAD / "mould.step")[0]
        self.summary("plan", folder / "mesh.ply", "--face", 1, "--cutter", "ball:10", "--scallop", 0.3, "--strategy", "planar",
                     "--feed", 2000, "-o", "again")
        for name in ("toolpath.csv", "toolpath.vtp"):
            self.assertEqual((self.folder / "again" / name).read_bytes(), (self.folder / "plan" / name).read_bytes())

    def test_floor_of_a_pocket_is_cut_by_every_strategy(self):
        # the floor is two triangles whose corners the ball cannot reach: a ball of radius 3 reaches 34 by 14 mm of its 40 by 20 mm
        part = self.file(pocket(), "pocket.ply")
        for strategy in ("best", "planar", "iso-scallop", "field"):
            facts = self.summary("plan", part, "--face", 11, "--cutter", "ball:6", "--scallop", 0.1, "--strategy", strategy, "-o", strategy)
            self.assertEqual(facts["verdict"], "clean", strategy)
            self.assertAlmostEqual(facts["unreached_mm2"], 40 * 20 - 34 * 14, delta=20, msg=strategy)
            with (self.folder / strategy / "toolpath.csv").open() as file:
                cuts = [row for row in csv.DictReader(file) if row["move"] == "cut"]
            for row in cuts:
                self.assertAlmostEqual(float(row["tip_z_mm"]), 12, delta=0.12)
                self.assertTrue(13 <= float(row["tip_x_mm"]) <= 47 and 13 <= float(row["tip_y_mm"]) <= 27, (strategy, row))

    def test_what_chosen_faces_leave_is_said(self):
        part = self.file(pocket(upright_with_floor=True), "pocket.ply")
        run = self.run_plan_of_floor(part)
        self.assertIn("warning: 320 mm2 of the chosen faces are upright or face away from the tool; they are neither cut nor judged",
                      run.stderr)
        self.assertNotIn("chosen faces", self.run_plan_of_floor(self.file(pocket(), "plain.ply")).stderr)

    def run_plan_of_floor(self, part):
        run = endmill("plan", part, "--face", 11, "--cutter", "ball:6", "--scallop", 0.2, "--strategy", "field", "--force", "-o",
                      self.folder / "floor")
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def test_part_that_changed_since_its_faces_were_chosen_is_refused(self):
        part = self.file(pocket(), "pocket.ply")
        self.run_plan_of_floor(part)
        self.summary("verify", "floor/toolpath.csv", "-o", "seen")
        part.write_text(part.read_text() + "\n")
        refused = endmill("verify", "floor/toolpath.csv", "-o", "again", cwd=self.folder)
        self.assert_refused(refused, 2, "part_sha256")
        self.assertFalse((self.folder / "again").exists())
        # the sides of the pocket now count
        seen = self.summary("verify", "floor/toolpath.csv", "--part", part, "-o", "again", status=1)
        self.assertNotIn("cut_faces", seen)

    def test_faces_are_whole_numbers_between_commas(self):
        for words in (["1,,2"], ["1,"], [","], ["", "1"], ["1", "2,"]):
            self.assert_refused(endmill("plan", CAD / "mould.step", "--cutter", "ball:6", "-o", self.folder / "no", "--face", *words), 2,
                                'found ""')

    def test_uncut_faces_are_protected(self):
        # the floor of the plate lies around the pins, whose sides would be gouged by passes across them
        facts = self.summary("plan", CAD / "assembly.step", "--face", 6, "--cutter", "ball:6", "--scallop", 0.3, "--strategy",
                             "planar", "-o", "plan")
        self.assertLessEqual(facts["protected_max_gouge_mm"], facts["inner_tolerance_mm"])
        with (self.folder / "plan/toolpath.csv").open() as file:
            for row in csv.DictReader(file):
                x, y, z = (float(row[f"tip_{axis}_mm"]) for axis in "xyz")
                if z < 25:
                    for pin in (15, 45):
                        self.assertGreater(math.hypot(x - pin, y - 20), 5 + 3 - 0.02)
                    self.assertGreater(z, 8 - 0.02)

    def test_sheet_of_one_face_is_a_surface(self):
        sheet = self.file(as_shell((CAD / "pillow.step").read_text(), only=5), "sheet.step")
        facts = self.summary("info", sheet)
        folder = self.imported(CAD / "pillow.step")[0]
        solid = self.summary("info", folder / "surfaces/face-5.json")
        for key in ("area_mm2", "patches", "continuity", "max_cutter_radius_mm"):
            self.assertEqual(facts[key], solid[key])
        self.assertEqual(self.summary("sample", sheet, "--grid", 5, "-o", "sampled")["triangles"], 32)
        plan = self.summary("plan", sheet, "--cutter", "ball:6", "--scallop", 0.5, "--strategy", "iso-u", "--bound", "none", "-o", "plan")
        self.assertEqual(plan["verdict"], "clean")
        self.assert_refused(endmill("sample", CAD / "pillow.step", "-o", self.folder / "no", cwd=self.folder), 2, "found a mesh")

    def test_faces_need_face_numbers(self):
        for part in (ROOT / "datasets/meshes/pocket.stl", ROOT / "datasets/surfaces/saddle.json"):
            self.assert_refused(endmill("plan", part, "--face", 1, "--cutter", "ball:6", "--strategy", "planar", "-o",
                                        self.folder / "no"), 2, "--face", "no face numbers")
        self.assert_refused(endmill("plan", CAD / "pillow.step", "--face", 9, "--cutter", "ball:6", "--strategy", "planar",
                                    "-o", self.folder / "no"), 2, "--face 9")
        self.assert_refused(endmill("plan", CAD / "pillow.step", "--face", 5, "--cutter", "flat:6", "--strategy", "planar",
                                    "-o", self.folder / "no"), 2, "--face")

    def test_other_commands_take_the_file(self):
        part = CAD / "mould.step"
        self.summary("trim", part, "--cutter", "ball:10", "--planes", 5, "--direction-deg", 0, "-o", "trim")
        facts = self.summary("setup", part, "--machine", "W/caxyBz/T", "-o", "setup", "--sphere", "ico:2")
        self.assertEqual(facts["facets"], self.summary("info", part)["triangles"])
        self.summary("plan", part, "--face", 1, "--cutter", "ball:10", "--scallop", 0.5, "--strategy", "planar", "--feed", 1000,
                     "-o", "plan")
        self.summary("verify", "plan/toolpath.csv", "--part", part, "--resolution", 1, "-o", "verify")
        self.assertEqual(len(list((self.folder / ".endmill-cad").iterdir())), 1)

    def test_cached_part_is_used_again_and_made_anew_when_the_file_changes(self):
        part = self.folder / "part.step"
        shutil.copy(CAD / "assembly.step", part)
        cache = self.folder / ".endmill-cad"
        arguments = ("info", part, "-o", "out", "--force")
        first = self.summary(*arguments)
        (kept,) = cache.iterdir()
        stamp = kept.stat().st_mtime_ns
        self.assertEqual(self.summary(*arguments), first)
        self.assertEqual(kept.stat().st_mtime_ns, stamp)
        kept.write_bytes(kept.read_bytes()[:-5])  # damaged: made again
        self.assertEqual(self.summary(*arguments), first)
        self.assertGreater(kept.stat().st_mtime_ns, stamp)
        shutil.copy(CAD / "pillow.step", part)
        self.assertNotEqual(self.summary(*arguments)["triangles"], first["triangles"])
        self.assertEqual(len(list(cache.iterdir())), 2)

    def test_units_and_axis(self):
        self.assert_refused(endmill("info", CAD / "mould.step", "--units", "inch"), 2, "--units", "states its own unit")
        upright = self.summary("info", CAD / "assembly.step")["size_mm"]
        turned = self.summary("info", CAD / "assembly.step", "--up", "x")["size_mm"]
        self.assertEqual(turned, [upright[2], upright[1], upright[0]])


@needs_cad
class BadInput(CadTest):
    """A file that is no sound CAD file ends in exit 3 or 6 with one line, and leaves nothing."""

    def refused(self, path, status, *words, options=()):
        before = sorted(path.name for path in self.folder.iterdir())
        done = endmill("import", path, "-o", self.folder / "out", *options)
        self.assert_refused(done, status, path.name, *words)
        self.assert_nothing_left(*before)

    def step(self, text, name="part.step"):
        return self.file(text, name)

    def test_files_that_are_none(self):
        whole = (CAD / "assembly.step").read_text()
        for content, word in (("", "empty"), ("  \n", "empty"), ("solid a\n", "not STEP"), (b"\x1f\x8b\x08\x00", "compressed"),
                              ("ISO-10303-21;\n", ""), ("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n", "")):
            self.refused(self.step(content), 3, word)
            self.refused(self.step(content, "part.igs"), 3)
        self.refused(self.step(whole, "part.iges"), 3)
        self.refused(self.folder / "missing.step", 3, "No such file")
        (self.folder / "folder.step").mkdir()
        self.refused(self.folder / "folder.step", 3, "directory")
        self.refused(self.step(whole, "part.stl"), 3, ".step, .stp, .iges or .igs")

    def test_no_faces(self):
        whole = (CAD / "assembly.step").read_text()
        self.refused(self.step(whole.replace("MANIFOLD_SOLID_BREP('',", "VERTEX_SHELL('',")), 3)

    def test_solid_without_a_solid(self):
        _, facts, _ = self.imported(self.step(as_shell((CAD / "pillow.step").read_text())))
        self.assertEqual((facts["solids"], facts["shells"], facts["faces"]), (0, 1, 6))
        self.assertIsNone(facts["of_faces"]["volume_mm3"])

    def test_missing_units_are_noted(self):
        text = (CAD / "assembly.step").read_text()
        without = text.replace("( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )", "( NAMED_UNIT(*) )")
        self.assertNotEqual(text, without)
        done = endmill("import", self.step(without), "-o", self.folder / "out", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("names no unit of length", done.stderr)
        self.assertIsNone(json.loads(done.stdout)["unit"])
        self.assertEqual(json.loads(done.stdout)["size_mm"], [60, 40, 28])

    def test_cycles_of_references(self):
        text = (CAD / "assembly.step").read_text()
        face = next(line.split(" = ")[0] for line in text.splitlines() if "FACE_BOUND('" in line)
        loops = text.replace(f"{face} = FACE_BOUND('',", f"{face} = FACE_BOUND('',{face},.T.);\n#999999 = FACE_BOUND('',")
        self.check_end(self.step(loops))
        # the assembly is a part of itself
        usage = next(line for line in text.splitlines() if "NEXT_ASSEMBLY_USAGE_OCCURRENCE('1'" in line)
        whole, part = usage.split(",")[3:5]
        self.check_end(self.step(text.replace(usage, usage.replace(f"{whole},{part}", f"{part},{part}"))))
        self.check_end(self.step(text.replace(usage, usage.replace(f"{whole},{part}", f"{part},{whole}"))))

    def check_end(self, path):
        """Imports a damaged file: it is done, refused or at a limit, with one line in the last two cases."""
        done = endmill("import", path, "-o", path.with_suffix(".out"), "--limit-seconds", 20, "--chord-tolerance", 0.1,
                       "--quiet")
        self.assertIn(done.returncode, (0, 3, 6), (path, done.stderr))
        if done.returncode:
            self.assertFalse(path.with_suffix(".out").exists())
            self.assertRegex(done.stderr, r"\Aendmill: error: .*\n\Z")
        shutil.rmtree(path.with_suffix(".out"), ignore_errors=True)
        return done.returncode

    def test_truncation_at_every_kilobyte(self):
        for name in ("assembly.step", "primitives.iges"):
            whole = (CAD / name).read_bytes()
            paths = [self.file(whole[:size], f"{size}-{name}") for size in range(1024, len(whole), 1024)]
            with ThreadPoolExecutor(os.cpu_count()) as pool:
                ends = list(pool.map(self.check_end, paths))
            self.assertIn(3, ends)

    def test_changed_copies(self):
        rounds = 2000 if IS_LONG else 12
        for name in ("assembly.step", "primitives.step", "pillow.step", "bracket-inch.step", "primitives.iges"):
            whole = (CAD / name).read_bytes()

            def one(number, name=name, whole=whole):
                path = self.file(changed(whole, random.Random(f"{name} {number}")), f"{number}-{name}")
                end = self.check_end(path)
                path.unlink()
                return end
            with ThreadPoolExecutor(os.cpu_count()) as pool:
                ends = list(pool.map(one, range(rounds)))
            if IS_LONG:
                print(name, {end: ends.count(end) for end in sorted(set(ends))}, flush=True)

    def test_limits(self):
        path = CAD / "primitives.step"
        for options, words in ((("--max-faces", 7), ("has 8 faces", "the limit is 7", "--max-faces")),
                               (("--limit-seconds", 0.02), ("--limit-seconds",)),
                               (("--max-memory", 1e-4), ())):
            done = endmill("import", path, "-o", self.folder / "out", *options)
            self.assert_refused(done, 6, *words)
        # too little memory to mesh so finely
        for gib in (0.25, 0.4):
            done = endmill("import", path, "-o", self.folder / "out", "--limit-gib", gib, "--chord-tolerance", 1e-6)
            self.assertIn(done.returncode, (3, 6), done.stderr)
            self.assertIn("--limit-gib", done.stderr)
        self.assert_nothing_left()

    def test_million_faces(self):
        text = (CAD / "assembly.step").read_text()
        face = next(line for line in text.splitlines() if "ADVANCED_FACE('" in line)
        bounds = face[face.index("("):]
        copies = "".join(f"#{2000000 + k} = ADVANCED_FACE{bounds}\n" for k in range(1000000))
        head, tail = text.rsplit("ENDSEC;", 1)
        self.refused(self.step(head + copies + "ENDSEC;" + tail), 6, "has 1000009 faces", "the limit is 100000",
                     options=("--limit-seconds", 120))

    def test_killed_child(self):
        slow = ("import", CAD / "primitives.step", "-o", self.folder / "out", "--chord-tolerance", "1e-6")
        with subprocess.Popen([ENDMILL, *map(str, slow)], stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True) as process:
            children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
            while not (child := children.read_text().split()):
                self.assertIsNone(process.poll())
            os.kill(int(child[0]), 9)
            _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 6, errors)
        self.assertIn("was killed", errors)
        self.assert_nothing_left()


class WithoutOpenCascade(ProgramTest):
    def test_says_what_is_missing(self):
        alone = self.folder / "endmill"
        shutil.copy(ENDMILL, alone)
        for command in (("import",), ("info",)):
            done = subprocess.run([alone, *command, CAD / "mould.step"], capture_output=True, text=True, check=False,
                                  cwd=self.folder)
            self.assert_refused(done, 2, "libocct-data-exchange-dev", "libocct-modeling-algorithms-dev")
        said = subprocess.run([alone, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertIn("without endmill-cad", said)
        self.assert_nothing_left("endmill")


def changed(whole, rng):
    """A copy with some bytes replaced, removed or repeated, or digits changed."""
    copy = bytearray(whole)
    for _ in range(rng.choice((1, 1, 2, 5, 20))):
        at = rng.randrange(len(copy))
        match rng.randrange(4):
            case 0:
                copy[at] = rng.randrange(256)
            case 1:
                del copy[at:at + rng.randrange(1, 40)]
            case 2:
                other = rng.randrange(len(copy))
                copy[at:at] = copy[other:other + rng.randrange(1, 60)]
            case _:
                digits = [k for k in range(at, min(at + 200, len(copy))) if 48 <= copy[k] < 58]
                if digits:
                    copy[digits[0]] = rng.choice(b"0123456789")
    return bytes(copy)


if __name__ == "__main__":
    unittest.main()
