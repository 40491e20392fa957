#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null # nothing here asks a question

usage() {
    cat <<'HELP'
scripts/bench.sh [--runs N] [--no-install] [NAME ...]
scripts/bench.sh --compare REVISION [--pairs N] [--no-install] [NAME ...]

Builds the benchmarks of experiments/benchmarks (or those named), runs them one at a time and
writes one CSV. Installs missing packages (Debian, root). Do not use the machine meanwhile.

  without --compare   runs each benchmark N times and writes results/bench.csv: machine,
                      revision, and for each measured row median, spread, and the ratio to
                      the library that the same run compares it with. Keeps them in
                      results/bench_history.csv, and draws medians and ratios over all kept
                      runs and revisions as results/bench-BENCHMARK.svg
  --runs N            runs of each benchmark (default 3)
  --compare REVISION  builds REVISION in build/bench too, and runs both in interleaved pairs.
                      Writes results/bench_compare.csv and prints for each row the median of
                      the ratios of new to old time (or memory) and a verdict: slower or
                      faster by more than 3 %, or same
  --pairs N           pairs of runs (default 10)
  --no-install        installs nothing and checks that every program and library is there

All benchmarks together take about 20 minutes for one run, and 40 for one pair.
Exit 0; 1 if a benchmark failed or, with --compare, a row is slower; 2 if the command line
is wrong.
Example: scripts/bench.sh --compare HEAD~1 --pairs 10 slicing envelope
HELP
}

setup_options=()
arguments=()
for argument in "$@"; do
    case "$argument" in
        --help | -h) usage; exit 0 ;;
        --no-install) setup_options=(--no-install) ;;
        *) arguments+=("$argument") ;;
    esac
done

export PYTHONPATH=scripts
# Check the command line before installing anything.
/usr/bin/python3 -m benchmarking --check "${arguments[@]}"
scripts/setup.sh "${setup_options[@]}" build benchmarks figures
exec /usr/bin/python3 -m benchmarking "${arguments[@]}"
