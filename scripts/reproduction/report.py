# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes results/report.html, a static page without scripts that opens offline."""
import base64
from collections import Counter
from html import escape
from itertools import groupby
from pathlib import Path
from urllib.parse import quote

from . import claims, prose
from .tables import number
from .verdicts import INPUT, SHOWN, VERDICTS

STYLE = (Path(__file__).parent / "report.css").read_text(encoding="utf-8")
LONGEST_TABLE = 60  # rows; a longer result is a link to its CSV file
POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
# The class of a verdict or a state in report.css.
COLOUR = {
    "reproduced": "good", "ok": "good", "print agrees": "print", "calibrated": "fitted",
    "differs": "bad", "print disagrees": "bad", "failed": "bad",
    "not recoverable": "open", "not in the paper": "open", INPUT: "quiet",
    "no expected.csv": "quiet",
}
MEANING = {
    "reproduced": "computed without this number or anything fitted to it,"
                  " and equal within the print's rounding",
    "print agrees": "arithmetic on printed numbers alone gives the printed number;"
                    " it says nothing about the method",
    "print disagrees": "arithmetic on printed numbers alone gives another number",
    "calibrated": "an input was fitted to this number or to others of its table:"
                  " agreement is no evidence",
    "differs": "computed independently, and not equal",
    "not recoverable": "an input is missing and nothing published fixes it",
    "not in the paper": "the paper uses it without printing it; ours is named as ours",
    INPUT: "an input that the paper prints",
}


def word(text, meaning=None):
    """A verdict or a state as a coloured word."""
    colour = COLOUR.get(meaning or text, "bad")
    return f'<span class="word {colour}">{escape(text)}</span>'


def anchor(*parts):
    return escape("-".join(parts), quote=True)


def table(head, rows, numeric=(), label="table"):
    """A table of HTML cells, in a box that scrolls. `numeric` columns are aligned to the right."""

    def row(tag, row_cells):
        marked = [f'<{tag}{" class=number" if i in numeric else ""}>{cell}</{tag}>'
                  for i, cell in enumerate(row_cells)]
        return "<tr>" + "".join(marked) + "</tr>"

    body = "\n".join(row("td", cells) for cells in rows)
    return (f'<div class="scroll" tabindex="0" role="region" aria-label="{escape(label)}">'
            "<table class=numbers>"
            f'<thead>{row("th", head)}</thead>\n<tbody>{body}</tbody></table></div>')


def published_table(outcome):
    """The published numbers beside ours."""
    if not outcome.lines:
        return ""
    rows = [[escape(text) for text in line.shown()[:-1]] + [word(line.shown_verdict, line.verdict)]
            for line in outcome.lines]
    return table(SHOWN, rows, numeric=range(2, 6), label="published and computed")


def claims_table(outcome):
    """The claims in words, each with what was measured and what decides it."""
    if not outcome.claims:
        return ""
    rows = [[escape(claim.text), escape(claim.quantity), escape(rounded(claim.measured)),
             escape(claim.condition), word(claim.shown_verdict, claim.verdict)]
            for claim in outcome.claims]
    return table(claims.SHOWN, rows, numeric=[2], label="claims and measurements")


def rounded(text):
    """The text of a cell. Numbers that are not whole are rounded to five digits."""
    value = number(text)
    return text if value is None or value == int(value) else f"{value:.5g}"


def result_table(outcome):
    """The table of the result, if it is short and the experiment has no published numbers."""
    result = outcome.result
    if outcome.lines or not result.rows or len(result.rows) > LONGEST_TABLE:
        return ""
    rows = [[escape(rounded(text)) for text in row] for row in result.rows]
    return table([escape(name) for name in result.header], rows,
                 numeric=range(1, len(result.header)), label="result")


def figure(outcome, description):
    """A figure as an embedded image. An SVG image cannot run scripts or load files."""
    svg = (outcome.experiment.results / description["file"]).read_bytes()
    source = "data:image/svg+xml;base64," + base64.b64encode(svg).decode()
    caption = escape(description["caption"])
    return (f'<figure><div class="scroll"><img src="{source}" alt="{caption}"></div>'
            f"<figcaption>{caption}</figcaption></figure>")


def files(outcome):
    """Links to the CSV files of an item, relative to results/report.html."""
    experiment = outcome.experiment
    ours = sorted(path.name for path in experiment.results.glob("*.csv"))
    kept = [name for name in ("published.csv", "expected.csv")
            if (experiment.folder / name).exists()]
    links = [(name, f"{experiment.name}/{name}") for name in ours]
    links += [(name, f"../experiments/{experiment.name}/{name}") for name in kept]
    return ", ".join(f'<a href="{quote(url)}">{escape(name)}</a>' for name, url in links)


def circumstances(outcome):
    """Date, revision and duration of the run. An earlier run is marked in bold."""
    run = outcome.run
    when = "Run" if outcome.fresh else "<strong>Not run this time</strong>; earlier run"
    text = f'{run["seconds"]:.2f} s, {run["started"]}, revision {run["revision"]}'
    return f"<p class=quiet>{when}: {escape(text)}. Files: {files(outcome)}</p>"


def troubles(outcome):
    """Faults and broken cells, if any."""
    texts = outcome.faults + [str(cell) for cell in outcome.broken]
    items = "".join(f"<li>{escape(text)}</li>" for text in texts)
    return f"<ul class=trouble>{items}</ul>" if texts else ""


def readme_of(experiment):
    try:
        text = (experiment.folder / "README.md").read_text(encoding="utf-8")
    except OSError:
        text = ""
    return prose.read(text, experiment.name)


def paper_title(outcome):
    """The heading of experiments/PAPER/README.md, or the name of the folder without a heading."""
    try:
        text = (outcome.experiment.folder.parent / "README.md").read_text(encoding="utf-8")
    except OSError:
        text = ""
    return prose.read(text, outcome.experiment.paper).title


def section(outcome):
    """One item with title, claim, numbers, figures and run."""
    experiment = outcome.experiment
    readme = readme_of(experiment)
    return "\n".join([
        f'<section id="{anchor(experiment.paper, experiment.item)}">',
        f"<h3>{escape(readme.title)}</h3>",
        f"<p class=quiet><code>{escape(experiment.name)}</code>"
        f" · regression {word(outcome.regression)}</p>",
        f"<p class=claim>{readme.claim}</p>" if readme.claim else "",
        troubles(outcome),
        published_table(outcome),
        claims_table(outcome),
        result_table(outcome),
        *[figure(outcome, description) for description in outcome.figures],
        f"<div class=about>{readme.body}</div>",
        circumstances(outcome),
        "</section>",
    ])


def contents(papers):
    """The table of contents: each item with the state of its regression and its verdicts."""
    html = ["<nav><ul>"]
    for paper, title, outcomes in papers:
        html.append(f'<li><a href="#{anchor(paper)}">{escape(title)}</a><ul>')
        for outcome in outcomes:
            experiment = outcome.experiment
            counts = Counter(outcome.verdicts)
            said = [f" · {counts[v]} {v}" for v in VERDICTS if counts[v] and v != INPUT]
            html.append(f'<li><a href="#{anchor(experiment.paper, experiment.item)}">'
                        f"{escape(readme_of(experiment).title)}</a>"
                        " <span class=quiet>· regression "
                        f'{word(outcome.regression)}{escape("".join(said))}</span></li>')
        html.append("</ul></li>")
    return "\n".join(html + ["</ul></nav>"])


def counts_table(papers):
    """The number of cells of each paper for each verdict."""
    rows, total = [], Counter()
    for paper, title, outcomes in papers:
        counts = Counter(verdict for outcome in outcomes for verdict in outcome.verdicts)
        total += counts
        link = f'<a href="#{anchor(paper)}">{escape(title)}</a>'
        rows.append([link] + [str(counts[v]) for v in VERDICTS])
    rows.append(["all"] + [str(total[v]) for v in VERDICTS])
    head = [""] + [word(v) for v in VERDICTS]
    return table(head, rows, range(1, len(head)), "counts by verdict")


def legend():
    meanings = (f"<dt>{word(v)}</dt><dd>{escape(MEANING[v])}</dd>" for v in VERDICTS)
    return "<dl>" + "".join(meanings) + "</dl>"


def facts(outcomes, revision, machine, date):
    """Revision, machine and compiler of this page, and the number of failures."""
    good = sum(outcome.good for outcome in outcomes)
    load = ", ".join(map(str, machine["load_average"]))
    count = len(outcomes)
    rows = {
        "Revision": revision,
        "Made": date,
        "Machine": f'{machine["cpu"]}, {machine["cores"]} cores, load average {load}',
        "Compiler": machine["compiler"],
        "Experiments": f"{count} with a result, {count - good} failed or broken",
    }
    return "<dl>" + "".join(f"<dt>{k}</dt><dd>{escape(v)}</dd>" for k, v in rows.items()) + "</dl>"


def render(outcomes, not_run, revision, machine, date):
    """The page: `outcomes` in the order of their names, `not_run` the names without any result."""
    groups = groupby(outcomes, key=lambda outcome: outcome.experiment.paper)
    papers = [(paper, list(group)) for paper, group in groups]
    papers = [(paper, paper_title(group[0]), group) for paper, group in papers]
    body = [facts(outcomes, revision, machine, date), counts_table(papers), legend()]
    if not_run:
        body.append(f'<p class=quiet>Never run here: {escape(", ".join(not_run))}.</p>')
    body += ["<h2>Contents</h2>", contents(papers)]
    for paper, title, group in papers:
        body.append(f'<h2 id="{anchor(paper)}">{escape(title)}</h2>')
        body += [section(outcome) for outcome in group]
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        "<title>endmill: published and computed</title>",
        f"<style>{STYLE}</style></head><body><main>",
        "<h1>endmill: published and computed</h1>", *body, "</main></body></html>", "",
    ])
