# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts the README of an experiment to HTML. It supports a small, safe part of Markdown.

This part has headings, paragraphs, lists, tables, fenced blocks, `code` and **bold**. A link becomes
its text. A line with a comment, such as the licence, is left out. Everything else is plain text. Every text is escaped before markup is added.
"""
import re
from dataclasses import dataclass
from html import escape


@dataclass(frozen=True)
class Readme:
    title: str
    claim: str  # HTML, empty without a Claim in the first table
    body: str  # HTML of all the rest


def inline(text):
    """Converts one piece of text to HTML."""
    text = escape(text.strip())
    text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", text)
    return re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", text)


def cells(line):
    """The cells of a table row. A bar inside `code` or written \\| does not separate cells."""
    inner = line.strip().removeprefix("|").removesuffix("|")
    return [cell.replace("\\|", "|").strip() for cell in re.split(r"(?<!\\)\|", inner)]


def is_rule(line):
    return re.fullmatch(r"\|[\s:|-]+\|", line.strip()) is not None and "-" in line


def table_row(tag, texts):
    return "<tr>" + "".join(f"<{tag}>{inline(text)}</{tag}>" for text in texts) + "</tr>"


def table(lines):
    """Converts a table to HTML. An empty head is left out."""
    rows = [cells(line) for line in lines if not is_rule(line)]
    has_head = len(lines) > 1 and is_rule(lines[1])
    html = ['<div class="scroll"><table>']
    if has_head:
        head = rows.pop(0)
        if any(head):
            html.append(table_row("th", head))
    html += [table_row("td", row) for row in rows]
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


def render(this, lines):
    """Converts one block to HTML."""
    if this == "table":
        return table(lines)
    if this == "item":
        return "<ul>" + "".join(f"<li>{inline(line[2:])}</li>" for line in lines) + "</ul>"
    if this == "heading":
        return f"<h4>{inline(lines[0].lstrip('#'))}</h4>"
    if this == "code":
        return "<pre>" + escape("\n".join(lines)) + "</pre>"
    return f"<p>{inline(' '.join(lines))}</p>"


def read(text, fallback_title):
    """Title, claim and body of a README. It has `# Title`, a table with a row `Claim`, and free text."""
    found = blocks(text)
    title, claim = fallback_title, ""
    if found and found[0][0] == "heading" and found[0][1][0].startswith("# "):
        title = found.pop(0)[1][0][2:].strip()
    for i, (this, lines) in enumerate(found):
        if this == "table":
            stated = [line for line in lines if cells(line)[0].lower() == "claim"]
            claim = inline(" ".join(cells(stated[0])[1:])) if stated else ""
            found[i] = (this, [line for line in lines if line not in stated])
            break
    return Readme(title, claim, "\n".join(render(this, lines) for this, lines in found))
