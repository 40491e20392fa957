# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of every claim of the four papers, experiments/claims.csv."""
from itertools import groupby

from reproduction.fault import Fault
from reproduction.tables import read_table
from reproduction.verdicts import INPUT, VERDICTS

from .numbers import escape

COLUMNS = ["id", "paper", "place", "kind", "claim", "experiment", "row", "column", "verdict"]
DEFINITION = "definition"
MOST_WORDS = 3  # in which neighbouring claims may differ to share a line of the table
PAPERS = {
    "economic-cl-data": "Kim and Choi: economic CL data",
    "interference": "Jang, Kim and Jeong: removal of interference",
    "five-axis-setup": "Kang and Suh: five-axis setups",
    "ball-end-milling": "Park and Maeng: ball-end milling",
}
WIDTHS = (0.11, 0.15, 0.425, 0.115, 0.125)  # of the columns, in widths of the text
LEFT = r">{\raggedright\arraybackslash}"
HEAD = (r"\begin{longtable}{@{}" + "".join(rf"{LEFT}p{{{width}\textwidth}}" for width in WIDTHS) + "@{}}\n"
        + r"\toprule id & place & claim & experiment & verdict \\ \midrule \endhead" + "\n"
        + r"\bottomrule \endfoot" + "\n")


def shown_verdict(verdict):
    """The word of a verdict in the paper."""
    return "input" if verdict == INPUT else escape(verdict)


def read_claims(path):
    """The rows of claims.csv as dictionaries. Raises Fault, naming the row, if one is malformed or stands twice."""
    table = read_table(path)
    missing = [column for column in COLUMNS if column not in table.header]
    if missing:
        raise Fault(f"{path}: no column {', '.join(missing)}")
    rows, seen = [dict(zip(table.header, row)) for row in table.rows], set()
    for line, row in enumerate(rows, start=2):
        where = f"{path}:{line}: claim {row['id']!r}"
        if row["id"] in seen:
            raise Fault(f"{where} stands twice")
        if row["paper"] not in PAPERS:
            raise Fault(f"{where}: unknown paper {row['paper']!r}, expected {', '.join(PAPERS)}")
        if row["verdict"] not in (*VERDICTS, DEFINITION):
            raise Fault(f"{where}: verdict {row['verdict']!r}, expected one of {', '.join(VERDICTS)}, {DEFINITION}")
        seen.add(row["id"])
    return rows


def breakable(name):
    """A name in which lines may break behind hyphens and slashes."""
    return escape(name).replace("-", r"-\allowbreak{}").replace("/", r"/\allowbreak{}")


def shared(first, second):
    """The numbers of words that two texts share at their beginning and at their end."""
    a, b = first.split(" "), second.split(" ")
    least = min(len(a), len(b))
    start = next((i for i in range(least) if a[i] != b[i]), least)
    end = next((i for i in range(least - start) if a[-1 - i] != b[-1 - i]), least - start)
    return start, end


def joined(claims):
    """One text for claims that differ in a few words, such as `A and B: such and such`; None if they differ more."""
    if len(set(claims)) == 1:
        return claims[0]
    words = claims[0].split(" ")
    start = min(shared(claims[0], other)[0] for other in claims[1:])
    end = min(shared(claims[0], other)[1] for other in claims[1:])
    middles = [claim.split(" ")[start:len(claim.split(" ")) - end] for claim in claims]
    if any(not middle or len(middle) > MOST_WORDS for middle in middles) or start + end < MOST_WORDS:
        return None
    texts = [" ".join(middle) for middle in middles]
    ends = ".,:;" + (")" if all(text.count(")") > text.count("(") for text in texts) else "")
    listed = list(dict.fromkeys(text.rstrip(ends) for text in texts))
    tail = texts[-1][len(texts[-1].rstrip(ends)):]
    return " ".join([*words[:start], " | ".join(listed) + tail, *words[len(words) - end:]])


def one_claim(rows):
    """One text for the claims of some rows, None if they are too different."""
    claims = [row["claim"] for row in rows]
    text = joined(claims)
    if text is None and all(row["kind"] == "cell" for row in rows) and claims[0].split()[:2] == claims[-1].split()[:2]:
        return f"{claims[0]} … {claims[-1]} ({len(claims)} cells)"
    return text


def shown_ids(rows):
    """The ids of some rows, such as `KC-T1-01 to 18`."""
    first, last = rows[0]["id"], rows[-1]["id"]
    if len(rows) == 1:
        return first
    start = next((i for i, (a, b) in enumerate(zip(first, last)) if a != b), 0)
    while start > 0 and first[start - 1].isdigit() and last[start:start + 1].isdigit():
        start -= 1  # whole numbers
    return f"{first} to {last[start:]}"


def merged(rows):
    """The rows with neighbours joined that differ in a few words of the claim only, or are cells of one table."""
    groups = []
    for row in rows:
        group = groups[-1] if groups else []
        alike = group and all(group[0][key] == row[key] for key in ("place", "experiment", "verdict"))
        if alike and one_claim([*group, row]) is not None:
            group.append(row)
        else:
            groups.append([row])
    return [{**group[0], "claim": one_claim(group), "id": shown_ids(group)} for group in groups]


def line_of(row):
    """One claim as a row of the table."""
    item = row["experiment"].split("/")[-1] if row["verdict"] != DEFINITION else ""
    cells = [breakable(row["id"]), escape(row["place"]), escape(row["claim"]), breakable(item.strip("–")),
             "" if row["verdict"] == DEFINITION else shown_verdict(row["verdict"])]
    return " & ".join(cells) + r" \\"


def claims_table(rows):
    """The LaTeX text of the table: a part for each paper, first its claims, then its definitions in one paragraph."""
    parts = []
    for paper, group in groupby(sorted(rows, key=lambda row: list(PAPERS).index(row["paper"])),
                                key=lambda row: row["paper"]):
        group = list(group)
        checked = [row for row in group if row["verdict"] != DEFINITION]
        defined = [row for row in group if row["verdict"] == DEFINITION]
        parts.append(rf"\pagebreak[3]\section{{{escape(PAPERS[paper])}}}" + "\n{\\claimsize\n" + HEAD)
        parts += [line_of(row) for row in merged(checked)]
        parts.append(r"\end{longtable}" + "\n}")
        if defined:
            listed = "; ".join(f"{escape(row['id'])} ({escape(row['place'])})" for row in defined)
            parts.append("{\\claimsize\\raggedright Definitions, background and motives, which claim nothing "
                         f"that could be checked: {listed}.\\par}}\n")
    return "\n".join(parts)
