# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the help texts of the program, `endmill COMMAND --help`, and parses their options.

The layout is that of CLI11: a summary, `Usage:`, then sections whose heading ends with a
colon in the first column. Entries of a section are indented by two spaces; their
descriptions begin in a fixed column, on the same line or on the next one.
"""
import re
import subprocess
from dataclasses import dataclass, field

ENTRY = re.compile(r"  (\S.*)")
CONTINUED = re.compile(r"\s{10,}(\S.*)")
OPTION_NAME = re.compile(r"--?[A-Za-z][\w-]*")
ENTRY_SECTIONS = re.compile(r"(Positionals|Options.*|Subcommands|\w[\w ,-]*[Oo]ptions.*):$")


@dataclass
class Entry:
    """An option, an operand or a command with its description."""

    term: str
    text: str

    @property
    def names(self):
        """The spellings of an option, none for an operand."""
        head = self.term.split(" ")[0] if self.term.startswith("-") else ""
        return OPTION_NAME.findall(head)

    @property
    def value(self):
        """The value of the option, such as `mm|inch` or `FILE`. Empty for a switch."""
        rest = self.term.split(" ")[1:] if self.names else []
        return " ".join(word for word in rest if word != "(required)")


@dataclass
class Help:
    """The parsed help text of one command."""

    words: list  # ["eval", "path-interval"], empty for the program
    summary: str
    usage: str
    sections: list = field(default_factory=list)  # (heading, [Entry])
    notes: str = ""  # the text below the sections

    @property
    def options(self):
        return [entry for _, entries in self.sections for entry in entries if entry.names]

    @property
    def commands(self):
        return [entry.term for heading, entries in self.sections if heading == "Subcommands"
                for entry in entries]


def split_entry(line):
    """Term and description of the first line of an entry. The description may be empty.

    Two spaces separate them. A long term may leave room for only one space. Then the term is the
    name of an option with its value, which is in capitals or a choice.
    """
    term, _, text = line.strip().partition("  ")
    crowded = re.match(r"(-\S+ (?:[A-Z]\S*|\S+\|\S+)(?: \(required\))?) ([a-z].*)$", term)
    return (crowded[1], crowded[2]) if crowded else (term, text.strip())


def parse(words, text):
    """Parses the output of --help for the command `words`."""
    lines = text.rstrip().splitlines()
    usage = next((line for line in lines if line.startswith("Usage:")), "Usage: endmill")
    summary = " ".join(lines[:lines.index(usage)]).strip() if usage in lines else ""
    found = Help(list(words), summary, usage.removeprefix("Usage:").strip())
    notes, entries = [], None
    for line in lines[lines.index(usage) + 1:] if usage in lines else []:
        heading = ENTRY_SECTIONS.match(line)
        if heading:
            entries = []
            found.sections.append((heading[1], entries))
        elif entries and CONTINUED.match(line):
            entries[-1].text = f"{entries[-1].text} {line.strip()}".strip()
        elif entries is not None and ENTRY.match(line):
            entries.append(Entry(*split_entry(line)))
        elif line.strip() or notes:
            entries = None if line.strip() else entries
            notes.append(line)
    found.notes = "\n".join(notes).strip("\n")
    return found


def ask(program, words):
    """The output of `program words... --help`."""
    done = subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=False,
                          stdin=subprocess.DEVNULL)
    if done.returncode != 0:
        raise RuntimeError(f"{program} {' '.join(words)} --help failed: {done.stderr.strip()}")
    return done.stdout


def all_helps(program, words=()):
    """The help texts of the program and its commands, depth first."""
    own = parse(words, ask(program, words))
    helps = [own]
    for command in own.commands:
        helps += all_helps(program, (*words, command))
    return helps
