#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null # no tool that runs here asks a question

usage() {
    cat <<'HELP'
scripts/reproduce.sh [--quick | --full] [--no-install] [PAPER | PAPER/ITEM ...]
scripts/reproduce.sh --accept PAPER/ITEM ...
scripts/reproduce.sh --help

Installs missing packages (Debian, root), builds the experiments in build/release and runs
them, paper by paper. Prints each published number beside the computed one, compares with
expected.csv, draws the figures and writes a report. Builds only the drivers that it runs.

  results/PAPER/ITEM/    CSV, figures as SVG, run.json (revision, time, machine), run.log
  results/report.html    each paper in short, then all experiments; opens offline
  results/verdicts.html  every published number and claim by verdict
  results/claims.html    every claim of the papers with its place and verdict

  --quick        leaves out the benchmarks and every study of more than a minute, whose
                 params.json has "long": true (default)
  --full         runs everything; on two cores that takes about 30 minutes
  PAPER          only this folder of experiments/
  PAPER/ITEM     only this experiment, however long it takes
  --no-install   installs nothing and checks that every program and library is there
  --accept       makes results/PAPER/ITEM/result.csv the new expected.csv of that
                 experiment. Examine the result and the reason of its change first.

Exit 0; 1 if an experiment crashed or differs from its expected.csv (a difference from a
published number is no failure); 2 if the command line is wrong.
Example: scripts/reproduce.sh economic-cl-data/table-1
HELP
}

groups=(build figures)
setup_options=()
arguments=()
for argument in "$@"; do
    case "$argument" in
        --help | -h) usage; exit 0 ;;
        --no-install) setup_options=(--no-install); continue ;;
        --full) groups+=(benchmarks python page) ;;
        --accept | --quick) ;;
        -*) echo "reproduce.sh: unknown option $argument, see --help" >&2; exit 2 ;;
        benchmarks | benchmarks/* | experiments/benchmarks*) groups+=(benchmarks python page) ;;
    esac
    arguments+=("$argument")
done

scripts/setup.sh "${setup_options[@]}" "${groups[@]}"
PYTHONPATH=scripts exec /usr/bin/python3 -m reproduction "${arguments[@]}"
