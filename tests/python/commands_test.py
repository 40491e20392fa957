# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands, bit by bit against the command line."""
import os
import subprocess

import endmill
import numpy as np
import pytest
from conftest import net

PROGRAM = os.environ["ENDMILL_PROGRAM"]


def command_line(*words):
    """Runs the program; the exit code must be 0 or 1."""
    process = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)
    assert process.returncode in (0, 1), process.stderr


@pytest.mark.parametrize("strategy", ["best", "iso-u", "iso-scallop"])
def test_plan_of_a_surface_gives_the_path_of_the_program(tmp_path, strategy):
    surface = endmill.Surface.bezier(net(np.arange(16).reshape(4, 4) % 5))
    (tmp_path / "input.json").write_text(surface._text("input"))
    command_line("plan", tmp_path / "input.json", "--cutter", "ball:6", "--scallop", 0.2,
                 "--strategy", strategy, "-o", tmp_path / "by-program")
    result = endmill.plan(surface, cutter="ball:6", scallop=0.2, strategy=strategy)
    expected = (tmp_path / "by-program/toolpath.csv").read_bytes()
    assert (result.folder / "toolpath.csv").read_bytes() == expected
    assert result.path.csv().encode() == expected
    assert len(result.path) >= result["ncl"] > 100


def test_the_chain_from_array_to_code(tmp_path):
    shares = []
    surface = endmill.Surface.bezier(net(np.zeros((4, 4))))
    path = endmill.plan(surface, cutter="ball:6", scallop=0.3, progress=shares.append)
    proof = endmill.verify(path, resolution=0.5)
    code = endmill.post(path, feed=800, spindle_rpm=9000, output=tmp_path / "code")
    assert proof.is_yes and proof["verdict"] == "clean"
    (program,) = [name for name in code.files if name.endswith(".ngc")]
    again = endmill.read_path(code.folder / program)
    assert again.tips[np.isin(again.moves, ["cut"])].min(axis=0)[2] == pytest.approx(0, abs=1e-3)
    assert "<svg" in proof._repr_html_() and "clean" in proof._repr_html_()


def test_trim_curves_gives_the_curves_of_the_program(tmp_path, folded_curve):
    for method in endmill.trimming_methods:
        result = endmill.trim(polyline=[folded_curve], method=method)
        table = result.table("trimmed.csv")
        points = np.column_stack([table["s_mm"], table["z_mm"]])
        assert np.array_equal(points, np.concatenate(
            endmill.trim_curves([folded_curve], method=method).curves)), method


def test_visibility_has_the_bits_of_the_program(datasets):
    part = datasets / "meshes/teapot-288.off"
    result = endmill.setup(part, machine="W/caxyBz/T", sphere="hex:4")
    by_file = endmill.read_visibility(result.folder / "visibility.bsm")
    found = endmill.visibility(endmill.read_part(part).mesh, endmill.DirectionGrid("hex:4").centres)
    assert np.array_equal(by_file.words, found.words)


def test_coefficients_are_those_of_the_program():
    summary = endmill.command("coefficients", mu_deg=12, lambda_deg=-17, pick_feed_ratio=0.5,
                              depth_ratio=0.8).summary
    found = endmill.cutting_coefficients(12, -17, 0.5, 0.8)
    assert [summary[f"I{k}"] for k in range(1, 9)] == found.tolist()


def test_drop_cutter_gives_the_heights_of_trim(datasets):
    part = datasets / "meshes/dome.stl"
    table = endmill.trim(part, cutter="ball:6", planes=5).table("trimmed.csv")
    places = np.column_stack([table["x_mm"], table["y_mm"]])
    heights = endmill.DropCutter(endmill.read_part(part).mesh, "ball:6").heights(places)
    # trim writes reference points: the centre of the ball, within its tolerance of 0.01 mm.
    assert heights + 3 == pytest.approx(table["z_mm"], abs=0.01)


def test_other_commands_answer(datasets, tmp_path):
    assert endmill.info(datasets / "surfaces/sphere.json")["patches"] >= 1
    assert endmill.evaluate("path-interval", radius=5, curvature=0, scallop=0.1)[
        "chord_mm"] == pytest.approx(2 * np.sqrt(5**2 - 4.9**2))
    assert endmill.machine("W/caxyBz/T").summary
    sampled = endmill.sample(datasets / "surfaces/saddle.json", chord_tolerance=0.1, format="off")
    assert endmill.read_part(sampled.folder / "mesh.off").mesh.report()["components"] == 1
    job = endmill.run_job(datasets / "jobs/economic-cl-data.json", output=tmp_path / "job", dry_run=True)
    assert job.summary


def test_a_part_is_what_was_read(datasets, tmp_path):
    file = tmp_path / "part.json"
    file.write_bytes((datasets / "surfaces/saddle.json").read_bytes())
    part = endmill.read_part(file)
    file.write_bytes((datasets / "surfaces/plane.json").read_bytes())
    assert endmill.info(part)["name"] == "saddle"
    file.unlink()
    assert endmill.info(part)["name"] == "saddle"


def test_a_forked_process_does_not_remove_the_folder(datasets):
    result = endmill.info(datasets / "surfaces/plane.json")
    child = os.fork()
    if child == 0:
        try:
            del result
        finally:
            os._exit(0)
    os.waitpid(child, 0)
    assert result.folder.exists()


def test_a_relative_output_stays_where_it_was_written(datasets, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = endmill.info(datasets / "surfaces/plane.json", output="here")
    monkeypatch.chdir("/")
    assert result.files == ["summary.json"]


@pytest.mark.parametrize("text", ["", "a,b\n1\n2,3\n", "a,a\n1,2\n"])
def test_a_damaged_table_is_refused(datasets, tmp_path, text):
    result = endmill.info(datasets / "surfaces/plane.json", output=tmp_path / "out")
    (tmp_path / "out/table.csv").write_text(text)
    with pytest.raises(endmill.FormatError, match="table.csv"):
        result.table("table.csv")


def test_curves_may_be_a_tuple_or_a_single_array(folded_curve):
    expected = endmill.trim(polyline=[folded_curve]).text("trimmed.csv")
    assert endmill.trim(polyline=(folded_curve,)).text("trimmed.csv") == expected
    assert endmill.trim(polyline=folded_curve).text("trimmed.csv") == expected


def test_remarks_are_those_of_the_program_and_no_progress(datasets):
    with pytest.warns(UserWarning) as seen:
        result = endmill.info(datasets / "surfaces/teapot.json")
    assert result.remarks == [str(one.message) for one in seen] and "pole" in result.remarks[0]


def test_view_writes_a_page(datasets, tmp_path):
    path = endmill.plan(datasets / "surfaces/plane.json", cutter="ball:10", scallop=1, strategy="iso-u")
    try:
        page = endmill.view(path, output=tmp_path / "page.html")
    except endmill.DomainError as error:
        assert "built without npm" in str(error)
        return
    assert "default-src 'none'" in page.read_text()


def test_a_cad_file_is_read_as_its_mesh(datasets):
    if "without endmill-cad" in subprocess.run([PROGRAM, "--version"], capture_output=True, text=True,
                                               check=True).stdout:
        pytest.skip("endmill was built without OpenCASCADE")
    imported = endmill.import_cad(datasets / "cad/primitives.step")
    mesh = endmill.read_part(datasets / "cad/primitives.step").mesh
    assert mesh.report()["is_closed"]
    assert len(mesh.triangles) == imported["triangles"]


def test_a_part_of_several_surfaces_goes_by_its_file(datasets):
    part = endmill.read_part(datasets / "surfaces/teapot.json")
    assert endmill.info(part)["patches"] == len(part.surfaces)


def test_results_vanish_with_their_object_unless_they_have_a_folder(tmp_path, datasets):
    plane = datasets / "surfaces/plane.json"
    kept = endmill.info(plane, output=tmp_path / "kept")
    temporary = endmill.info(plane)
    folder = temporary.folder
    assert folder.exists()
    del temporary, kept
    assert not folder.exists() and (tmp_path / "kept/summary.json").exists()


@pytest.mark.parametrize("options, kind, text", [
    ({"scalop": 1}, endmill.DomainError, "--scallop"),
    ({"scallop": -1}, endmill.DomainError, "--scallop"),
    ({"cutter": "ball:5000000"}, endmill.DomainError, "--max-extent"),
])
def test_wrong_options_raise(datasets, options, kind, text):
    with pytest.raises(kind, match=text):
        endmill.plan(datasets / "surfaces/saddle.json", **options)


def test_errors_of_files_name_the_place(tmp_path):
    file = tmp_path / "wrong.json"
    file.write_text('{"format": "endmill-surface/1", "type": "bezier", "patches_u": 0}')
    with pytest.raises(endmill.FormatError) as by_program:
        endmill.plan(file)
    with pytest.raises(endmill.FormatError) as by_library:
        endmill.read_part(file)
    assert by_program.value.code == by_library.value.code
    assert by_program.value.place == by_library.value.place
    assert str(file) in str(by_library.value)


def test_a_cutter_too_large_for_the_surface(datasets):
    with pytest.raises(endmill.GeometryError, match="limit of the surface"):
        endmill.plan(datasets / "surfaces/saddle.json", cutter="ball:200", strategy="iso")


def test_a_missing_program_is_an_error(monkeypatch, datasets):
    monkeypatch.setenv("ENDMILL_PROGRAM", "/nowhere/endmill")
    with pytest.raises(endmill.OutputError, match="/nowhere/endmill"):
        endmill.info(datasets / "surfaces/plane.json")
