#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null # LaTeX would ask questions

usage() {
    cat <<'HELP'
scripts/paper.sh [--no-install] [--results FOLDER] [--claims FILE]

Builds the paper "Four papers on sculptured-surface machining, reproduced" with LaTeX as
build/paper/endmill.pdf. Every number, table, verdict and figure comes from the results of
scripts/reproduce.sh --full, from experiments/*/*/published.csv and from claims.csv. The
same results give the same bytes. Installs missing packages (Debian, root).

  --results FOLDER   results of the experiments (default results)
  --claims FILE      table of all claims (default experiments/claims.csv)
  --no-install       installs nothing and checks that every program is there

build/paper/cells.txt lists every cell that the paper uses, with file, line and text.

Exit 0; 1 if a program, a result or a cell is missing or LaTeX fails; 2 if the command line
is wrong.
Example: scripts/paper.sh
HELP
}

setup_options=()
arguments=()
while [[ $# -gt 0 ]]; do
    case "$1" in
        --help | -h) usage; exit 0 ;;
        --no-install) setup_options=(--no-install) ;;
        --results | --claims)
            [[ $# -gt 1 ]] || { echo "paper.sh: $1 needs a value, see --help" >&2; exit 2; }
            arguments+=("$1" "$2"); shift ;;
        *) echo "paper.sh: unknown argument $1, see --help" >&2; exit 2 ;;
    esac
    shift
done

scripts/setup.sh "${setup_options[@]}" paper
PYTHONPATH=scripts /usr/bin/python3 -m typesetting "${arguments[@]}"

# A fixed date and no absolute path in the PDF, so that two builds give the same bytes.
export SOURCE_DATE_EPOCH=946684800 FORCE_SOURCE_DATE=1
export TEXINPUTS="$PWD/build/paper:$PWD/paper:" BIBINPUTS="$PWD/build/paper:"
cd build/paper
status=0
latexmk -norc -pdf -interaction=nonstopmode -halt-on-error ../../paper/endmill.tex >latexmk.txt 2>&1 || status=$?
if [[ $status -ne 0 ]]; then
    grep -A3 -E '^!|Error|rror:' latexmk.txt | head -40 >&2 || tail -20 latexmk.txt >&2
    echo "paper.sh: LaTeX failed, see build/paper/endmill.log" >&2
    exit 1
fi
if grep -qE 'undefined (references|citations)|Citation .* undefined|Reference .* undefined' endmill.log; then
    grep -E 'undefined' endmill.log >&2
    echo "paper.sh: undefined references" >&2
    exit 1
fi
echo "paper.sh: build/paper/endmill.pdf"
