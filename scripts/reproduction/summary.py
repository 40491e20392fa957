# SPDX-License-Identifier: GPL-3.0-or-later
"""The first page of the report: each paper in short, the counts of its verdicts, and what a verdict means."""
import re
from collections import Counter
from dataclasses import dataclass
from html import escape

from . import prose
from .experiments import BESIDE_THE_PAPERS
from .markup import addresses, anchor, in_words, table, word
from .sections import read
from .verdicts import INPUT, VERDICTS

IN_SHORT = "In short"  # the heading in experiments/PAPER/README.md
MEANING = {
    "reproduced": "computed here from inputs that the paper gives, and equal within the print's rounding;"
                  " a claim in words holds",
    "print agrees": "arithmetic on printed numbers alone gives the printed number;"
                    " it says nothing about the method",
    "print disagrees": "arithmetic on printed numbers alone gives another number",
    "calibrated": "an input was fitted to this number or to others of its table:"
                  " agreement is no evidence",
    "differs": "computed independently, and not equal; the measurement contradicts a claim in words",
    "not recoverable": "an input is missing and cannot be derived from anything published",
    "not in the paper": "the paper uses a value but does not print it; ours is marked as ours",
    INPUT: "an input that the paper prints",
}


@dataclass(frozen=True)
class Paper:
    """The outcomes of one folder of experiments."""

    name: str
    outcomes: list

    @property
    def folder(self):
        return self.outcomes[0].experiment.folder.parent

    @property
    def title(self):
        """The heading of experiments/PAPER/README.md, or the name of the folder without a heading."""
        return prose.read(read(self.folder / "README.md"), self.name).title

    @property
    def authors(self):
        """The authors, which stand in brackets at the end of the title, or the title without authors."""
        found = re.search(r"\(([^()]+)\)$", self.title)
        return found[1] if found else self.title

    @property
    def counts(self):
        """The number of numbers and claims for each verdict."""
        return Counter(verdict for outcome in self.outcomes for verdict in outcome.verdicts)


def verdict_place(paper, verdict):
    """The id of the rows with a verdict on the page of all verdicts."""
    return anchor("verdict", paper, "input" if verdict == INPUT else verdict)


def linked_count(paper, verdict, verdict_page):
    """The number of rows of a paper with a verdict, linked to these rows."""
    count = paper.counts[verdict]
    return f'<a href="{verdict_page}#{verdict_place(paper.name, verdict)}">{count}</a>' if count else "0"


def print_sentence(paper, verdict_page):
    """One sentence on the verdicts of a paper that rest on printed numbers alone, empty without any verdict."""
    total = sum(count for verdict, count in paper.counts.items() if verdict != INPUT)
    said = " and ".join(f"{linked_count(paper, verdict, verdict_page)} {word(verdict)}"
                        for verdict in ("print agrees", "print disagrees") if paper.counts[verdict])
    if not total:
        return ""
    if not said:
        return f"None of its verdicts ({total}) rests on printed numbers alone."
    return (f"Of its {total} verdicts, {said}: arithmetic on printed numbers alone, which tests whether the print is"
            " consistent and says nothing about the method.")


def in_short(paper, root, names, verdict_page):
    """What was published, recomputed and found wrong in one paper. Empty if its README does not say so."""
    items = prose.listed(read(paper.folder / "README.md"), IN_SHORT, addresses(root, paper.folder, names))
    sentence = "" if paper.name in BESIDE_THE_PAPERS else print_sentence(paper, verdict_page)
    if not items and not sentence:
        return ""
    listed = "<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>" if items else ""
    return "\n".join([f'<h3><a href="#{anchor(paper.name)}">{escape(paper.title)}</a></h3>', listed,
                      f"<p class=quiet>{sentence}</p>" if sentence else ""])


def counts_table(papers, verdict_page):
    """The number of rows of each paper for each verdict, each linked to its rows."""
    judged = [paper for paper in papers if paper.counts]
    rows = [[f'<a href="#{anchor(paper.name)}">{escape(paper.authors)}</a>']
            + [linked_count(paper, verdict, verdict_page) for verdict in VERDICTS] for paper in judged]
    total = sum((paper.counts for paper in judged), Counter())
    rows.append(["all"] + [str(total[verdict]) for verdict in VERDICTS])
    head = [""] + [word(verdict) for verdict in VERDICTS]
    return in_words(table(head, rows, range(1, len(head)), "counts by verdict"))


def legend():
    meanings = (f"<dt>{word(v)}</dt><dd>{escape(MEANING[v])}</dd>" for v in VERDICTS)
    return "<dl>" + "".join(meanings) + "</dl>"
