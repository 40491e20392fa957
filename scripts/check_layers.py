#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails if the modules differ from their declaration, or a file lacks what every file must have.

The script reports:

* An #include uses a module that src/CMakeLists.txt does not declare for it, or is relative.
* src/CMakeLists.txt declares an arrow that no #include of the module follows.
* A module other than job and import uses files. Modules that compute or draw do not read files.
* A folder under src/endmill is not a declared module, or a declared module has no folder.
* A module folder has other folders than detail/.
* A module has more than 14 public headers, or all modules together have more than 180.
* The umbrella header of a module does not include exactly the module's public headers.
* The names of two types, or of two files, in src differ only in the order of their words.
* Units (a header with its source) include each other in a cycle.
* A header in src includes a library that only .cpp files may include.
* A public header includes a header of a detail/ folder, which is not installed.
* The program or an example includes a header of a detail/ folder.
* A header has no test file with its name.
* A source, script or CMake file has no SPDX line, or one that says something is still to do.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MODULE = re.compile(r"endmill_module\(([^)]*)\)")
KEYWORDS = {"USES", "LIBRARIES", "PRIVATE_LIBRARIES", "OPTIONS", "TEST_LIBRARIES"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
KEPT_INSIDE = re.compile(r"^(CGAL|OpenMesh|boost|embree\d*|tbb|oneapi)/")
MOST_HEADERS_OF_A_MODULE = 14
MOST_HEADERS = 180  # of all modules, umbrella headers included
TYPE = re.compile(r"^[ ]*(?:enum class|enum struct|enum|class|struct|using)\s+([A-Z]\w*)(?!\w|::)", re.M)
WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
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
        if "files" in uses and name not in ("job", "import"):
            bad.append(f"src/CMakeLists.txt: {name} uses files; only job, import and cli may")
        arrows[name] = uses
    return arrows


def check_folders(root, arrows, bad):
    folders = {f.name for f in (root / "src/endmill").iterdir() if f.is_dir()}
    for module in sorted(folders - arrows.keys()):
        bad.append(f"src/endmill/{module}: not declared in src/CMakeLists.txt")
    for module in sorted(arrows.keys() - folders):
        bad.append(f"src/CMakeLists.txt: {module} has no folder src/endmill/{module}")
    for folder in sorted(f for f in (root / "src/endmill").glob("*/**") if f.is_dir()):
        inside = folder.relative_to(root / "src/endmill").parts[1:]
        if inside not in ((), ("detail",)):
            bad.append(f"{folder.relative_to(root)}: a module has no folder but detail/")


def sources(root, *folders):
    """(path below the root, text, its includes) of the C++ files in some folders."""
    for folder in folders:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                text = file.read_text(encoding="utf-8")
                yield file.relative_to(root), text, INCLUDE.findall(text)


def check_includes(root, arrows, bad):
    for file, _, includes in sources(root, "src/endmill"):
        if len(file.parts) < 4:
            continue  # an umbrella header
        module = file.parts[2]
        may_use = arrows.get(module, set()) | {module}
        for included in includes:
            top, *rest = included.split("/")
            if top == "endmill" and (len(rest) < 2 or rest[0] not in may_use):
                bad.append(f"{file}: {module} -> {rest[0]}")
            if top in ("..", "cli"):
                bad.append(f"{file}: includes {included}")


def check_unused_arrows(root, arrows, bad):
    used = {module: set() for module in arrows}
    for file, _, includes in sources(root, "src/endmill"):
        if len(file.parts) > 3:
            used.setdefault(file.parts[2], set()).update(
                included.split("/")[1] for included in includes if included.startswith("endmill/"))
    for module, uses in arrows.items():
        if (root / "src/endmill" / module).is_dir():
            for unused in sorted(uses - used[module]):
                bad.append(f"src/CMakeLists.txt: {module} declares {unused}"
                           " and includes no header of it")


def words_of(name):
    """The words of a name such as TwoWords or two_words, sorted, in lower case."""
    return tuple(sorted(word.lower() for word in WORD.findall(name)))


def check_word_order(root, bad):
    types, files = {}, {}
    for file, text, _ in sources(root, "src"):
        files.setdefault(words_of(file.stem), set()).add(file.stem)
        for name in TYPE.findall(text):
            types.setdefault(words_of(name), set()).add(name)
    for kind, groups in (("types", types), ("files", files)):
        for names in sorted(sorted(names) for names in groups.values() if len(names) > 1):
            bad.append(f"src: names of {kind} differ only in the order of words: "
                       + ", ".join(names))


def check_headers(root, bad):
    for file, _, includes in sources(root, "src"):
        for included in includes if file.suffix == ".h" else ():
            if KEPT_INSIDE.match(included):
                bad.append(f"{file}: {included} belongs in a .cpp file")


def check_detail(root, bad):
    """Only the library's sources, its tests and experiments may include headers of detail/ folders."""
    for file, _, includes in sources(root, "src", "docs/examples"):
        is_public = file.parts[:2] == ("src", "endmill") and file.suffix == ".h" \
            and "detail" not in file.parts
        is_outside = file.parts[:2] != ("src", "endmill")
        for included in includes:
            if "/detail/" in included and (is_public or is_outside):
                bad.append(f"{file}: includes {included}, which is not installed")


def check_public_headers(root, bad):
    modules = sorted(f for f in (root / "src/endmill").iterdir() if f.is_dir())
    shown = {module.name: sorted(h.name for h in module.glob("*.h")) for module in modules}
    for name, headers in shown.items():
        if len(headers) > MOST_HEADERS_OF_A_MODULE:
            bad.append(f"src/endmill/{name}: shows {len(headers)} headers,"
                       f" at most {MOST_HEADERS_OF_A_MODULE}")
        umbrella = root / f"src/endmill/{name}.h"
        included = INCLUDE.findall(umbrella.read_text(encoding="utf-8")) \
            if umbrella.exists() else []
        if included != [f"endmill/{name}/{header}" for header in headers]:
            bad.append(f"src/endmill/{name}.h: does not include exactly the headers of {name},"
                       " in order of their names")
    count = sum(map(len, shown.values())) + len(shown)
    if count > MOST_HEADERS:
        bad.append(f"src/endmill: {count} public headers, at most {MOST_HEADERS}")


def circles(graph):
    """The strongly connected parts of a graph that have more than one node (Tarjan)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(graph[node]):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            part = stack[stack.index(node):]
            del stack[stack.index(node):]
            if len(part) > 1:
                found.append(sorted(part))

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return found


def check_units(root, bad):
    graph, files = {}, list(sources(root, "src"))
    for file, _, _ in files:
        graph.setdefault(str(file.with_suffix("").relative_to("src")), set())
    for file, _, includes in files:
        unit = str(file.with_suffix("").relative_to("src"))
        used = {included.removesuffix(".h") for included in includes}
        graph[unit] |= (used & graph.keys()) - {unit}
    for circle in circles(graph):
        bad.append("src: units include each other in a circle: " + " ".join(circle))


def check_tests(root, bad):
    for file, _, _ in sources(root, "src/endmill"):
        if file.suffix != ".h" or len(file.parts) < 4:
            continue
        folder = root / "tests" / file.parts[2]
        if not any(folder.glob(f"{file.stem}_test.cpp")) and \
                not any(folder.glob(f"{file.stem}_*_test.cpp")):
            bad.append(f"{file}: has no tests/{file.parts[2]}/{file.stem}_test.cpp")


def checked_files(root):
    """Sources, scripts and CMake files."""
    for folder in ("src", "experiments", "tests", "scripts", "cmake", "docs"):
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
    check_unused_arrows(root, arrows, bad)
    check_word_order(root, bad)
    check_headers(root, bad)
    check_detail(root, bad)
    check_public_headers(root, bad)
    check_units(root, bad)
    check_tests(root, bad)
    check_texts(root, bad)
    print("\n".join(bad) or f"{len(arrows)} modules, all as declared")
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT))
