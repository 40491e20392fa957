# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts the help texts into a completion for bash."""
import re
import shlex

HEAD = """# SPDX-License-Identifier: GPL-3.0-or-later
# Bash completion of endmill: commands, their options, the values of an option.
# Generated from the help texts of the program; do not edit.
_endmill()
{
    local current=${COMP_WORDS[COMP_CWORD]} command="" options="" commands="" values="" i
    for ((i = 1; i < COMP_CWORD; i++)); do
        case "$command ${COMP_WORDS[i]}" in
"""
MIDDLE = """        esac
    done
    case "$command" in
"""
VALUES = """    esac
    case "$command ${COMP_WORDS[COMP_CWORD - 1]}" in
"""
TAIL = """    esac
    if [[ -n $values ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$values" -- "$current")
    elif [[ $current == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    elif [[ -n $commands ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current")
    else
        compopt -o filenames
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
    fi
}
complete -F _endmill endmill
"""


def choices(value):
    """The words of a value such as `zigzag|one-way`. Empty for any other value."""
    words = value.split("|")
    return words if len(words) > 1 and all(re.fullmatch(r"-?[\w.-]+", w) for w in words) else []


def enter(command):
    """The case that recognises the word of a command."""
    parent, word = " ".join(command.words[:-1]), command.words[-1]
    return f"            {shlex.quote(f'{parent} {word}')}) command={shlex.quote(' '.join(command.words))} ;;"


def offer(help_):
    """The options and subcommands of a command."""
    options = " ".join(name for entry in help_.options for name in entry.names)
    return (f"        {shlex.quote(' '.join(help_.words))}) options={shlex.quote(options)}"
            f" commands={shlex.quote(' '.join(help_.commands))} ;;")


def value_cases(help_):
    """The values of options with fixed choices."""
    cases = []
    for entry in help_.options:
        words = choices(entry.value)
        if words:
            patterns = "|".join(shlex.quote(f"{' '.join(help_.words)} {name}") for name in entry.names)
            cases.append(f"        {patterns}) values={shlex.quote(' '.join(words))} ;;")
    return cases


def completion(helps):
    """The completion script."""
    return "".join([
        HEAD, "".join(enter(h) + "\n" for h in helps if h.words),
        MIDDLE, "".join(offer(h) + "\n" for h in helps),
        VALUES, "".join(case + "\n" for h in helps for case in value_cases(h)),
        TAIL,
    ])
