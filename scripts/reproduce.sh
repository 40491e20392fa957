#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null # nothing here asks

usage() {
    cat <<'HELP'
scripts/reproduce.sh [PAPER | PAPER/ITEM ...]
scripts/reproduce.sh --accept PAPER/ITEM ...
scripts/reproduce.sh --help

Installs missing packages (Debian, root), builds the preset release, runs every
experiment (or the ones named), prints the published numbers beside the computed
ones, compares with the earlier result, draws the figures.

  results/PAPER/ITEM/    CSV, figures as SVG, run.json (revision, time, machine), run.log
  results/report.html    everything on one page, opens offline

  --accept   makes results/PAPER/ITEM/result.csv the new expected.csv of that
             experiment. Look at the result and know why it changed first: from
             then on this is what the regression holds every run to.

Exit 0; 1 if an experiment crashed or departs from its expected.csv (never because
a published number differs); 2 if the command line is wrong.
Example: scripts/reproduce.sh economic-cl-data/table-1
HELP
}

for argument in "$@"; do
    case "$argument" in
        --help | -h) usage; exit 0 ;;
        --accept) ;;
        -*) echo "reproduce.sh: unknown option $argument, see --help" >&2; exit 2 ;;
    esac
done

scripts/setup.sh
PYTHONPATH=scripts exec /usr/bin/python3 -m reproduction "$@"
