# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong arguments, arrays that change, threads, forks and interrupts: an exception, never a crash."""
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import endmill
import numpy as np
import pytest
from conftest import net

PLATE = endmill.Mesh([[-50, -50, 0], [50, -50, 0], [50, 50, 0], [-50, 50, 0]],
                     [[0, 1, 2], [0, 2, 3]])


@pytest.fixture
def drop():
    return endmill.DropCutter(PLATE, "ball:6")


@pytest.mark.parametrize("places, kind, text", [
    ([1, 2, 3], ValueError, r"places: found the shape \(3,\); expected \(n, 2\)"),
    (np.zeros((4, 3)), ValueError, r"expected \(n, 2\)"),
    ([["a", "b"]], TypeError, "expected numbers"),
    (np.zeros((4, 2), dtype=complex), TypeError, "complex128; expected numbers"),
    (None, TypeError, "expected numbers"),
    ([[1, 2], [3]], TypeError, "expected numbers"),
    ([[np.nan, 0]], endmill.DomainError, "expected finite numbers"),
    ([[0, np.inf]], endmill.DomainError, "expected finite numbers"),
])
def test_wrong_places(drop, places, kind, text):
    with pytest.raises(kind, match=text):
        drop.heights(places)


def test_arrays_of_any_layout_are_taken(drop):
    wide = np.random.default_rng(1).uniform(-40, 40, (100, 6))
    expected = drop.heights(wide[:, 1:3].copy())
    frozen = wide[:, 1:3].copy()
    frozen.setflags(write=False)
    for places in (wide[:, 1:3], np.asfortranarray(wide[:, 1:3]), frozen, wide[:, 1:3].tolist()):
        assert np.array_equal(drop.heights(places), expected)
    assert drop.heights(np.array([[1, 2]], dtype=np.int16)).tolist() == [0]
    assert drop.heights(np.empty((0, 2))).shape == (0,)


@pytest.mark.parametrize("call, kind", [
    (lambda: endmill.Mesh([[0, 0]], [[0, 0, 0]]), ValueError),
    (lambda: endmill.Mesh([[0, 0, 0]], [[0, 0, 1]]), endmill.DomainError),
    (lambda: endmill.Mesh([[0, 0, 0]], [[0, 0, -1]]), endmill.DomainError),
    (lambda: endmill.Mesh([[0, 0, 0]], [[0, 0, 0.5]]), endmill.DomainError),
    (lambda: endmill.Mesh([[0, 0, np.nan]], [[0, 0, 0]]), endmill.DomainError),
    (lambda: endmill.Cutter("ball"), endmill.DomainError),
    (lambda: endmill.Cutter("ball:-1"), endmill.DomainError),
    (lambda: endmill.Cutter(5), TypeError),
    (lambda: endmill.Surface.bezier(np.zeros((5, 4, 3))), endmill.DomainError),
    (lambda: endmill.Surface.bezier(np.zeros((4, 4))), ValueError),
    (lambda: endmill.Surface.bezier(net(np.full((4, 4), np.inf))), endmill.DomainError),
    (lambda: endmill.Surface.bezier(net(np.zeros((4, 4))), tool_side="left"), endmill.DomainError),
    (lambda: endmill.Surface.nurbs(2, 2, [0, 1], [0, 1], np.zeros((3, 3, 3))), endmill.DomainError),
    (lambda: endmill.Surface.nurbs(10**10, 2, [0], [0], np.zeros((3, 3, 3))), TypeError),
    (lambda: endmill.Surface.height_grid([0, 1], [0, 1], [[0, 1, 2]]), ValueError),
    (lambda: endmill.Surface.bezier(net(np.zeros((4, 4)))).point(2, 0), endmill.DomainError),
    (lambda: endmill.Surface.bezier(net(np.zeros((4, 4)))).point(np.nan, 0), endmill.DomainError),
    (lambda: endmill.Surface.bezier(net(np.zeros((4, 4)))).point([0, 1], [0, 1, 0]), ValueError),
    (lambda: endmill.Surface.bezier(np.zeros((4, 4, 3))).normal(0, 0), endmill.GeometryError),
    (lambda: endmill.ToolPath([[0, 0, 0]], axes=[[0, 0, 2]]), endmill.DomainError),
    (lambda: endmill.ToolPath([[0, 0, 0]], axes=[[0, 0, 1]] * 2), ValueError),
    (lambda: endmill.ToolPath([[0, 0, 0]], moves=["jump"]), endmill.DomainError),
    (lambda: endmill.ToolPath([[0, 0, 0]], moves=[]), ValueError),
    (lambda: endmill.ToolPath([[0, 0, 0]], feeds=[-1]), endmill.DomainError),
    (lambda: endmill.ToolPath([[0, 0, 0]], passes=[0.5]), endmill.DomainError),
    (lambda: endmill.ToolPath([[0, 0, 0]], passes=[1e300]), endmill.DomainError),
    (lambda: endmill.ToolPath([[np.nan, 0, 0]]), endmill.DomainError),
    (lambda: endmill.trim_curves([[[0, 0]]]), endmill.DomainError),
    (lambda: endmill.trim_curves([[[0, 0], [np.nan, 1]]]), endmill.DomainError),
    (lambda: endmill.trim_curves("curves"), TypeError),
    (lambda: endmill.trim_curves([[[0, 0], [1, 1]]], method="4"), endmill.DomainError),
    (lambda: endmill.trim_curves([[[0, 0], [1, 1]]], method="1", scan_step=-1), endmill.DomainError),
    (lambda: endmill.compare_trimming([[[[0, 0], [1, 1]]]], [5]), TypeError),
    (lambda: endmill.compare_trimming([[[[0, 0], [1, 1]]]], [lambda curves: 5]), TypeError),
    (lambda: endmill.compare_trimming([[[[0, 0], [1, 1]]]], ["3"], repeat=0), endmill.DomainError),
    (lambda: endmill.cutting_coefficients(90, 0, 0, 0.5), endmill.DomainError),
    (lambda: endmill.cutting_coefficients(0, np.nan, 0, 0.5), endmill.DomainError),
    (lambda: endmill.cutting_coefficients(0, 0, [1, 2], [1, 2, 3]), ValueError),
    (lambda: endmill.visibility(PLATE, [[0, 0, 2]]), endmill.DomainError),
    (lambda: endmill.visibility(PLATE, [[0, 0, np.nan]]), endmill.DomainError),
    (lambda: endmill.visibility(PLATE, [[0, 0, 1]], incidence_deg=100), endmill.DomainError),
    (lambda: endmill.visibility("mesh", [[0, 0, 1]]), TypeError),
    (lambda: endmill.DirectionGrid("hex:100000000"), endmill.DomainError),
    (lambda: endmill.Machine("W/xyz"), endmill.DomainError),
    (lambda: endmill.Machine("W/caxyBz/T").poses([[0, 0, 0, 0, np.nan]]), endmill.DomainError),
    (lambda: endmill.Machine("W/caxyBz/T").positions([[0, 0, 0]], [[0, 0, 0]]),
     endmill.DomainError),
    (lambda: endmill.Machine("W/caxyBz/T").poses([[0] * 5], part_to_machine=np.ones((3, 3))),
     endmill.DomainError),
    (lambda: endmill.set_thread_count(0), endmill.DomainError),
    (lambda: endmill.read_part("missing.json"), endmill.FormatError),
    (lambda: endmill.read_part("missing.stl", units="feet"), endmill.DomainError),
    (lambda: endmill.read_path("missing.csv"), endmill.FormatError),
    (lambda: endmill.plan(5), TypeError),
    (lambda: endmill.ToolPath(np.zeros((3, 3)), feeds=np.empty((3, 0))), ValueError),
    (lambda: endmill.ToolPath(np.zeros((3, 3)), feeds=np.ones((3, 2))), ValueError),
    (lambda: endmill.ToolPath(np.zeros((3, 3)), passes=np.empty((3, 0))), ValueError),
    (lambda: endmill.ToolPath(np.zeros((1, 3)), feeds=[np.inf]), endmill.DomainError),
    (lambda: endmill.ToolPath([[1e200, 0, 0]]), endmill.DomainError),
    (lambda: endmill.Mesh(np.full((3, 3), 1e308), [[0, 1, 2]]), endmill.DomainError),
    (lambda: endmill.Mesh(np.ma.masked_array(np.eye(3), mask=True), [[0, 1, 2]]), TypeError),
    (lambda: endmill.Surface.nurbs(1, 1, [0, 0, 1, 1], [0, 0, .5, 1, 1], np.zeros((3, 2, 3)),
                                   weights=np.ones((2, 3))), ValueError),
    (lambda: endmill.trim_curves([np.array([[-6, 6], [2, -2], [0, -1], [-2, -2], [6, 6]]) * 1e160],
                                 "winding"), endmill.DomainError),
    (lambda: endmill.Machine("W/caxyBz/T").positions([[0, 0, 0]], [[0, 0, 1]], tool_length=np.nan),
     endmill.DomainError),
    (lambda: endmill.Machine("W/caxyBz/T").positions([[0, 0, 0]], [[0, 0, 1]], clamp=[np.nan, 0, 0]),
     endmill.DomainError),
    (lambda: endmill.Machine("W/caxyBz/T").positions([[0, 0, 0]], [[0, 0, 2]]), endmill.DomainError),
    (lambda: endmill.Machine("W/caxyBz/T").poses([[0] * 5], tool_length=np.inf), endmill.DomainError),
    (lambda: endmill.Machine("W/" + "a" * 10**6), endmill.DomainError),
    (lambda: endmill.DropCutter(PLATE, "ball"), endmill.DomainError),
    (lambda: endmill.DropCutter(PLATE, 5), (TypeError, RuntimeError)),
    (lambda: endmill.DropCutter(PLATE, "ball:6").heights([[0, 0]], progress=3), TypeError),
    (lambda: endmill.visibility(PLATE, [[0, 0, 1]], progress=3), TypeError),
    (lambda: endmill.info("part.stl", progress=3), TypeError),
    (lambda: endmill.compare_trimming([[[[0, 0], [1, 1]]]], ["3", "4"]), endmill.DomainError),
    (lambda: endmill.info("part.stl", units=[]), endmill.DomainError),
    (lambda: endmill.info("part.stl", help=True), endmill.Error),
    (lambda: endmill.info("-d.stl"), endmill.FormatError),
])
def test_wrong_arguments(call, kind):
    with pytest.raises(kind) as raised:
        call()
    assert str(raised.value)


@pytest.mark.parametrize("kind", [
    endmill.Mesh, endmill.Surface, endmill.Part, endmill.Cutter, endmill.DropCutter, endmill.ToolPath,
    endmill.Trimmed, endmill.DirectionGrid, endmill.VisibilityMap, endmill.Machine
])
def test_an_object_without_a_value_cannot_be_made(kind):
    with pytest.raises(TypeError):
        kind.__new__(kind)
    with pytest.raises(TypeError):
        kind.__new__(kind, 1)
    with pytest.raises(TypeError):
        kind()


def test_arrays_at_odd_addresses(drop):
    flat = np.full(2001, 5.0)
    for places in (flat[1:].reshape(1000, 2), flat[:-1].reshape(1000, 2)):
        assert drop.heights(places).tolist() == [0] * 1000
    shifted = np.frombuffer(bytes(1) + np.full((10, 2), 5.0).tobytes(), dtype=float, offset=1)
    assert not shifted.flags.aligned
    assert drop.heights(shifted.reshape(10, 2)).tolist() == [0] * 10


def test_an_array_cannot_be_resized_during_a_call(drop):
    places = np.zeros((2_000_000, 2))
    seen = []

    def resize(share):
        try:
            places.resize((1, 2), refcheck=False)
        except ValueError as error:
            seen.append(str(error))

    drop.heights(places, progress=resize)
    assert seen and len(places) == 2_000_000


def test_values_are_compared_with_anything():
    assert endmill.Cutter("ball:3") != 3
    assert endmill.Cutter("ball:3") == endmill.Cutter("ball:3")


def test_large_finite_numbers_are_named_as_they_are():
    with pytest.raises(endmill.DomainError, match=r"tips: found 1e\+308"):
        endmill.ToolPath([[1e308, 1e308, 0]])


def test_an_array_that_changes_during_a_call_is_harmless(drop):
    places = np.zeros((300_000, 2))
    is_over = threading.Event()

    def disturb():
        while not is_over.is_set():
            places[:] = np.nan
            places[:] = 1e300
            places[:] = 0

    disturber = threading.Thread(target=disturb)
    disturber.start()
    try:
        for _ in range(10):
            try:
                drop.heights(places)
            except endmill.DomainError:
                pass
    finally:
        is_over.set()
        disturber.join()
    assert drop.heights([[0, 0]]).tolist() == [0]


def test_several_threads_get_the_same_answers(drop):
    places = np.random.default_rng(2).uniform(-60, 60, (100_000, 2))
    expected = drop.heights(places)
    results = [None] * 6
    threads = [
        threading.Thread(target=lambda k=k: results.__setitem__(k, drop.heights(places)))
        for k in range(6)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(result, expected) for result in results)


def test_other_threads_run_during_a_long_call(datasets):
    mesh = endmill.read_part(datasets / "meshes/bladed-wheel.off").mesh
    turns = 0
    is_over = threading.Event()

    def count():
        nonlocal turns
        while not is_over.is_set():
            turns += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    endmill.visibility(mesh, endmill.DirectionGrid("hex:8").centres)
    is_over.set()
    thread.join()
    assert turns > 5


def _heights_of_child(places):
    return endmill.DropCutter(PLATE, "ball:6").heights(places)


def test_a_forked_process_works(drop):
    places = np.random.default_rng(3).uniform(-40, 40, (100_000, 2))
    expected = drop.heights(places)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        results = pool.map_async(_heights_of_child, [places] * 4).get(timeout=60)
    assert all(np.array_equal(result, expected) for result in results)


def test_an_exception_of_progress_ends_the_call(datasets):
    mesh = endmill.read_part(datasets / "meshes/bladed-wheel.off").mesh

    def refuse(share):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        endmill.visibility(mesh, endmill.DirectionGrid("hex:60").centres, progress=refuse)
    with pytest.raises(KeyError, match="enough"):
        endmill.plan(datasets / "surfaces/saddle.json", cutter="ball:1", scallop=0.001,
                     strategy="iso", progress=refuse)


@pytest.mark.parametrize("work", [
    "import numpy; n = 10**8; endmill.Surface.bezier(numpy.arange(48.).reshape(4, 4, 3)).curvature("
    "numpy.full(n, .5), .5)",
    "endmill.cutting_coefficients([0] * 10**7, 0, .5, .5)",
    "endmill.visibility(endmill.read_part(part).mesh, endmill.DirectionGrid('hex:200').centres)",
    "endmill.setup(part, machine='W/caxyBz/T', sphere='hex:100')",
])
def test_control_c_ends_a_long_call(datasets, work):
    part = str(datasets / "meshes/bladed-wheel.off")
    script = f"import endmill\npart = {part!r}\nprint('begun', flush=True)\n{work}"
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True) as child:
        assert child.stdout.readline() == "begun\n"
        time.sleep(1)
        os.kill(child.pid, signal.SIGINT)
        _, said = child.communicate(timeout=30)
    assert "KeyboardInterrupt" in said


def test_ten_million_numbers_in_and_out_need_one_array_more():
    script = """
import resource, numpy as np, endmill
surface = endmill.Surface.bezier(np.stack([*np.mgrid[0:4, 0:4][::-1], np.zeros((4, 4))], axis=-1))
u = np.random.default_rng(1).random(10_000_000)
v = u[::-1].copy()
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
points = surface.point(u, v)
print((resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024, points.nbytes / 2**20)
"""
    said = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    rise, result = map(float, said.stdout.split())
    assert rise <= result + 20
