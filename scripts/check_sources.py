#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails if a `Source:` of a comment has no valid target, or a README of the library names a missing header.

A source has one of these forms, and several sources may follow each other:

* `[Key, eq. (4)]`, `[Key, section 2.1]`, `[Key, fig. 3]`, `[Key, theorem 1]` and so on: Key is an entry of
  paper/references.bib, and the number gives the place in the work;
* `docs/methods/removal.md, section 4` or `paper/notes/swept-cutter.md, section 2`: a file of the
  repository and a heading in it that begins with this number.

The text of a source ends with its paragraph. No comment, and no docstring of a Python file, may refer to
a "spec" or "specification" as a document; these words in quotes are allowed.

Each header that src/endmill/README.md or src/endmill/MODULE/README.md names must exist: `vec.h` in any module or
its detail/ folder, `detail/line.h` in the README's own module, `core/orientation.h` and
`endmill/core/orientation.h` below src/endmill.
"""
import ast
import io
import re
import sys
import tokenize
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("src", "tests", "experiments", "scripts", "docs")
COMMENT = re.compile(r"^\s*(?://+[/!<]*|\*|#)\s?(.*)$")
TRAILING = re.compile(r"\s//+<?\s?(.*)$")
KEYED = re.compile(r"\[([A-Z][A-Za-z0-9]+)(?:,\s*([^\]]*))?\]")
FILE = re.compile(r"\b((?:docs|paper|experiments|datasets)/[\w./-]+\.\w+)(?:,\s+sections?\s+([0-9][0-9.]*))?")
ENTRY = re.compile(r"^@\w+\{([^,]+),", re.M)
HEADING = re.compile(r"^#+\s+(?:section\s+)?([0-9]+(?:\.[0-9]+)*)\b", re.M | re.I)
HEADER = re.compile(r"(?<![\w./-])[\w./-]*\w\.h\b")
# Words such as specifier and specialisation are allowed.
SPEC = re.compile(r"(?<!\")\b(?:specs?|specification|spec's)\b(?!\")", re.I)
DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)


def paragraphs(text):
    """(first line number, text) of each paragraph of comments."""
    begin, lines = None, []
    for number, line in enumerate(text.splitlines(), start=1):
        match = COMMENT.match(line) or TRAILING.search(line)
        body = match[1].strip() if match else ""
        starts_anew = body.startswith(("\\", "@", "Source"))
        if lines and (not body or starts_anew):
            yield begin, " ".join(lines)
            lines = []
        if body:
            begin = begin if lines else number
            lines.append(body)
    if lines:
        yield begin, " ".join(lines)


def python_paragraphs(text):
    """The same of the docstrings and comments of a Python file; each of them is one paragraph."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, DOCUMENTED) and ast.get_docstring(node):
            yield node.body[0].lineno, " ".join(ast.get_docstring(node).split())
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string


def faults(source, keys, root):
    """The error in the text after `Source:`, if any."""
    keyed, files = KEYED.findall(source), FILE.findall(source)
    if not keyed and not files:
        yield "names neither a [Key, number] nor a file of the repository"
    for key, place in keyed:
        if key not in keys:
            yield f"[{key}] is not in paper/references.bib"
        elif not re.search(r"\d|[IVX]+\b|[A-Z]\b|\bentry\b", place):
            yield f"[{key}] has no number of an equation, section, figure, table or theorem"
    for name, section in files:
        file = root / name
        if not file.exists():
            yield f"{name} does not exist"
        elif section and section.rstrip(".") not in HEADING.findall(file.read_text(encoding="utf-8")):
            yield f"{name} has no section {section.rstrip('.')}"


def missing_headers(root):
    """The headers named in the README files of the library that do not exist."""
    library = root / "src/endmill"
    names = {file.name for file in library.rglob("*.h")}
    for readme in sorted([*library.glob("README.md"), *library.glob("*/README.md")]):
        for line, text in enumerate(readme.read_text(encoding="utf-8").splitlines(), start=1):
            for named in HEADER.findall(text):
                places = (readme.parent / named, library / named, root / "src" / named)
                exists = any(p.is_file() for p in places) if "/" in named else named in names
                if not exists:
                    yield f"{readme.relative_to(root)}:{line}: no header {named}"


def main(root):
    keys = set(ENTRY.findall((root / "paper/references.bib").read_text(encoding="utf-8")))
    bad, count = [], 0
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp", ".py"):
                continue
            is_python = file.suffix == ".py"
            parts = python_paragraphs if is_python else paragraphs
            for line, text in parts(file.read_text(encoding="utf-8")):
                where = f"{file.relative_to(root)}:{line}"
                if SPEC.search(text):
                    bad.append(f"{where}: refers to a specification that is not in the repository")
                if not is_python and re.search(r"(?<!\w)(?<!::)Source:(?!:)", text):
                    count += 1
                    source = text.split("Source:", 1)[1]
                    bad += [f"{where}: {fault}" for fault in faults(source, keys, root)]
    bad += missing_headers(root)
    print("\n".join(bad) or f"{count} sources, all in the repository or in a cited work")
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT))
