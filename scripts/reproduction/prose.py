# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts the README of an experiment to HTML. It supports a small, safe part of Markdown.

This part has headings, paragraphs, lists, tables, fenced blocks, `code`, **bold** and links. A line with a comment,
such as the licence, is left out. Everything else is plain text. Every text is escaped before markup is added.

A function `address` maps the target of a link to its address in the page. It returns None for a target that the page
may not name; such a link becomes its text.
"""
import re
from dataclasses import dataclass
from html import escape, unescape


@dataclass(frozen=True)
class Readme:
    title: str
    claim: str  # HTML, empty without a row Claim in the first table
    compared: str  # HTML, empty without a row Compared there
    body: str  # HTML of all the rest


def no_address(_target):
    """The address of no link."""


def inline(text, address=no_address):
    """Converts one piece of text to HTML."""

    def link(match):
        words, found = match[1], address(unescape(match[2]))
        return f'<a href="{escape(found)}">{words}</a>' if found else words

    text = escape(text.strip())
    text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", text)
    return re.sub(r"\[([^\]]+)\]\(([^)]*)\)", link, text)


def cells(line):
    """The cells of a table row. A bar inside `code` or written \\| does not separate cells."""
    inner = line.strip().removeprefix("|").removesuffix("|")
    return [cell.replace("\\|", "|").strip() for cell in re.split(r"(?<!\\)\|", inner)]


def is_rule(line):
    return re.fullmatch(r"\|[\s:|-]+\|", line.strip()) is not None and "-" in line


def table_row(tag, texts, address):
    return "<tr>" + "".join(f"<{tag}>{inline(text, address)}</{tag}>" for text in texts) + "</tr>"


def table(lines, address):
    """Converts a table to HTML. An empty head is left out."""
    rows = [cells(line) for line in lines if not is_rule(line)]
    has_head = len(lines) > 1 and is_rule(lines[1])
    html = ['<div class="scroll"><table>']
    if has_head:
        head = rows.pop(0)
        if any(head):
            html.append(table_row("th", head, address))
    html += [table_row("td", row, address) for row in rows]
    return "\n".join(html + ["</table></div>"])


def kind(line):
    """The kind of block to which `line` belongs."""
    if not line.strip() or re.fullmatch(r"<!--.*-->", line.strip()):
        return "blank"
    if line.startswith("|"):
        return "table"
    if re.match(r"[-*] ", line):
        return "item"
    if re.match(r"#+ ", line):
        return "heading"
    return "text"


def blocks(text):
    """The blocks in order, as (kind, lines)."""
    found, fenced = [], False
    for line in text.splitlines():
        if line.startswith("```"):
            fenced = not fenced
            found += [("code", [])] if fenced else [("blank", [])]
            continue
        this = "code" if fenced else kind(line)
        last = found[-1][0] if found else ""
        if this == "text" and last == "item":  # the next line continues a list item
            found[-1][1][-1] += " " + line.strip()
        elif this == last and this != "heading":
            found[-1][1].append(line)
        else:
            found.append((this, [line]))
    return [(this, lines) for this, lines in found if this != "blank"]


def render(this, lines, address):
    """Converts one block to HTML."""
    if this == "table":
        return table(lines, address)
    if this == "item":
        return "<ul>" + "".join(f"<li>{inline(line[2:], address)}</li>" for line in lines) + "</ul>"
    if this == "heading":
        return f"<h4>{inline(lines[0].lstrip('#'), address)}</h4>"
    if this == "code":
        return "<pre>" + escape("\n".join(lines)) + "</pre>"
    return f"<p>{inline(' '.join(lines), address)}</p>"


def take_row(lines, name, address):
    """Takes the rows whose first cell is `name` out of the lines of a table. Returns their text as HTML."""
    rows = [line for line in lines if cells(line)[0].lower() == name]
    lines[:] = [line for line in lines if line not in rows]
    return inline(" ".join(cells(rows[0])[1:]), address) if rows else ""


def read(text, fallback_title, address=no_address):
    """The parts of a README. It has `# Title`, a table with rows `Claim` and `Compared`, and free text."""
    found = blocks(text)
    title, claim, compared = fallback_title, "", ""
    if found and found[0][0] == "heading" and found[0][1][0].startswith("# "):
        title = found.pop(0)[1][0][2:].strip()
    first_table = next((lines for this, lines in found if this == "table"), None)
    if first_table:
        claim, compared = (take_row(first_table, name, address) for name in ("claim", "compared"))
    body = "\n".join(render(this, lines, address) for this, lines in found)
    return Readme(title, claim, compared, body)


def listed(text, heading, address=no_address):
    """The list items under `## heading` as HTML, empty without that heading."""
    items, inside = [], False
    for this, lines in blocks(text):
        if this == "heading":
            inside = lines[0].strip() == f"## {heading}"
        elif this == "item" and inside:
            items += [inline(line[2:], address) for line in lines]
    return items
