# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/examples, each run where a reader would: beside datasets."""
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

EXAMPLES = sorted((ROOT / "docs/examples").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example(example, tmp_path, monkeypatch):
    (tmp_path / "datasets").symlink_to(ROOT / "datasets")
    monkeypatch.setenv("MPLBACKEND", "Agg")
    done = subprocess.run([sys.executable, example], cwd=tmp_path, capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0, done.stderr
    assert "<svg" in (tmp_path / f"{example.stem}.svg").read_text(encoding="utf-8")
    lines = [line for line in example.read_text(encoding="utf-8").splitlines()
             if line.strip() and not line.startswith("#")]
    assert len(lines) <= 25


def test_the_guide(tmp_path):
    """The Python of the guide runs from top to bottom."""
    program = Path(os.environ["ENDMILL_PROGRAM"])
    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    if "without endmill-cad" in said or not (program.parents[1] / "page/page/page.js").exists():
        pytest.skip("endmill was built without OpenCASCADE, npm or esbuild")
    text = (ROOT / "docs/guide/python.md").read_text(encoding="utf-8")
    script = "\n".join(re.findall(r"```python\n(.*?)```", text, flags=re.DOTALL))
    assert script
    (tmp_path / "datasets").symlink_to(ROOT / "datasets")
    done = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, capture_output=True,
                          text=True, check=False)
    assert done.returncode == 0, done.stderr
