# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/bench.sh, whose --help describes it."""
import sys
from dataclasses import dataclass, field
from pathlib import Path

from reproduction import machine
from reproduction.fault import Fault

from .history import draw, keep
from .measure import COMPARE_HEAD, RUN_HEAD, busy, compare, measure, write_csv
from .trees import Tree, build, checked_out, compiler_options

ROOT = Path(__file__).resolve().parents[2]


class UsageError(Exception):
    """An error of the command line."""


@dataclass
class Arguments:
    names: list = field(default_factory=list)
    compare: str = ""
    runs: int = 3
    pairs: int = 10


def whole_number(option, text):
    if not text.isdigit() or int(text) == 0:
        raise UsageError(f"{option} needs a whole number above 0, not '{text}'")
    return int(text)


def read(words, known):
    """Parses `words`; `known` are the names of the benchmarks."""
    found, rest, given = Arguments(), list(words), set()
    while rest:
        word = rest.pop(0)
        if word in ("--compare", "--runs", "--pairs"):
            if not rest:
                raise UsageError(f"{word} needs a value")
            value = rest.pop(0)
            setattr(found, word[2:], value if word == "--compare" else whole_number(word, value))
            given.add(word)
        elif word.startswith("-"):
            raise UsageError(f"unknown option {word}")
        else:
            found.names.append(word.removeprefix("experiments/").removeprefix("benchmarks/").rstrip("/"))
    unknown = [name for name in found.names if name not in known]
    if unknown:
        raise UsageError(f"no benchmark {', '.join(unknown)}; there are: {', '.join(known)}")
    if "--pairs" in given and not found.compare:
        raise UsageError("--pairs needs --compare")
    if "--runs" in given and found.compare:
        raise UsageError("--runs does not go with --compare; use --pairs")
    found.names = found.names or list(known)
    return found


def say(text):
    print(text, flush=True)


def run_alone(tree, arguments):
    build(tree, arguments.names)
    rows = measure(tree, arguments.names, arguments.runs, say)
    write_csv(ROOT / "results/bench.csv", RUN_HEAD, rows)
    say("written: results/bench.csv")
    drawn = draw(ROOT / "results", keep(ROOT / "results/bench_history.csv", rows))
    say(f"kept in results/bench_history.csv; drawn over all kept runs: {', '.join(drawn) or 'nothing yet'}")
    return 0


def run_compared(tree, arguments):
    old = checked_out(ROOT, arguments.compare)
    names = [name for name in arguments.names if name in old.names()]
    for name in sorted(set(arguments.names) - set(names)):
        say(f"{name}: not in {old.revision}, left out")
    if not names:
        raise Fault(f"{old.revision} has none of these benchmarks")
    build(tree, names)
    build(old, names, ["-DENDMILL_BUILD_TESTS=OFF", *compiler_options(ROOT)])
    rows = compare(old, tree, names, arguments.pairs, say)
    write_csv(ROOT / "results/bench_compare.csv", COMPARE_HEAD, rows)
    slower = [row for row in rows if row[-1] == "slower"]
    say(f"{len(rows)} rows, {len(slower)} slower; written: results/bench_compare.csv")
    for row in slower:
        head = dict(zip(COMPARE_HEAD, row))
        say(f"  {head['benchmark']}: {head['row']}: {head['ratio']:.3f} times the time or memory")
    return 1 if slower else 0


def main(words):
    tree = Tree(ROOT, machine.revision(ROOT))
    checking = "--check" in words
    try:
        arguments = read([word for word in words if word != "--check"], tree.names())
        if checking:
            return 0
        if busy():
            say(busy())
        return run_compared(tree, arguments) if arguments.compare else run_alone(tree, arguments)
    except UsageError as error:
        say(f"bench.sh: {error}; see --help")
        return 2
    except Fault as fault:
        say(f"error: {fault}")
        return 1
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
