# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes results/report.html and the pages beside it: static pages without scripts that open offline."""
from collections import Counter
from html import escape
from itertools import groupby

from .claim_list import FILE, read_claims
from .fault import Fault
from .markup import anchor, counted, page, word
from .row_pages import CLAIMS, REPORT, VERDICT_ROWS, claims_page, verdicts_page
from .sections import embedded, readme_of, section
from .summary import Paper, counts_table, in_short, legend

LEAD = ("This page shows the tables, figures and claims of four papers, each computed again by this project, beside the"
        " print. Each published number and each claim has one verdict.")
MOST_BYTES = 3_900_000  # of the page, which is to stay below 4 MB. Pictures beyond that are files beside it.


def contents(papers):
    """The table of contents: each item with its verdicts."""
    html = ["<nav><ul>"]
    for paper in papers:
        html.append(f'<li><a href="#{anchor(paper.name)}">{escape(paper.title)}</a><ul>')
        for outcome in paper.outcomes:
            experiment = outcome.experiment
            said = counted(Counter(outcome.verdicts))
            html.append(f'<li><a href="#{anchor(experiment.paper, experiment.item)}">'
                        f"{escape(readme_of(experiment).title)}</a>"
                        + (f" <span class=quiet>{escape(said)}</span>" if said else "") + "</li>")
        html.append("</ul></li>")
    return "\n".join(html + ["</ul></nav>"])


def regression(outcomes):
    """One line on all comparisons with expected.csv, with links to the items that failed or departed from it."""
    counts = Counter("broken" if outcome.broken else outcome.regression for outcome in outcomes)
    said = ", ".join(f"{count} {word(state)}" for state, count in counts.items())
    bad = [outcome.experiment for outcome in outcomes if not outcome.good]
    links = ", ".join(f'<a href="#{anchor(e.paper, e.item)}">{escape(e.name)}</a>' for e in bad)
    return said + (f": {links}" if links else "")


def about(outcomes, not_run, revision, machine, date):
    """Revision, machine and compiler of this page, and the results of the regression tests."""
    load = ", ".join(map(str, machine["load_average"]))
    rows = {
        "Revision": escape(revision),
        "Made": escape(date),
        "Machine": escape(f'{machine["cpu"]}, {machine["cores"]} cores, load average {load}'),
        "Compiler": escape(machine["compiler"]),
        "Experiments": f"{len(outcomes)} with a result",
        "Against earlier results": regression(outcomes),
    }
    if not_run:
        rows["Never run here"] = escape(", ".join(not_run))
    return ('<h2 id="about">About this page</h2><dl>'
            + "".join(f"<dt>{k}</dt><dd>{v}</dd>" for k, v in rows.items()) + "</dl>")


def listed_claims(root):
    """The claims of claims.csv, and the fault if it cannot be read. Both are empty without the file."""
    if not (root / FILE).exists():
        return [], ""
    try:
        return read_claims(root), ""
    except Fault as fault:
        return [], str(fault)


def other_pages(claims, fault):
    """Links to the pages beside the report."""
    links = [f'<a href="{VERDICT_ROWS}">every published number and claim by verdict</a>']
    if claims:
        links.append(f'<a href="{CLAIMS}">all {len(claims)} claims of the papers with their places</a>')
    return f"<p>Beside this page: {', '.join(links)}.</p>" + (f"<p class=trouble>{escape(fault)}</p>" if fault else "")


def items(papers, names, inside):
    """The sections of all papers. `inside` are the files of the embedded figures."""
    for paper in papers:
        yield f'<h2 id="{anchor(paper.name)}">{escape(paper.title)}</h2>'
        yield from (section(outcome, names, inside) for outcome in paper.outcomes)


def render(root, outcomes, not_run, revision, machine, date):
    """The pages, as a map from their names in results/ to their texts.

    `outcomes` are in the order of the report, `not_run` are the names without any result.
    """
    groups = groupby(outcomes, key=lambda outcome: outcome.experiment.paper)
    papers = [Paper(name, list(group)) for name, group in groups]
    names = {outcome.experiment.name for outcome in outcomes}
    claims, fault = listed_claims(root)
    head = [f"<p>{LEAD}</p>", *[in_short(paper, root, names, VERDICT_ROWS) for paper in papers],
            '<h2 id="verdicts">Verdicts</h2>', counts_table(papers, VERDICT_ROWS), legend(), other_pages(claims, fault),
            '<h2 id="contents">Contents</h2>', contents(papers)]
    end = about(outcomes, not_run, revision, machine, date)

    def report(inside):
        return page("endmill: published and computed", [*head, *items(papers, names, inside), end])

    pictures_fit_in = MOST_BYTES - len(report(set()).encode())
    pages = {REPORT: report(embedded(outcomes, pictures_fit_in)), VERDICT_ROWS: verdicts_page(papers)}
    if claims:
        pages[CLAIMS] = claims_page(claims, outcomes, {paper.name: paper.title for paper in papers})
    return pages
