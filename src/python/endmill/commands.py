# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of the program endmill.

Each command runs the program in a process of its own, so that its results are those of the
command line, and nothing that a file contains can end the interpreter.

Inputs are names of files, or values: Surface, Mesh, Part, ToolPath, Result. Options have the names
of the command line with underscores, as in plan(part, scallop=0.05, direction_deg=45). True stands
for an option without a value, a tuple for numbers with commas, and a list for an option that is
given several times.
"""

from __future__ import annotations

import os
import warnings
import weakref
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from endmill import errors
from endmill._native import Mesh, Part, Surface, ToolPath, _read_path

if TYPE_CHECKING:  # annotations alone need these, and importing them takes long
    from collections.abc import Callable, Sequence

    import numpy.typing as npt

    Input = (str | PathLike[str] | Part | Surface | Mesh | ToolPath |
             Sequence[npt.ArrayLike])
    Progress = Callable[[float], object]


_main_pictures = ("toolpath.svg", "setup.svg", "deviation.svg", "feed.svg")


class Result:
    """The result of a command: its summary and its files.

    Without output=, the files lie in a folder that is removed with this object.
    """

    def __init__(self, command_name: str, summary: dict[str, Any], folder: Path, is_yes: bool,
                 remarks: list[str]) -> None:
        self.command = command_name  #: name of the command
        self.summary = summary  #: the keys of summary.json
        self.folder = folder  #: folder of the files
        self.is_yes = is_yes  #: whether the answer is yes, as exit code 0 says
        self.remarks = remarks  #: warnings of the program

    def __getitem__(self, key: str) -> Any:
        """The value of a key of the summary."""
        return self.summary[key]

    @property
    def files(self) -> list[str]:
        """Names of the files below the folder, sorted."""
        return sorted(
            str(file.relative_to(self.folder)) for file in self.folder.rglob("*") if file.is_file())

    def read_path(self, name: str = "toolpath.csv") -> ToolPath:
        """The tool path in a file of the folder, such as "u/toolpath.csv"."""
        return _read_path(self.folder / name)

    @property
    def path(self) -> ToolPath:
        """The tool path in toolpath.csv."""
        return self.read_path()

    def text(self, name: str) -> str:
        """The content of a file of the folder, such as a machine program."""
        return (self.folder / name).read_text(encoding="utf-8")

    def table(self, name: str) -> dict[str, npt.NDArray[Any]]:
        """The columns of a CSV file of the folder, by name.

        Columns of numbers are doubles, with NaN in empty cells; all others are texts.
        """
        import csv  # here and below: what not every script needs is imported where it is used

        path = self.folder / name
        with open(path, newline="", encoding="utf-8") as file:
            names, *lines = list(csv.reader(file)) or [[]]
        if not names or len(set(names)) < len(names) or any(len(line) != len(names) for line in lines):
            raise errors.FormatError(f"{path}: found no table; expected a header of different names, "
                                     "and rows with as many cells", "E_CSV", str(path))
        columns = list(zip(*lines)) or [()] * len(names)
        return {column: _numbers_or_texts(cells) for column, cells in zip(names, columns)}

    def svg(self) -> str:
        """The main picture of the folder, or an empty text."""
        pictures = [name for name in self.files if name.endswith(".svg")]
        main = [name for name in _main_pictures if name in pictures] or pictures
        return (self.folder / main[0]).read_text(encoding="utf-8") if main else ""

    def __repr__(self) -> str:
        answer = "yes" if self.is_yes else "no"
        return f"<Result of {self.command}: {answer}, {len(self.summary)} keys, {self.folder}>"

    def _repr_html_(self) -> str:
        import html

        rows = "".join(f"<tr><th>{html.escape(key)}</th><td>{html.escape(_shown(value))}</td></tr>"
                       for key, value in self.summary.items()
                       if not isinstance(value, (dict, list)))
        return f"{self.svg()}<table>{rows}</table>"


def command(name: str,
            input_: Input | Result | None = None,
            *,
            output: str | PathLike[str] | None = None,
            progress: Progress | None = None,
            **options: Any) -> Result:
    """Run a command of the program by name; the functions below are shorter ways to do so.

    output: folder for the files, new or empty; by default a temporary one. progress: a function
    of the finished share of the current work. Other options: see endmill NAME --help.

    Returns a Result, also if the answer of the command is no. Raises DomainError for a wrong option,
    FormatError for a file with a fault, GeometryError, OutputError, LimitError; an interrupt ends
    the program.
    """
    from endmill import _child

    if progress is not None and not callable(progress):
        raise TypeError("progress: expected a function of the finished share")
    own = _child.new_folder()
    try:
        arguments = [name]
        if input_ is not None:
            arguments.append(_file_of(input_, own, "input"))
        for option, value in options.items():
            arguments += _words_of(option, value, own)
        folder = Path(output).absolute() if output is not None else own / "results"
        if name not in ("cite", "eval"):
            arguments += ["--output", str(folder)]
        summary, is_yes, remarks = _child.run(arguments, own, progress)
    except BaseException:
        _child.remove(own)
        raise
    result = Result(name, summary, folder, is_yes, remarks)
    weakref.finalize(result, _child.remove, own, os.getpid())
    for remark in remarks:
        warnings.warn(remark, stacklevel=3)
    return result


def plan(part: Input, **options: Any) -> Result:
    """Plan finishing passes on a part; Result.path is the tool path.

    Without options: the largest ball that fits (a mesh needs cutter=), the shortest strategy, and
    0.01 mm of tolerance and scallop height.
    """
    return command("plan", part, **options)


def trim(part: Input | None = None, **options: Any) -> Result:
    """Cut the offset of a part by drive planes, and remove the loops of the sections.

    polyline= trims given curves: a file, or arrays (n, 2) of s and z in mm.
    """
    return command("trim", part, **options)


def verify(path: Input | Result, **options: Any) -> Result:
    """Remove the material along a path, and bound gouge and remaining stock.

    path: a ToolPath, a file, or the Result of plan, whose part and limits then hold. part=, cutter=
    give them for other paths. Result.is_yes is True only for the verdict clean.
    """
    return command("verify", path, **options)


def post(path: Input | Result, **options: Any) -> Result:
    """Write a path as a machine program."""
    return command("post", path, **options)


def feed(path: Input | Result, **options: Any) -> Result:
    """Choose feed and spindle speed for each move: material=, machine=, tool= name files."""
    return command("feed", path, **options)


def setup(part: Input, **options: Any) -> Result:
    """Find the setup of a part on a machine that needs the least rotary ranges."""
    return command("setup", part, **options)


def info(part: Input, **options: Any) -> Result:
    """Report on a part: size, area, curvature, largest ball."""
    return command("info", part, **options)


def sample(part: Input, **options: Any) -> Result:
    """Sample a surface as a mesh file."""
    return command("sample", part, **options)


def machine(word: str, **options: Any) -> Result:
    """Report what a machine can do: a file, or a word such as "W/caxyBz/T"."""
    return command("machine", word, **options)


def view(*sources: Input | Result, output: str | PathLike[str] = "page.html", **options: Any) -> Path:
    """Write a page that shows results, parts and paths in a browser; return its file.

    sources: results of commands, names of folders and files, a ToolPath, a Surface or a Mesh.
    """
    from endmill import _child

    own = _child.new_folder()
    try:
        words = [str(source.folder) if isinstance(source, Result) else _file_of(source, own, f"input{k}")
                 for k, source in enumerate(sources)]
        for option, value in options.items():
            words += _words_of(option, value, own)
        _child.run(["view", *words, "--output", str(output)], own, None)
    finally:
        _child.remove(own)
    return Path(output)


def evaluate(formula: str, **numbers: Any) -> dict[str, Any]:
    """Evaluate a formula by name, as in evaluate("path-interval", radius=5, curvature=0.01,
    scallop=0.1)."""
    return command("eval", formula, **numbers).summary


def tool_life(table: str | PathLike[str], **options: Any) -> Result:
    """Fit the tool life to a CSV file of cutting data, and find the economic speed."""
    return command("toollife", table, **options)


def import_cad(file: str | PathLike[str], **options: Any) -> Result:
    """Import a STEP or IGES file: mesh.ply with face numbers, faces.csv, surfaces of whole faces."""
    return command("import", file, **options)


def run_job(job: str | PathLike[str], **options: Any) -> Result:
    """Run a job (endmill-job/1): the whole chain from part to code."""
    return command("run", job, **options)


def run_sweep(plan_file: str | PathLike[str], **options: Any) -> Result:
    """Run a plan of many cases (endmill-sweep/1); Result.table("results.csv") has a row of each."""
    return command("sweep", plan_file, **options)


def _numbers_or_texts(cells: Sequence[str]) -> npt.NDArray[Any]:
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        return np.array(cells)


def _shown(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


# The file of an input: its own, or one that is written to `folder`.
def _file_of(value: Any, folder: Path, stem: str) -> str:
    if isinstance(value, (str, PathLike)):
        name = os.fspath(value)
        return os.path.join(".", name) if name.startswith("-") else name
    if isinstance(value, Result):
        return str(value.folder / "toolpath.csv")
    if isinstance(value, Part):
        if value.mesh is None:
            return _written(folder / value._name, value._content)
        value = value.mesh
    if isinstance(value, Surface):
        return _written(folder / f"{stem}.json", value._text(stem))
    if isinstance(value, Mesh):
        return _written(folder / f"{stem}.off", value._text())
    if isinstance(value, ToolPath):
        return _written(folder / f"{stem}.csv", value.csv())
    if _are_curves(value):
        return _written(folder / f"{stem}.csv", _curves_text(value))
    raise TypeError(f"found a {type(value).__name__}; expected the name of a file, a Surface, a "
                    "Mesh, a Part, a ToolPath, a Result or arrays of curves")


# Whether a value is a curve (n, 2), or a list or tuple of them.
def _are_curves(value: Any) -> bool:
    if isinstance(value, np.ndarray):
        return value.ndim == 2
    return isinstance(value, (list, tuple)) and bool(value) and all(
        isinstance(curve, (np.ndarray, list, tuple)) and np.ndim(curve) == 2 for curve in value)


def _curves_text(curves: Any) -> str:
    lines = ["curve,s_mm,z_mm"]
    for number, curve in enumerate([curves] if isinstance(curves, np.ndarray) else curves):
        lines += [f"{number},{float(s)!r},{float(z)!r}" for s, z in np.asarray(curve)]
    return "\n".join(lines) + "\n"


def _written(file: Path, text: str | bytes) -> str:
    file.write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))
    return str(file)


# The words of an option on the command line.
def _words_of(name: str, value: Any, folder: Path) -> list[str]:
    option = "--" + name.rstrip("_").replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [option]
    if isinstance(value, (Part, Surface, Mesh, ToolPath, Result)) or _are_curves(value):
        return [option, _file_of(value, folder, name)]
    if isinstance(value, (list, tuple, np.ndarray)) and np.size(value) == 0:
        raise errors.DomainError(f"{name}: found no value; expected one or more")
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, list):
        return [word for one in value for word in _words_of(name, one, folder)]
    if isinstance(value, (tuple, np.ndarray)):
        # A number below 0 after a space would look like an option.
        return [f"{option}=" + ",".join(_word_of(one) for one in value)]
    return [f"{option}={_word_of(value)}"]


def _word_of(value: Any) -> str:
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    return str(os.fspath(value)) if isinstance(value, PathLike) else str(value)
