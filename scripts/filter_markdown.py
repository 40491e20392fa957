#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts a Markdown file of the repository for Doxygen (docs/Doxyfile) and prints it.

scripts/filter_markdown.py FILE

* A page and its headings get labels; a link to another page, `[text](../conventions.md#units)`,
  leads to its label. A folder stands for its README.md.
* A link to any other file of the repository becomes plain text, since the site lacks the file.
* An image is named without its folders. Doxygen finds it by IMAGE_PATH.
* A broken link or image becomes a reference for which Doxygen prints a warning.

Example: scripts/filter_markdown.py docs/README.md
"""
import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)")
IMAGE = re.compile(r"!\[([^\]]*)\]\(([^)\s]+)\)")
HEADING = re.compile(r"(#+) (.+?)\s*#*$")
FENCE = re.compile(r"\s*(```|~~~)")


def label(path):
    """The label of the page of a Markdown file."""
    return "page_" + re.sub(r"\W", "_", str(path.with_suffix("")))


def slug(heading):
    """The anchor of a heading, by the rule of common hosting sites."""
    text = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def on_the_site(path):
    """Whether a Markdown file is one of the site's pages."""
    return len(path.parts) == 1 or path.parts[0] in ("docs", "experiments") or path.parts[:2] == ("src", "endmill")


def link(root, file, text, target):
    """A link of `file`, converted for Doxygen."""
    if re.match(r"[a-z]+:", target):
        return f"[{text}]({target})"
    name, _, anchor = target.partition("#")
    path = Path(os.path.normpath(file.parent / name)) if name else file
    if (root / path).is_dir():
        path = path / "README.md" if (root / path / "README.md").exists() else path
    if not (root / path).exists():
        return f"[{text}]({target})"
    if path.suffix != ".md" or not on_the_site(path):
        return text
    if path == Path("README.md") and not anchor:
        return f"[{text}](@ref index)"
    return f"[{text}](@ref {label(path)}{'_' + anchor if anchor else ''})"


def image(root, file, text, target):
    """An image of `file`, converted for Doxygen."""
    if re.match(r"[a-z]+:", target):
        return f"![{text}]({target})"
    if not (root / file.parent / target).exists():
        return f"@ref no_image_{re.sub(r'[^A-Za-z0-9]', '_', target)}"
    return f"![{text}]({Path(target).name})"


def filtered(root, file, text):
    """The converted text of `file`, a path below the root."""
    lines, fenced, titled = [], False, False
    for line in text.splitlines():
        if FENCE.match(line):
            fenced = not fenced
        heading = None if fenced else HEADING.match(line)
        if line.startswith("<!-- SPDX"):
            continue
        if not fenced:
            line = IMAGE.sub(lambda found: image(root, file, found[1], found[2]), line)
            line = LINK.sub(lambda found: link(root, file, found[1], found[2]), line)
        if heading and not titled and heading[1] == "#":
            titled = True
            line = f"{line} {{#{'mainpage' if file == Path('README.md') else label(file)}}}"
        elif heading:
            line = f"{line} {{#{label(file)}_{slug(heading[2])}}}"
        lines.append(line)
    return "\n".join(lines) + "\n"


def main(name):
    path = Path(name).resolve()
    sys.stdout.write(filtered(ROOT, path.relative_to(ROOT), path.read_text(encoding="utf-8")))


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] in ("--help", "-h"):
        print(__doc__, file=sys.stderr)
        sys.exit(0 if sys.argv[1:2] and sys.argv[1] in ("--help", "-h") else 2)
    main(sys.argv[1])
