# SPDX-License-Identifier: GPL-3.0-or-later
"""Two pages beside the report: every claim of the papers, and every row of published.csv by verdict."""
from collections import Counter, defaultdict
from html import escape
from itertools import groupby

from .claim_list import DEFINITION
from .claims import Claim
from .experiments import place_of_paper
from .markup import anchor, counted, in_words, page, row_anchor, table, word
from .sections import readme_of
from .summary import verdict_place
from .verdicts import VERDICTS

REPORT = "report.html"
CLAIMS = "claims.html"
VERDICT_ROWS = "verdicts.html"


def judged_rows(outcome):
    """(id on the page, number or claim) of each row of published.csv of one item."""
    for judged in (outcome.lines, outcome.claims):
        for place, one in enumerate(judged):
            yield row_anchor(outcome.experiment, one, place), one


def item_link(outcome, place):
    """A link to the row with the id `place` of an item."""
    return f'<a href="{REPORT}#{place}">{escape(readme_of(outcome.experiment).title)}</a>'


def index_rows(outcomes):
    """Maps (experiment, row, column) to the [(outcome, id, number or claim)] of the pages."""
    index = defaultdict(list)
    for outcome in outcomes:
        for place, judged in judged_rows(outcome):
            index[outcome.experiment.name, judged.row, judged.column].append((outcome, place, judged))
    return index


def claim_row(claim, index):
    """The verdict of a claim, and its cells. The computed result decides the verdict, if there is one."""
    found = index.get((claim.experiment, claim.row, claim.column), [])
    same = [entry for entry in found if entry[2].verdict == claim.verdict] or found
    if same:
        outcome, place, judged = same[0]
        verdict, shown, link = judged.verdict, judged.shown_verdict, item_link(outcome, place)
    else:
        verdict = shown = claim.verdict
        link = f"<code>{escape(claim.experiment)}</code>" if claim.experiment else ""
    texts = [escape(text) for text in (claim.place, claim.kind, claim.claim)]
    return verdict, [f"<span class=id>{escape(claim.id)}</span>", *texts, word(shown, verdict), link]


def claim_counts(verdicts):
    """The number of claims with each verdict, in words."""
    counts = Counter(verdicts)
    definitions = counts[DEFINITION]
    said = [counted(counts), f"{definitions} definition{'' if definitions == 1 else 's'}" if definitions else ""]
    return f"{len(verdicts)} claim{'' if len(verdicts) == 1 else 's'}: {', '.join(filter(None, said))}."


def claims_page(claims, outcomes, titles):
    """The page of all claims, paper by paper in the order of the papers. `titles` maps a paper to its title."""
    index = index_rows(outcomes)
    groups = groupby(sorted(claims, key=lambda c: place_of_paper(c.paper)), key=lambda c: c.paper)
    body = [f'<p><a href="{REPORT}">Back to the report</a>, which explains the verdicts. A claim that only defines or'
            f" motivates something has the verdict {word(DEFINITION)}.</p>"]
    for paper, group in groups:
        verdicts, rows = zip(*[claim_row(claim, index) for claim in group])
        body += [f'<h2 id="{anchor(paper)}">{escape(titles.get(paper, paper))}</h2>',
                 f"<p>{claim_counts(verdicts)}</p>",
                 table(["id", "place", "kind", "claim", "verdict", "computed in"], rows, label=f"claims of {paper}")]
    return page("endmill: every claim of the papers", [in_words(*body)])


def verdict_row(outcome, place, judged):
    """The cells of one number or claim: what it is, the print, ours, and the item."""
    if isinstance(judged, Claim):
        what, printed, ours = judged.text, f"holds if {judged.condition}" if judged.condition else "", judged.measured
    else:
        what, printed, ours = f"{judged.row}: {judged.column}", judged.published, judged.computed
    return [escape(what), escape(printed), escape(ours), item_link(outcome, place)]


def verdicts_page(papers):
    """The page of all rows of published.csv, by paper and verdict."""
    body = [f'<p><a href="{REPORT}">Back to the report</a>, which explains the verdicts.</p>']
    for paper in papers:
        if not paper.counts:
            continue
        body.append(f"<h2>{escape(paper.title)}</h2>")
        entries = [(outcome, place, judged) for outcome in paper.outcomes for place, judged in judged_rows(outcome)]
        for verdict in VERDICTS:
            rows = [verdict_row(*entry) for entry in entries if entry[2].verdict == verdict]
            if rows:
                body += [f'<h3 id="{verdict_place(paper.name, verdict)}">{len(rows)} {word(verdict)}</h3>',
                         table(["number or claim", "published", "computed", "item"], rows, label=verdict)]
    return page("endmill: every published number and claim by verdict", [in_words(*body)])
