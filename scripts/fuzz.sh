#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null

usage() {
    cat <<'HELP'
scripts/fuzz.sh [--no-install] [SECONDS]

Builds the fuzzers of the readers into build/asan (clang, libFuzzer, address and
undefined-behaviour sanitizers) and runs each for SECONDS (default 10), one fuzzer per core
at a time. A fuzzer starts from the files in tests/fuzz/corpus, and from the interesting
inputs and findings of earlier runs.

  --no-install   installs no packages and checks that every program and library is there

Rebuilds only changed files. Exit 0 without a finding; 1 with a finding, whose input is in
build/fuzz/findings and is tried again by every later run; 2 if the command line is wrong.
Example: scripts/fuzz.sh 60
HELP
}

seconds=10
setup_options=()
for argument in "$@"; do
    case "$argument" in
        --help | -h) usage; exit 0 ;;
        --no-install) setup_options=(--no-install) ;;
        '' | *[!0-9]*) echo "fuzz.sh: unknown argument '$argument', see --help" >&2; exit 2 ;;
        *) seconds=$argument ;;
    esac
done
scripts/setup.sh "${setup_options[@]}" build sanitizers

folder=build/fuzz
# The preset names the clang of Debian 12. Other systems use the default clang.
clang=()
command -v clang++-14 >/dev/null || clang=(-D CMAKE_CXX_COMPILER=clang++)
cmake --preset asan "${clang[@]}"
cmake --build --preset asan --target endmill_fuzzers

# Runs one fuzzer. Fails if the fuzzer has a finding.
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
