# SPDX-License-Identifier: GPL-3.0-or-later
"""Values and functions with arrays, against closed forms and numpy."""
import math

import endmill
import numpy as np
import pytest
from conftest import net


def sphere_octant(radius):
    """An eighth of a sphere as a rational biquadratic NURBS, by the textbook."""
    w = math.sqrt(0.5)
    circle = [((1, 0), 1), ((1, 1), w), ((0, 1), 1)]
    points = [[(radius * r * x, radius * r * y, radius * z) for (x, y), _ in circle]
              for (r, z), _ in circle]
    weights = [[a * b for _, a in circle] for _, b in circle]
    knots = [0, 0, 0, 1, 1, 1]
    return endmill.Surface.nurbs(2, 2, knots, knots, points, weights)


class TestSurface:

    def test_points_of_a_sphere_have_its_radius(self):
        u, v = np.meshgrid(np.linspace(0, 1, 30), np.linspace(0, 1, 40))
        points = sphere_octant(20).point(u, v)
        assert points.shape == (40, 30, 3)
        assert np.linalg.norm(points, axis=-1) == pytest.approx(np.full((40, 30), 20), abs=1e-12)

    def test_normals_and_curvature_of_a_sphere(self):
        surface = sphere_octant(20)
        u, v = np.linspace(0.1, 0.9, 9), 0.4
        assert surface.normal(u, v) == pytest.approx(surface.point(u, v) / 20, abs=1e-12)
        assert surface.curvature(u, v) == pytest.approx(np.full((9, 2), 1 / 20), abs=1e-12)

    def test_derivatives_are_limits_of_differences(self):
        surface = endmill.Surface.bezier(net(np.random.default_rng(3).uniform(0, 9, (4, 7))))
        u, v, h = 0.7, 0.3, 1e-4
        du, dv, duu, _, _ = surface.derivatives(u, v)
        ahead, at, behind = (surface.point(u + step, v) for step in (h, 0, -h))
        assert du == pytest.approx((ahead - behind) / (2 * h), abs=1e-5)
        assert duu == pytest.approx((ahead - 2 * at + behind) / h**2, abs=1e-4)
        assert dv == pytest.approx((surface.point(u, v + h) - surface.point(u, v - h)) / (2 * h),
                                   abs=1e-5)

    def test_height_grid_reproduces_a_cubic(self):
        x, y = np.linspace(0, 4, 7), np.linspace(-2, 2, 6)
        cubic = lambda a, b: a**3 - 2 * a * b + b**2
        surface = endmill.Surface.height_grid(x, y, cubic(x[None, :], y[:, None]))
        u, v = np.random.default_rng(1).uniform([0, -2], [4, 2], (50, 2)).T
        assert surface.point(u, v)[:, 2] == pytest.approx(cubic(u, v), abs=1e-11)

    def test_the_written_surface_has_the_same_points(self, tmp_path):
        file = tmp_path / "s.json"
        u, v = np.random.default_rng(2).uniform(0, 1, (2, 100))
        for surface in (endmill.Surface.bezier(net(np.arange(70.).reshape(7, 10)**1.3)),
                        sphere_octant(5)):
            file.write_text(surface._text("s"))
            again = endmill.read_part(file).surfaces[0]
            assert again.range_u == surface.range_u
            assert again.point(u, v) == pytest.approx(surface.point(u, v), abs=1e-13)

    def test_largest_ball_of_a_trough_is_its_circle(self):
        w = math.sqrt(0.5)
        points = [[(-7, y, 0), (0, y, -7), (7, y, 0)] for y in (0, 30)]
        trough = endmill.Surface.nurbs(2, 1, [0, 0, 0, 1, 1, 1], [0, 0, 1, 1], points,
                                       [[1, w, 1]] * 2)
        assert trough.largest_ball() == pytest.approx(2 * 7 * math.sqrt(2), rel=1e-6)

    def test_sample_is_near_the_surface(self):
        mesh = sphere_octant(20).sample(0.01)
        corners = mesh.points[mesh.triangles]
        depth = 20 - np.linalg.norm(corners.mean(axis=1), axis=-1)
        assert depth.min() >= -1e-12 and depth.max() <= 0.01


class TestMesh:

    def test_report_of_a_tetrahedron(self):
        points = [[0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 5]]
        report = endmill.Mesh(points, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).report()
        assert report["volume_mm3"] == pytest.approx(3 * 4 * 5 / 6)
        assert report["is_closed"]

    def test_views_are_not_copies_and_outlive_the_mesh(self):
        mesh = endmill.Mesh(np.eye(3), [[0, 1, 2]])
        points, triangles = mesh.points, mesh.triangles
        assert points.base is mesh and not points.flags.writeable
        del mesh
        assert np.array_equal(points, np.eye(3)) and triangles.tolist() == [[0, 1, 2]]


class TestDropCutter:

    def test_ball_on_a_plane(self):
        slope = math.tan(math.radians(30))
        mesh = endmill.Mesh([[-99, -99, -99 * slope], [99, -99, 99 * slope], [99, 99, 99 * slope],
                             [-99, 99, -99 * slope]], [[0, 1, 2], [0, 2, 3]])
        places = np.random.default_rng(5).uniform(-50, 50, (1000, 2))
        lift = 4 * (1 / math.cos(math.radians(30)) - 1)
        heights = endmill.DropCutter(mesh, "ball:8").heights(places)
        assert heights == pytest.approx(places[:, 0] * slope + lift, abs=1e-9)

    def test_flat_cutter_on_a_point_and_beside_the_part(self):
        mesh = endmill.Mesh([[0, 0, 3], [0.001, 0, 0], [0, 0.001, 0]], [[0, 1, 2]])
        heights = endmill.DropCutter(mesh, endmill.Cutter("flat:10")).heights([[4.9, 0], [6, 0]])
        assert heights.tolist() == [3, -math.inf]

    def test_progress_rises(self):
        drop = endmill.DropCutter(endmill.Mesh(np.eye(3), [[0, 1, 2]]), "ball:1")
        shares, count = [], 1_000_000
        while len(shares) < 3 and count < 10**8:  # a call comes twenty times a second
            shares.clear()
            count *= 2
            drop.heights(np.zeros((count, 2)), progress=shares.append)
        assert len(shares) >= 3 and shares == sorted(shares)
        assert shares[0] < shares[-1] <= 1


class TestToolPath:

    def test_arrays_come_back(self):
        tips = np.random.default_rng(6).normal(size=(20, 3))
        axes = np.tile([0, 0.6, 0.8], (20, 1))
        words = ["plunge"] + ["cut"] * 18 + ["retract"]
        path = endmill.ToolPath(tips, axes, words, passes=np.arange(20) // 10, feeds=[500.0] * 20)
        assert np.array_equal(path.tips, tips) and np.array_equal(path.axes, axes)
        assert path.moves.tolist() == words and path.passes.tolist() == [0] * 10 + [1] * 10
        assert path.feeds.tolist() == [500] * 20 and np.isnan(path.contacts).all()

    def test_totals_are_lengths(self):
        tips = np.cumsum(np.random.default_rng(7).normal(size=(30, 3)), axis=0)
        length = np.linalg.norm(np.diff(tips, axis=0), axis=1).sum()
        totals = endmill.ToolPath(tips, feeds=np.full(30, 200.0)).totals()
        assert totals["cut_mm"] == pytest.approx(length)
        assert totals["time_min"] == pytest.approx(length / 200)

    def test_the_file_reads_back_bit_by_bit(self, tmp_path):
        tips = np.random.default_rng(8).normal(size=(50, 3)) / 3
        file = tmp_path / "path.csv"
        file.write_text(endmill.ToolPath(tips).csv())
        assert np.array_equal(endmill.read_path(file).tips, tips)

    def test_an_empty_path(self):
        path = endmill.ToolPath(np.empty((0, 3)))
        assert len(path) == 0 and path.tips.shape == (0, 3) and path.moves.shape == (0,)


class TestTrimming:

    def test_the_envelope_is_the_greatest_height(self, folded_curve):
        (trimmed,) = endmill.trim_curves([folded_curve]).curves
        assert (np.diff(trimmed[:, 0]) >= 0).all()
        a, b = folded_curve[:-1], folded_curve[1:]
        for s in np.linspace(1, 9, 57):
            inside = (np.minimum(a[:, 0], b[:, 0]) <= s) & (s <= np.maximum(a[:, 0], b[:, 0]))
            share = (s - a[inside, 0]) / (b[inside, 0] - a[inside, 0])
            heights = a[inside, 1] + share * (b[inside, 1] - a[inside, 1])
            assert np.interp(s, *trimmed.T) == pytest.approx(heights.max(), abs=1e-12)

    def test_a_method_of_ones_own_stands_beside_the_others(self, folded_curve):

        def no_method(curves):
            return curves

        rows = endmill.compare_trimming([[folded_curve]] * 3, ["envelope", "3r", no_method])
        import functools
        (named,) = endmill.compare_trimming([[folded_curve]], [functools.partial(no_method)], repeat=1)
        assert "no_method" in named["method"]
        assert [row["method"] for row in rows] == ["envelope", "3r", "no_method"]
        assert [row["wrong"] for row in rows] == [0, 0, 3]
        assert rows[2]["max_gouge_mm"] > 0.1 and len(rows[0]["times_ms"]) == 3

    def test_the_envelope_by_numpy_is_right_by_the_comparison(self, folded_curve):

        def sampled_envelope(curves):
            s = np.unique(np.concatenate([curve[:, 0] for curve in curves]))
            heights = np.full(len(s), -np.inf)
            for curve in curves:
                for (s0, z0), (s1, z1) in zip(curve, curve[1:]):
                    inside = (min(s0, s1) <= s) & (s <= max(s0, s1)) if s0 != s1 else s == s0
                    here = np.interp(s[inside], sorted([s0, s1]), [z0, z1] if s0 < s1 else [z1, z0])
                    heights[inside] = np.maximum(heights[inside], here)
            return [np.column_stack([s, heights])]

        (row,) = endmill.compare_trimming([[folded_curve]], [sampled_envelope], repeat=1,
                                          tolerance=0.02)
        assert row["wrong"] == 0


def test_coefficients_of_a_full_slot_without_slopes_have_their_symmetry():
    found = endmill.cutting_coefficients(0, 0, 0, [0.2, 0.5, 0.9], previous="none")
    assert found.shape == (3, 8)
    # xi is 1 in front of the axis only; there sin t cos t is odd about the feed.
    assert found[:, 0] == pytest.approx(np.zeros(3), abs=1e-12)
    # 2 pi I7 is the cross-section of the slot: a segment of the unit circle.
    depth = np.array([0.2, 0.5, 0.9])
    angle = np.arccos(1 - depth)
    segment = angle - (1 - depth) * np.sin(angle)
    assert 2 * math.pi * found[:, 6] == pytest.approx(segment, abs=1e-10)


class TestVisibility:

    def test_local_cones_are_half_spheres(self, datasets):
        mesh = endmill.read_part(datasets / "meshes/teapot-288.off").mesh
        grid = endmill.DirectionGrid("hex:4")
        a, b, c = np.moveaxis(mesh.points[mesh.triangles], 1, 0)
        normals = np.cross(b - a, c - a)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        expected = normals @ grid.centres.T > 1e-6
        found = endmill.visibility(mesh, grid.centres, kind="local")
        assert np.array_equal(found.accessible(), expected)

    def test_words_hold_the_bits(self, datasets):
        mesh = endmill.read_part(datasets / "meshes/teapot-288.off").mesh
        found = endmill.visibility(mesh, endmill.DirectionGrid("hex:3").centres)
        bits = np.unpackbits(found.words.view(np.uint8), axis=1, bitorder="little")
        assert np.array_equal(bits[:, :found.facets].T.astype(bool), found.accessible())
        assert found.words.base is found

    def test_the_grid_covers_the_sphere(self):
        grid = endmill.DirectionGrid("ico:2")
        assert len(grid) == 320
        assert grid.solid_angles_sr.sum() == pytest.approx(4 * math.pi)


class TestMachine:

    @pytest.mark.parametrize("word", ["W/caxyBz/T", "W/xyzBab/T", "W/cBxyza/T"])
    def test_positions_and_poses_are_inverse(self, word):
        rng = np.random.default_rng(9)
        tips, axes = rng.normal(size=(2, 40, 3))
        axes /= np.linalg.norm(axes, axis=1, keepdims=True)
        machine = endmill.Machine(word)
        positions, _ = machine.positions(tips, axes, tool_length=80, clamp=(10, 20, 30))
        for solution in (0, 1):
            again = machine.poses(positions[:, solution], tool_length=80, clamp=(10, 20, 30))
            assert again[0] == pytest.approx(tips, abs=1e-11)
            assert again[1] == pytest.approx(axes, abs=1e-12)

    def test_a_table_about_z_turns_the_part(self):
        # A lies below C: an axis that leans to +y by 30 degrees is reached by -30 or 30 of A.
        machine = endmill.Machine("W/caxyBz/T")
        lean = [[0, math.sin(math.radians(30)), math.cos(math.radians(30))]]
        positions, within = machine.positions([[0, 0, 0]], lean)
        assert sorted(np.abs(positions[0, :, 4])) == pytest.approx([30, 30])
        assert within.all()
