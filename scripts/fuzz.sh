#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null

usage() {
    cat <<'HELP'
scripts/fuzz.sh [SECONDS] [--help]

Builds the fuzzers of the readers into build/asan (clang, libFuzzer, address and
undefined-behaviour sanitizers) and runs each for SECONDS (10), as many at a time as
there are cores. Each begins with the files in tests/fuzz/corpus, with what earlier
runs found of interest, and with their findings.

Installs missing packages (Debian, root). Safe to run again: only what changed is
rebuilt. Exit 1 on a finding; its input is then in build/fuzz/findings, and fails
every run until it is put right.
HELP
}

seconds=10
case "${1:-}" in
    '') ;;
    --help | -h) usage; exit 0 ;;
    *[!0-9]*) echo "fuzz.sh: unknown argument $1, see --help" >&2; exit 2 ;;
    *) seconds=$1 ;;
esac
scripts/setup.sh

folder=build/fuzz
cmake --preset asan
cmake --build --preset asan --target endmill_fuzzers

# Runs one fuzzer; its status tells whether it had no finding.
fuzz() {
    local name=$1 log="$folder/$1.log"
    local findings="$folder/findings/$name" interesting="$folder/corpus/$name"
    mkdir -p "$findings" "$interesting"
    if ! "build/asan/tests/fuzz/endmill_${name}_fuzz" -max_total_time="$seconds" -timeout=10 \
        -rss_limit_mb=1024 -malloc_limit_mb=300 -max_len=4096 -print_final_stats=1 \
        -artifact_prefix="$findings/" "$interesting" "tests/fuzz/corpus/$name" "$findings" \
        >"$log" 2>&1; then
        printf '%s\n%s: a finding, see %s\n' "$(tail -n 40 "$log")" "$name" "$findings"
        return 1
    fi
    echo "$name: $(inputs "$log") inputs, no finding"
}
inputs() { cat "$@" | awk '/number_of_executed_units/ { sum += $2 } END { print sum + 0 }'; }
export -f fuzz inputs
export folder seconds

mapfile -t names < <(ls tests/fuzz/corpus)
verdict="no finding"
printf '%s\n' "${names[@]}" | xargs -P "$(nproc)" -I NAME bash -c 'fuzz NAME' ||
    verdict="with findings"
echo "fuzz.sh: ${#names[@]} readers, $(inputs "$folder"/*.log) inputs, $verdict"
[[ $verdict == "no finding" ]]
