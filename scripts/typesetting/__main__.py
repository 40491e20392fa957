# SPDX-License-Identifier: GPL-3.0-or-later
"""The step of scripts/paper.sh before LaTeX: writes the numbers, the table of claims and the figures."""
import argparse
import json
import sys
from pathlib import Path

from reproduction.fault import Fault

from .bibliography import latin_bibliography
from .calls import find_calls
from .cells import Cells
from .claims_table import claims_table, read_claims

ROOT = Path(__file__).resolve().parents[2]


def sources(root):
    """The LaTeX files with the text of the paper, in the order of their names."""
    return sorted((root / "paper/chapters").glob("*.tex"))


def resolve_all(cells, calls):
    """The LaTeX text of each call by its key. Raises Fault with all faults, one in each line."""
    texts, faults = {}, []
    for call in calls:
        try:
            texts[call.key] = cells.resolve(call)
        except Fault as fault:
            faults.append(str(fault))
    if faults:
        raise Fault("\n".join(faults))
    return texts


def definitions(texts):
    """The LaTeX text that defines the cells."""
    return "".join(rf"\definecell{{\detokenize{{{key}}}}}{{{text}}}" + "\n" for key, text in texts.items())


def origin(results):
    """What the results were made with: revision and machine of all run.json, in LaTeX."""
    runs = [json.loads(path.read_text(encoding="utf-8")) for path in sorted(results.glob("*/*/run.json"))]
    revisions = sorted({run["revision"] for run in runs})
    machines = sorted({f"{run['machine']['cpu']}, {run['machine']['cores']} cores" for run in runs})
    return "\n".join([rf"\newcommand{{\revisions}}{{{', '.join(revisions) or 'unknown'}}}",
                      rf"\newcommand{{\machines}}{{{'; '.join(machines) or 'unknown'}}}", ""]).replace("_", r"\_")


def draw_figures(results, claims, folder):
    """Draws all figures into `folder`."""
    from . import figures_economic, figures_interference, figures_milling, figures_setup, style

    data = style.Data(results)
    data.claims = claims
    for module in (figures_economic, figures_interference, figures_setup, figures_milling):
        for name, draw in module.FIGURES.items():
            with style.plt.rc_context(style.STYLE):
                style.save(draw(data), folder / f"{name}.pdf")


def list_cells(calls, texts):
    """The calls by file with their texts, for a reader who compares the paper with the CSV files."""
    return "".join(f"{call.place.rsplit('/', 1)[1]} \\{call.name} {' | '.join(call.plain)} = {texts[call.key]}\n"
                   for call in calls)


def prepare(root, results, claims_path, build):
    """Writes everything that LaTeX reads into `build`. Raises Fault if a cell or a result is missing."""
    if not any(results.glob("*/*/result.csv")):
        raise Fault(f"there are no results in {results}; scripts/reproduce.sh --full makes them")
    claims = read_claims(claims_path)
    calls = [call for path in sources(root) for call in find_calls(path)]
    texts = resolve_all(Cells(root, results, claims), calls)
    (build / "figures").mkdir(parents=True, exist_ok=True)
    (build / "cells.tex").write_text(definitions(texts) + origin(results), encoding="utf-8")
    (build / "cells.txt").write_text(list_cells(calls, texts), encoding="utf-8")
    (build / "claims-table.tex").write_text(claims_table(claims), encoding="utf-8")
    bibliography = (root / "paper/references.bib").read_text(encoding="utf-8")
    (build / "references.bib").write_text(latin_bibliography(bibliography), encoding="utf-8")
    draw_figures(results, claims, build / "figures")
    return len(calls)


def main(arguments):
    parser = argparse.ArgumentParser(prog="paper.sh")
    parser.add_argument("--results", type=Path, default=ROOT / "results")
    parser.add_argument("--claims", type=Path, default=ROOT / "experiments/claims.csv")
    parser.add_argument("--build", type=Path, default=ROOT / "build/paper")
    options = parser.parse_args(arguments)
    try:
        count = prepare(ROOT, options.results, options.claims, options.build)
    except Fault as fault:
        print(f"paper.sh: {fault}", file=sys.stderr)
        return 1
    print(f"paper.sh: {count} numbers, texts and verdicts from CSV files")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
