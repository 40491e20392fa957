# SPDX-License-Identifier: GPL-3.0-or-later
"""The bibliography of the paper, from paper/references.bib."""
import re

KOREAN = re.compile("[\u1100-\u11ff\u3130-\u318f\uac00-\ud7af]")
SENTENCE = re.compile(r"(?<=\.)\s+")


def without_korean(line):
    """A line of the file without the sentences or fields in Korean letters, for which pdfTeX has no fonts.

    The file itself keeps the printed titles and names.
    """
    if not KOREAN.search(line):
        return line
    field, brace, value = line.partition("{")
    kept = [sentence for sentence in SENTENCE.split(value.rstrip().rstrip(",").rstrip("}"))
            if not KOREAN.search(sentence)]
    return f"{field}{brace}{' '.join(kept)}}}," if kept and kept[0] else ""


def latin_bibliography(text):
    """The text of references.bib in Latin letters."""
    return "\n".join(without_korean(line) for line in text.splitlines()) + "\n"
