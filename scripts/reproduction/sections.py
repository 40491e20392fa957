# SPDX-License-Identifier: GPL-3.0-or-later
"""The section of one item in the report: claim, numbers, figures, description and run."""
import base64
from html import escape
from urllib.parse import quote

from . import claims, prose, views
from .markup import addresses, anchor, in_words, row_anchor, table, word
from .tables import rounded
from .verdicts import SHOWN

LONGEST_TABLE = 60  # rows; a longer result is a link to its CSV file
DIGITS = 5  # of the numbers in the table of a result


def read(path):
    """The text of a file, empty without the file."""
    try:
        return path.read_text(encoding="utf-8")
    except OSError:
        return ""


def readme_of(experiment, names=()):
    """The README of an item; its links lead to the items `names` of the page or to files."""
    return prose.read(read(experiment.folder / "README.md"), experiment.name,
                      addresses(experiment.root, experiment.folder, names))


def judged_table(outcome, judged, head, numeric, label):
    """The table of the numbers or of the claims of an item, without empty columns. The last column is the verdict."""
    if not judged:
        return ""
    rows = [[escape(text) for text in one.shown()[:-1]] + [word(one.shown_verdict, one.verdict)] for one in judged]
    filled = [column for column in range(len(head)) if any(row[column] for row in rows)]
    ids = [row_anchor(outcome.experiment, one, place) for place, one in enumerate(judged)]
    return table([head[column] for column in filled], [[row[column] for column in filled] for row in rows],
                 [place for place, column in enumerate(filled) if column in numeric], label, ids)


def result_table(outcome):
    """The table of the result, if it is short and the experiment has no published numbers."""
    result = outcome.result
    if outcome.lines or not result.rows or len(result.rows) > LONGEST_TABLE:
        return ""
    rows = [[escape(row[0])] + [escape(rounded(text, DIGITS)) for text in row[1:]] for row in result.rows]
    return table([escape(name) for name in result.header], rows,
                 numeric=range(1, len(result.header)), label="result")


def pictures(outcomes):
    """The files of all figures with their sizes in the page, small ones first."""
    files = [outcome.experiment.results / figure["file"] for outcome in outcomes for figure in outcome.figures]
    return sorted((4 * ((file.stat().st_size + 2) // 3), file) for file in files)


def embedded(outcomes, most):
    """The files of the figures that become part of the page: small ones first, up to `most` bytes in all."""
    chosen, total = set(), 0
    for size, file in pictures(outcomes):
        total += size
        if total > most:
            break
        chosen.add(file)
    return chosen


def figure(outcome, description, inside):
    """A figure with the paper's caption and ours. It is an embedded image if its file is in `inside`. A drawing opens
    the page on which it can be turned, if there is one."""
    file = outcome.experiment.results / description["file"]
    caption = escape(description["caption"])
    lines = [f"<p>{caption}</p>"]
    if "published_caption" in description:
        lines = [f'<p>In the paper: {escape(description["published_caption"])}</p>', f"<p>Here: {caption}</p>"]
    opened = "" if "plot" in description else views.link(outcome.experiment)
    if file in inside:
        data = base64.b64encode(file.read_bytes()).decode()
        picture = f'<img src="data:image/svg+xml;base64,{data}" alt="{caption}">'
        if opened:
            picture = f'<a href="{quote(opened)}">{picture}</a>'
    else:
        address = quote(f"{outcome.experiment.name}/{file.name}")
        picture = f'<a href="{quote(opened) or address}"><img loading="lazy" src="{address}" alt="{caption}"></a>'
        kilobytes = max(1, round(file.stat().st_size / 1000))
        lines.append(f'<p>A file beside this page: <a href="{address}">{escape(file.name)}</a>, {kilobytes} kB.</p>')
    return f'<figure><div class="scroll">{picture}</div><figcaption>{"".join(lines)}</figcaption></figure>'


def view(outcome):
    """A link to the page on which the part of an item can be turned, if there is one."""
    address = views.link(outcome.experiment)
    return f'<p><a href="{quote(address)}">Turn it in 3D</a></p>' if address else ""


def files(outcome):
    """Links to the CSV files of an item, relative to results/report.html."""
    experiment = outcome.experiment
    ours = sorted(path.name for path in experiment.results.glob("*.csv"))
    kept = [name for name in ("published.csv", "expected.csv")
            if (experiment.folder / name).exists()]
    links = [(name, f"{experiment.name}/{name}") for name in ours]
    links += [(name, f"../experiments/{experiment.name}/{name}") for name in kept]
    return ", ".join(f'<a href="{quote(url)}">{escape(name)}</a>' for name, url in links)


def for_developers(outcome, readme):
    """The run and its comparison with expected.csv. It is open if the result departs from expected.csv."""
    run = outcome.run
    broken = "".join(f"<li>{escape(str(cell))}</li>" for cell in outcome.broken)
    return "\n".join([
        f"<details{' open' if outcome.broken else ''}><summary>For developers</summary>",
        f"<p>Regression {word(outcome.regression)}. Run: {run['seconds']:.2f} s, {escape(run['started'])},"
        f" revision {escape(run['revision'])}.</p>",
        f"<p>Compared: {readme.compared}</p>" if readme.compared else "",
        f"<ul class=trouble>{broken}</ul>" if broken else "",
        "</details>",
    ])


def section(outcome, names, inside):
    """One item. `names` are the items of the page, `inside` the files of the embedded figures."""
    experiment = outcome.experiment
    readme = readme_of(experiment, names)
    faults = "".join(f"<li>{escape(text)}</li>" for text in outcome.faults)
    earlier = "" if outcome.fresh else "<strong>Not run this time</strong>; the result of an earlier run. "
    return "\n".join([
        f'<section id="{anchor(experiment.paper, experiment.item)}">',
        f"<h3>{escape(readme.title)}</h3>",
        f"<p class=claim>{readme.claim}</p>" if readme.claim else "",
        f"<ul class=trouble>{faults}</ul>" if faults else "",
        judged_table(outcome, outcome.lines, SHOWN, range(2, 6), "published and computed"),
        in_words(judged_table(outcome, outcome.claims, claims.SHOWN, [2, 3], "claims and measurements")),
        result_table(outcome),
        *[figure(outcome, description, inside) for description in outcome.figures],
        view(outcome),
        f"<div class=about>{readme.body}</div>",
        f"<p class=quiet>{earlier}<code>{escape(experiment.name)}</code>; files: {files(outcome)}</p>",
        for_developers(outcome, readme),
        "</section>",
    ])
