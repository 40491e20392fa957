# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts the help texts into a manual page (man macros of troff)."""


def escaped(text):
    """Escapes `text` for troff, where a leading dot or quote would be a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in text.split("\n"))


def sentence(text):
    """A summary with a capital letter, to begin a paragraph."""
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


def entries(section):
    return "\n".join(f".TP\n.B {escaped(entry.term)}\n{escaped(entry.text)}" for entry in section)


def sections(help_, known):
    """The sections of a help text, without those that an earlier command has shown."""
    text = []
    for heading, found in help_.sections:
        new = [e for e in found if (heading, e.term, e.text) not in known and e.names[:1] != ["-h"]]
        if heading.startswith("Options of every"):
            known.update((heading, e.term, e.text) for e in found)
            continue
        if new and heading != "Subcommands":
            text.append(entries(new))
    return "\n".join(text)


def notes(help_):
    """Notes and examples with their line breaks."""
    return f".PP\n.nf\n{escaped(help_.notes)}\n.fi" if help_.notes else ""


def common_options(helps):
    """The options of every command, from the first help that has them."""
    for help_ in helps:
        for heading, found in help_.sections:
            if heading.startswith("Options of every"):
                return entries(found)
    return ""


def page(helps, version):
    """The page: the program, its commands, the options of every command."""
    program, *commands = helps
    known = set()
    parts = [
        f'.TH ENDMILL 1 "" "endmill {version}" "User Commands"',
        f".SH NAME\nendmill \\- {escaped(program.summary.rstrip('.'))}",
        ".SH SYNOPSIS\n" + "\n.br\n".join(f".B {escaped(h.usage)}" for h in commands or helps),
        f".SH DESCRIPTION\n{escaped(sentence(program.summary))}",
        sections(program, known), notes(program), ".SH COMMANDS",
    ]
    for command in commands:
        parts += [f".SS endmill {escaped(' '.join(command.words))}",
                  escaped(sentence(command.summary)), sections(command, known), notes(command)]
    if common_options(commands):
        parts += [".SH OPTIONS OF EVERY COMMAND", common_options(commands)]
    return "\n".join(part for part in parts if part) + "\n"
