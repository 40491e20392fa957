#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails if the house is not as it is declared.

* An #include follows an arrow that src/CMakeLists.txt does not declare, or is relative.
* A module other than job uses io: whoever computes does not read files.
* A folder under src/endmill is no declared module, or a declared module has no folder.
* A header in src shows a library that is kept inside .cpp files.
* A header for users includes one that is internal to a module, and so is not installed.
* A header has no test file of its name.
* A source, script or CMake file has no SPDX line, or one that says something is still to do.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MODULE = re.compile(r"endmill_module\(([^)]*)\)")
KEYWORDS = {"USES", "LIBRARIES", "PRIVATE_LIBRARIES"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
KEPT_INSIDE = re.compile(r"^(CGAL|OpenMesh|boost|embree\d*|tbb|oneapi)/")
INTERNAL = re.compile(r"^// Internal to ", re.M)
MAY_USE_IO = {"job"}  # and src/cli, which is no module
SPDX = "SPDX-License-Identifier:"
UNFINISHED = re.compile(r"\b(TO{1}DO|FIX{1}ME)\b")  # {1}: so that this line passes itself
CHECKED_SUFFIXES = {".h", ".cpp", ".py", ".sh", ".cmake"}


def declared_arrows(text, bad):
    """module -> modules it may use, from the text of src/CMakeLists.txt."""
    arrows = {}
    for declaration in MODULE.findall(re.sub(r"#.*", "", text)):
        name, *rest = declaration.split()
        uses, keyword = set(), None
        for token in rest:
            if token in KEYWORDS:
                keyword = token
            elif keyword == "USES":
                uses.add(token)
        for later in sorted(uses - arrows.keys()):
            bad.append(f"src/CMakeLists.txt: {name} uses {later}, which is not declared above it")
        if "io" in uses and name not in MAY_USE_IO:
            bad.append(f"src/CMakeLists.txt: {name} uses io; only job and cli may")
        arrows[name] = uses
    return arrows


def check_folders(root, arrows, bad):
    folders = {f.name for f in (root / "src/endmill").iterdir() if f.is_dir()}
    for module in sorted(folders - arrows.keys()):
        bad.append(f"src/endmill/{module}: not declared in src/CMakeLists.txt")
    for module in sorted(arrows.keys() - folders):
        bad.append(f"src/CMakeLists.txt: {module} has no folder src/endmill/{module}")


def check_includes(root, arrows, bad):
    for file in sorted((root / "src/endmill").rglob("*.[hc]*")):
        module = file.relative_to(root / "src/endmill").parts[0]
        may_use = arrows.get(module, set()) | {module}
        for included in INCLUDE.findall(file.read_text(encoding="utf-8")):
            top, *rest = included.split("/")
            if top == "endmill" and rest[0] not in may_use:
                bad.append(f"{file.relative_to(root)}: {module} -> {rest[0]}")
            if top in ("..", "cli"):
                bad.append(f"{file.relative_to(root)}: includes {included}")


def check_headers(root, bad):
    for header in sorted((root / "src").rglob("*.h")):
        for included in INCLUDE.findall(header.read_text(encoding="utf-8")):
            if KEPT_INSIDE.match(included):
                bad.append(f"{header.relative_to(root)}: {included} belongs in a .cpp file")


def check_internal_headers(root, bad):
    texts = {str(header.relative_to(root / "src")): header.read_text(encoding="utf-8")
             for header in sorted((root / "src/endmill").glob("*/*.h"))}
    internal = {name for name, text in texts.items() if INTERNAL.search(text)}
    for name in sorted(texts.keys() - internal):
        for included in sorted(internal.intersection(INCLUDE.findall(texts[name]))):
            bad.append(f"src/{name}: is for users and includes {included}, which is internal")


def check_tests(root, bad):
    for header in sorted((root / "src/endmill").glob("*/*.h")):
        test = Path("tests", header.parent.name, header.stem + "_test.cpp")
        if not (root / test).exists():
            bad.append(f"{header.relative_to(root)}: has no {test}")


def checked_files(root):
    """Sources, scripts and CMake files."""
    for folder in ("src", "experiments", "tests", "scripts", "cmake"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in CHECKED_SUFFIXES or file.name == "CMakeLists.txt":
                yield file
    yield from (f for f in (root / "CMakeLists.txt", root / ".ci/run") if f.exists())


def check_texts(root, bad):
    for file in checked_files(root):
        lines = file.read_text(encoding="utf-8").splitlines()
        if not any(SPDX in line for line in lines[:3]):
            bad.append(f"{file.relative_to(root)}: no SPDX line in the first three")
        for i, line in enumerate(lines, start=1):
            if UNFINISHED.search(line):
                bad.append(f"{file.relative_to(root)}:{i}: finish it or leave it out")


def main(root):
    bad = []
    arrows = declared_arrows((root / "src/CMakeLists.txt").read_text(encoding="utf-8"), bad)
    check_folders(root, arrows, bad)
    check_includes(root, arrows, bad)
    check_headers(root, bad)
    check_internal_headers(root, bad)
    check_tests(root, bad)
    check_texts(root, bad)
    print("\n".join(bad) or f"{len(arrows)} modules, all as declared")
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT))
