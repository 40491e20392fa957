# SPDX-License-Identifier: GPL-3.0-or-later
"""The HTML that all pages of the report share: words, anchors, tables and the frame of a page."""
import re
from html import escape
from pathlib import Path
from urllib.parse import quote

from .claim_list import DEFINITION
from .verdicts import INPUT, VERDICTS

STYLE = (Path(__file__).parent / "report.css").read_text(encoding="utf-8")
# Pictures are part of the page or files beside it; an SVG image cannot run scripts or load files.
POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data: 'self' file:"
SHOWN_INPUT = "input"
# The class of a verdict or a state in report.css.
COLOUR = {
    "reproduced": "good", "ok": "good", "print agrees": "print", "calibrated": "fitted",
    "differs": "bad", "print disagrees": "bad", "failed": "bad",
    "not recoverable": "open", "not in the paper": "open", INPUT: "quiet", DEFINITION: "quiet",
    "no expected.csv": "quiet",
}


def verdict_text(text):
    """The words that the pages show for a verdict."""
    return SHOWN_INPUT if text == INPUT else text


def word(text, meaning=None):
    """A verdict or a state as a coloured word."""
    colour = COLOUR.get(meaning or text, "bad")
    return f'<span class="word {colour}">{escape(verdict_text(text))}</span>'


def anchor(*parts):
    """The id of a paper, an item, or a place in it."""
    return escape("-".join(parts).replace(" ", "-"), quote=True)


def row_anchor(experiment, judged, place):
    """The id of a row of the tables of an item: the `place`-th of its numbers or of its claims."""
    return anchor(experiment.paper, experiment.item, f"{type(judged).__name__.lower()}-{place}")


def table(head, rows, numeric=(), label="table", ids=None):
    """A table of HTML cells, in a box that scrolls. `numeric` columns are aligned to the right.

    `ids` are the ids of the rows, if others link to them.
    """

    def row(tag, row_cells, row_id=None):
        marked = [f'<{tag}{" class=number" if i in numeric else ""}>{cell}</{tag}>'
                  for i, cell in enumerate(row_cells)]
        start = f'<tr id="{row_id}">' if row_id else "<tr>"
        return start + "".join(marked) + "</tr>"

    body = "\n".join(row("td", cells, row_id) for cells, row_id in zip(rows, ids or [None] * len(rows)))
    return (f'<div class="scroll" tabindex="0" role="region" aria-label="{escape(label)}">'
            "<table class=numbers>"
            f'<thead>{row("th", head)}</thead>\n<tbody>{body}</tbody></table></div>')


def in_words(*pieces):
    """Pieces of a page whose tables hold sentences, which may be broken into lines."""
    return "\n".join(["<div class=words>", *pieces, "</div>"])


def counted(counts):
    """Counts of verdicts in words, without definitions: `3 reproduced, 1 differs, 2 input`."""
    return ", ".join(f"{counts[v]} {verdict_text(v)}" for v in VERDICTS if counts[v])


def addresses(root, folder, names):
    """The function that maps a link of a file in `folder` to its address on the page of the items `names`.

    A link to an item or a paper becomes its place on the page. Any other link must name a file of the repository.
    """
    papers = {name.split("/")[0] for name in names}

    def address(target):
        path, _, fragment = target.partition("#")
        if not path or re.match(r"[\w+.-]*:|/", path):
            return None
        file = (folder / path).resolve()
        if not file.is_relative_to(root) or not file.exists():
            return None
        parts = file.relative_to(root).parts
        inner = parts[1:-1] if parts[-1:] == ("README.md",) else parts[1:]
        if parts[:1] == ("experiments",) and ("/".join(inner) in names or "/".join(inner) in papers):
            return "#" + anchor(*inner)
        return "../" + quote("/".join(parts)) + (f"#{quote(fragment)}" if fragment else "")

    return address


def page(title, body):
    """A whole page with the HTML pieces of `body`."""
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{escape(title)}</title>",
        f"<style>{STYLE}</style></head><body><main>",
        f"<h1>{escape(title)}</h1>", *body, "</main></body></html>", "",
    ])
