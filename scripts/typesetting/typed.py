# SPDX-License-Identifier: GPL-3.0-or-later
r"""Finds numbers that are typed in the LaTeX source and should come from a CSV file.

A digit is allowed only
  1. in a macro of typesetting/calls.py, which takes the number from a CSV or params.json;
  2. in a formula: a displayed one, or $...$ that contains a letter or a command and sets nothing equal to a
     number other than 0, 1 and 2;
  3. in a place of a paper: "section 3", "figures 13 to 15", "method 2", "no. 21", an equation number such as (4);
  4. in an argument that is not printed or is a name: \ref, \cite, \label, \texttt, lengths, column widths;
  5. in one of the phrases of paper/typed-numbers.txt, each with its reason.
"""
import re

from .calls import BOTH, CALL, FIGURES, MACROS, read_argument, without_comments

DISPLAYS = re.compile(r"\\begin\{(equation|align|gather|multline)(\*?)\}.*?\\end\{\1\2\}|\\\[.*?\\\]", re.DOTALL)
INLINE = re.compile(r"(?<!\\)\$([^$]*)\$")
SILENT = re.compile(r"\\(?:begin|end|ref|cite|label|eqref|input|include|includegraphics|texttt|path|url|vspace|hspace|"
                    r"setlength|usepackage|documentclass|cmidrule|bibliography|bibliographystyle|multicolumn|"
                    r"drawing|chapterinput|addcontentsline|providecommand|newcommand|renewcommand|DeclareRobustCommand|"
                    r"hypersetup|geometry|captionsetup|pdfinfo|pdftrailerid|microtypesetup)\*?"
                    r"(?:\s*(?:\([^)]*\)|\[[^\]]*\]|\{(?:[^{}]|\{[^{}]*\})*\}))+")
PLACE_WORDS = ("eq", "eqs", "equation", "section", "figure", "table", "method", "conclusion", "appendix", "chapter",
               "no", "nos", "item", "step", "line", "rule", "case", "reason", "axis", "stage", "paragraph", "caption")
NUMERAL = r"\(?(?:[A-Z]\.|[IVX]+\.)?\d+[a-z]?(?:\.\d+)*\)?(?:~?\([a-d]\))?"
PLACES = re.compile(rf"\b(?:{'|'.join(PLACE_WORDS)})s?\.?[~\s]+{NUMERAL}"
                    rf"(?:(?:,|\s+and|\s+to|\s+or|--)[~\s]*{NUMERAL})*", re.IGNORECASE)
EQUATION_NUMBER = re.compile(r"\(\d{1,2}\)")
SETS_A_NUMBER = re.compile(r"(?:=|\\approx|\\simeq|\\le|\\ge|\\leq|\\geq|<|>)\s*-?(?![012](?![\d.]))\d")
POWER = re.compile(r"\$\^(?:[23]|\{-?[12]\}|\\circ)\$")  # of a unit
LENGTH = re.compile(r"\d*\.?\d+\s*(?:\\(?:textwidth|linewidth|baselineskip)|pt|ex|em)\b")


def blank(match):
    """As many blanks as the match is long, with its line ends."""
    return re.sub(r"[^\n]", " ", match.group())


def without_calls(text):
    """The text with the macros of CSV cells blanked."""
    pieces, last = [], 0
    for match in CALL.finditer(text):
        if match.start() < last:
            continue
        _, end = read_argument(text, match.end(), "[", "]")
        for _ in range({BOTH: 3, FIGURES: 1, **MACROS}[match.group(1)]):
            _, end = read_argument(text, end, "{", "}")
        pieces += [text[last:match.start()], re.sub(r"[^\n]", " ", text[match.start():end])]
        last = end
    return "".join(pieces) + text[last:]


def formula(match):
    """Blanks an inline formula, unless it is a number or sets something equal to one."""
    inside = match.group(1)
    is_formula = re.search(r"[A-Za-z\\]", re.sub(r"\\[,;: ]|\\cdot|\\times", "", inside))
    return blank(match) if is_formula and not SETS_A_NUMBER.search(inside) else match.group()


def typed_numbers(text, allowed=()):
    """(line, words around) of each typed number in the LaTeX `text`. `allowed` are phrases that may stand."""
    text = without_calls(without_comments(text))
    for pattern in (DISPLAYS, SILENT, POWER):
        text = pattern.sub(blank, text)
    text = INLINE.sub(formula, text)
    for phrase in sorted(allowed, key=len, reverse=True):
        text = re.sub(rf"(?<![\w.]){re.escape(phrase)}(?![\w])".replace(r"\ ", r"\s+"), blank, text)
    for pattern in (LENGTH, PLACES, EQUATION_NUMBER):
        text = pattern.sub(blank, text)
    return [(text.count("\n", 0, match.start()) + 1,
             " ".join(text[max(0, match.start() - 30):match.end() + 30].split()))
            for match in re.finditer(r"\d[\d.,]*", text)]


def read_allowed(path):
    """The phrases of paper/typed-numbers.txt: lines `phrase | reason`."""
    lines = path.read_text(encoding="utf-8").splitlines()
    return [line.split("|")[0].strip() for line in lines if line.strip() and not line.startswith("#")]
