#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Divides source files into batches that compile as one file each.

Files keep their helpers in unnamed namespaces, so two files may use the same name for different
things. Such files must not share a batch. A file joins the first batch with room in which no file
mentions a helper of this file, and whose helpers this file does not mention. A file with
`using enum` or `using namespace` in the first column stays alone.

Example: scripts/batch_sources.py 8 tests/core/*_test.cpp

Prints one batch per line, as file names separated by semicolons. CMake calls this script
(cmake/endmill_module.cmake).
"""
import re
import sys
from pathlib import Path

# After clang-format, a declaration at namespace scope begins in the first column.
ALIAS_OR_TYPE = re.compile(r"using\s+(\w+)\s*=|(?:struct|enum class|class|enum)\s+(\w+)")
FUNCTION_OR_VARIABLE = re.compile(r"[A-Za-z_][\w:<>,&*\s]*?[\s&*](\w+)\s*(?:[(\[={;]|$)")
NO_HELPER = re.compile(r"(?:using|namespace|template|TEST|TEST_F|TEST_P|INSTANTIATE\w*)\b")
# A member or a qualified name is never a helper of another file.
WORD = re.compile(r"(?<![\w.>:])[A-Za-z_]\w*|(?<=[^-]>)[A-Za-z_]\w*|(?<=[^:]:)[A-Za-z_]\w*")
INTRODUCED = re.compile(r"^using\s+[\w:]+::(\w+);", re.MULTILINE)
# Argument-dependent lookup also finds the functions of the namespace test.
SHARED = re.compile(r"\btest::(\w+)")
# These bring names that the text does not show.
OPENS = re.compile(r"^using (?:enum|namespace)\b", re.MULTILINE)
TEXT = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')


def helpers(text):
    """The names that `text` declares in unnamed namespaces, and its aliases outside them."""
    names = set()
    is_unnamed = False
    for line in text.splitlines():
        if line == "namespace {" or line == "}  // namespace":
            is_unnamed = line == "namespace {"
        found = ALIAS_OR_TYPE.match(line) if is_unnamed or line.startswith("using") else None
        if is_unnamed and not found and not NO_HELPER.match(line):
            found = FUNCTION_OR_VARIABLE.match(line)
        if found:
            names.add(found[found.lastindex])
    return names


def words(text):
    """The identifiers of `text` that may mean a helper, outside comments and string literals."""
    plain = TEXT.sub(" ", text)
    return {*WORD.findall(plain), *INTRODUCED.findall(plain), *SHARED.findall(plain)}


def batches(texts, size):
    """Divides the keys of `texts` (name -> text) into lists of at most `size` names."""
    made = []  # of [files, helpers, words]
    alone = [name for name, text in texts.items() if OPENS.search(text)]
    for name, text in texts.items():
        if name in alone:
            continue
        own, used = helpers(text), words(text)
        for batch in made:
            if len(batch[0]) < size and not own & batch[2] and not used & batch[1]:
                batch[0].append(name)
                batch[1] |= own
                batch[2] |= used
                break
        else:
            made.append([[name], own, used])
    return [batch[0] for batch in made] + [[name] for name in alone]


def main(arguments):
    if len(arguments) < 2 or not arguments[0].isdigit() or arguments[0] == "0":
        print(__doc__, file=sys.stderr)
        return 2
    texts = {name: Path(name).read_text(encoding="utf-8") for name in arguments[1:]}
    for batch in batches(texts, int(arguments[0])):
        print(";".join(batch))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
