# SPDX-License-Identifier: GPL-3.0-or-later
"""The program endmill as a child process."""

import json
import os
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, BinaryIO

from endmill import errors

_exception_of_exit_code = {
    2: errors.DomainError,
    3: errors.FormatError,
    4: errors.GeometryError,
    5: errors.OutputError,
    6: errors.LimitError,
}


def program() -> Path:
    """The program endmill: that of the variable ENDMILL_PROGRAM, that beside this package, or
    the first on the PATH.

    Raises OutputError if there is none.
    """
    given = os.environ.get("ENDMILL_PROGRAM")
    if given:
        return Path(given)
    beside = Path(__file__).resolve().parents[4] / "bin" / "endmill"
    found = str(beside) if beside.exists() else shutil.which("endmill")
    if not found:
        raise errors.OutputError(
            "the program endmill is missing; expected it on the PATH or in ENDMILL_PROGRAM")
    return Path(found)


def new_folder() -> Path:
    """A new temporary folder."""
    return Path(tempfile.mkdtemp(prefix="endmill-"))


def remove(folder: Path, process: int | None = None) -> None:
    """Remove a temporary folder with its content; in another process than the given one, keep it."""
    if process is None or process == os.getpid():
        shutil.rmtree(folder, ignore_errors=True)


def run(arguments: list[str], folder: Path,
        progress: Callable[[float], object] | None) -> tuple[dict[str, Any], bool, list[str]]:
    """Run the program; return its summary, whether the answer is yes, and its warnings.

    folder: for its answer. progress: receives the finished share of the current work.
    """
    words = [str(program()), *arguments, "--json", "--json-errors", "--json-progress"]
    remarks: list[str] = []
    error: dict[str, Any] = {}
    answer = folder / "answer"
    with open(answer, "wb") as out, _started(words, out) as child:
        assert child.stderr is not None
        try:
            for line in child.stderr:
                message = _object_of(line)
                if "error" in message:
                    error = message["error"]
                elif "progress" in message:
                    share = message["progress"].get("share")
                    if progress is not None and share is not None:
                        progress(share)
                elif line.strip():
                    remarks.append(line.strip().removeprefix("endmill: warning: "))
        except BaseException:
            child.terminate()
            raise
    return _answered(child.returncode, answer, error, remarks)


def _started(words: list[str], out: BinaryIO) -> subprocess.Popen[str]:
    try:
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.PIPE,
                                text=True, encoding="utf-8", errors="replace")
    except OSError as error:
        raise errors.OutputError(f"cannot run {words[0]}: {error.strerror}") from error


def _answered(code: int, answer: Path, error: dict[str, Any],
              remarks: list[str]) -> tuple[dict[str, Any], bool, list[str]]:
    if code in (0, 1):
        text = answer.read_text(encoding="utf-8")
        if text.strip():
            if error:
                remarks.append(error["message"])
            summary = _object_of(text)
            if not summary:
                raise errors.Error("the program printed no summary: " + text[:200])
            return summary, code == 0, remarks
    if code == 128 + signal.SIGINT:
        raise KeyboardInterrupt
    exception = _exception_of_exit_code.get(code, errors.Error)
    text = error.get("message") or "; ".join(remarks) or f"endmill ended with {code}"
    raise exception(text, error.get("code", ""), error.get("file", ""), error.get("place", ""))


def _object_of(line: str) -> dict[str, Any]:
    if not line.lstrip().startswith("{"):
        return {}
    try:
        found = json.loads(line)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}
