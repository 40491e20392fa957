# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers and texts of CSV cells as LaTeX."""
import math
import re

from reproduction.fault import Fault

FORM = re.compile(r"(s|e|p|)(\d)")
# A straight quotation mark behind a letter is an apostrophe.
QUOTATION = re.compile(r"""(?<!\w)(?:'([^']+)'(?!\w)|"([^"]+)")""")
# What pdfTeX cannot read, and what LaTeX would take for a command.
LETTERS = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#",
    "_": r"\_", "~": r"\textasciitilde{}", "^": r"\^{}", "<": r"\ensuremath{<}", ">": r"\ensuremath{>}",
    "|": r"\ensuremath{|}", "−": r"\ensuremath{-}", "≤": r"\ensuremath{\le}", "≥": r"\ensuremath{\ge}",
    "→": r"\ensuremath{\to}", "≈": r"\ensuremath{\approx}", "√": r"\ensuremath{\surd}",
    "∞": r"\ensuremath{\infty}", "∩": r"\ensuremath{\cap}", "·": r"\ensuremath{\cdot}", "×": r"\ensuremath{\times}",
    "±": r"\ensuremath{\pm}", "°": r"\ensuremath{^\circ}", "²": r"\ensuremath{^2}", "³": r"\ensuremath{^3}",
    "′": r"\ensuremath{'}", "–": "--", "—": "---", "…": r"\ldots{}", "“": "``", "”": "''", "’": "'", "‘": "`",
    "∝": r"\ensuremath{\propto}", "≠": r"\ensuremath{\ne}", "∈": r"\ensuremath{\in}", "∂": r"\ensuremath{\partial}",
    "α": r"\ensuremath{\alpha}", "β": r"\ensuremath{\beta}", "γ": r"\ensuremath{\gamma}",
    "δ": r"\ensuremath{\delta}", "ε": r"\ensuremath{\varepsilon}", "ζ": r"\ensuremath{\zeta}",
    "θ": r"\ensuremath{\theta}", "κ": r"\ensuremath{\kappa}", "λ": r"\ensuremath{\lambda}",
    "μ": r"\ensuremath{\mu}", "µ": r"\ensuremath{\mu}", "ξ": r"\ensuremath{\xi}", "π": r"\ensuremath{\pi}",
    "ρ": r"\ensuremath{\rho}", "σ": r"\ensuremath{\sigma}", "τ": r"\ensuremath{\tau}",
    "φ": r"\ensuremath{\varphi}", "ϕ": r"\ensuremath{\phi}", "χ": r"\ensuremath{\chi}",
    "ψ": r"\ensuremath{\psi}", "ω": r"\ensuremath{\omega}", "Δ": r"\ensuremath{\Delta}",
    "Θ": r"\ensuremath{\Theta}", "Φ": r"\ensuremath{\Phi}", "Σ": r"\ensuremath{\Sigma}", "Ω": r"\ensuremath{\Omega}",
    "∫": r"\ensuremath{\int}", "∑": r"\ensuremath{\sum}", "∠": r"\ensuremath{\angle}", "⊥": r"\ensuremath{\perp}",
}


def escape(text):
    """`text` for LaTeX. Raises Fault for a letter that the fonts of the paper lack."""
    escaped = []
    for letter in QUOTATION.sub(lambda match: f"“{match[1] or match[2]}”", text):
        if letter in LETTERS:
            escaped.append(LETTERS[letter])
        elif ord(letter) < 0x250:
            escaped.append(letter)
        else:
            raise Fault(f"no LaTeX for {letter!r} in {text!r}")
    return "".join(escaped)


def grouped(text):
    """The digits of a decimal number, with a thin space before each three digits of five or more."""
    sign, digits = (r"\ensuremath{-}", text[1:]) if text[0] in "-−" else ("", text.lstrip("+"))
    whole, point, fraction = digits.partition(".")
    if len(whole) >= 5:
        head = len(whole) % 3
        parts = [whole[:head]] * (head > 0) + [whole[i:i + 3] for i in range(head, len(whole), 3)]
        whole = r"\,".join(parts)
    return f"{sign}{whole}{point}{fraction}"


def fixed(value, decimals):
    """`value` with so many decimals. Never a negative zero."""
    text = f"{value:.{decimals}f}"
    return grouped(text if float(text) != 0 else text.lstrip("-"))


def significant(value, digits):
    """`value` with so many significant digits, never in scientific notation."""
    if value == 0:
        return "0"
    decimals = digits - 1 - math.floor(math.log10(abs(value)))
    rounded = round(value, decimals)
    if rounded != 0:  # 0.0996 to one digit is 0.1 and has a decimal less
        decimals = digits - 1 - math.floor(math.log10(abs(rounded)))
    return fixed(rounded, max(decimals, 0))


def formatted(value, form):
    """`value` in a form: '2' decimals, 's3' significant digits, 'e1' scientific, 'p0' in percent.

    Raises Fault if the form is none of these.
    """
    match = FORM.fullmatch(form)
    if not match:
        raise Fault(f"format {form!r}, expected a digit, or s, e or p and a digit")
    kind, digits = match.group(1), int(match.group(2))
    if kind == "s":
        return significant(value, digits)
    if kind == "e":
        mantissa, exponent = f"{value:.{digits}e}".split("e")
        return rf"\ensuremath{{{mantissa}\cdot10^{{{int(exponent)}}}}}"
    return fixed(100 * value if kind == "p" else value, digits)
