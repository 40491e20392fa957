# SPDX-License-Identifier: GPL-3.0-or-later
"""The type hints, and the docstrings."""
import ast
import inspect
from pathlib import Path

import endmill
from endmill import _native

STUB = Path(endmill.__file__).with_name("_native.pyi")


def test_the_stub_names_what_the_module_has():
    stub = ast.parse(STUB.read_text(encoding="utf-8"))
    for entry in stub.body:
        if isinstance(entry, ast.FunctionDef):
            assert hasattr(_native, entry.name)
        elif isinstance(entry, ast.ClassDef):
            hinted = {member.name for member in entry.body if isinstance(member, ast.FunctionDef)}
            own = {name for name, member in vars(getattr(_native, entry.name)).items()
                   if not name.startswith("__") and not inspect.isclass(member)}
            assert own <= hinted | {"_name", "_content"}, entry.name
    named = {entry.name for entry in stub.body if hasattr(entry, "name")}
    assert {name for name in vars(_native) if not name.startswith("__")} <= named | {
        "move_names", "trimming_methods"}


def test_everything_public_is_documented():
    for name in endmill.__all__:
        value = getattr(endmill, name)
        assert inspect.getdoc(value), name
        if inspect.isclass(value):
            for member, of_class in vars(value).items():
                if not member.startswith("_") and (callable(of_class) or
                                                   isinstance(of_class, property)):
                    assert inspect.getdoc(of_class), f"{name}.{member}"
