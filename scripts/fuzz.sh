#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null

usage() {
    cat <<'HELP'
scripts/fuzz.sh [SECONDS] [--help]

Builds the fuzzers of the readers into build/fuzz (clang, libFuzzer, address and
undefined-behaviour sanitizers) and runs each for SECONDS (10), beginning with the
files in tests/fuzz/corpus and what earlier runs found of interest.

Needs the Debian packages clang-14 and libclang-rt-14-dev. Exit 1 on a finding; its
input is then in build/fuzz/findings.
HELP
}

seconds=10
case "${1:-}" in
    '') ;;
    --help | -h) usage; exit 0 ;;
    *[!0-9]*) echo "fuzz.sh: unknown argument $1, see --help" >&2; exit 2 ;;
    *) seconds=$1 ;;
esac
if ! command -v clang++-14 >/dev/null; then
    echo "fuzz.sh: needs clang++-14: apt-get install clang-14 libclang-rt-14-dev" >&2
    exit 2
fi

folder=build/fuzz
sanitizers=address,undefined
cmake -S . -B "$folder" -G Ninja -D CMAKE_BUILD_TYPE=Fuzz -D CMAKE_CXX_COMPILER=clang++-14 \
    -D CMAKE_CXX_FLAGS_FUZZ="-O1 -g1 -fno-omit-frame-pointer -fno-sanitize-recover=all -fsanitize=fuzzer-no-link,$sanitizers" \
    -D ENDMILL_BUILD_FUZZERS=ON -D ENDMILL_BUILD_PROGRAM=OFF -D ENDMILL_BUILD_TESTS=OFF \
    -D ENDMILL_BUILD_EXPERIMENTS=OFF
cmake --build "$folder"

findings=()
mkdir -p "$folder/findings"
for seeds in tests/fuzz/corpus/*; do
    name=$(basename "$seeds")
    log="$folder/$name.log"
    mkdir -p "$folder/corpus/$name"
    if "$folder/tests/fuzz/endmill_${name}_fuzz" -max_total_time="$seconds" -timeout=10 \
        -rss_limit_mb=1024 -malloc_limit_mb=300 -max_len=4096 -print_final_stats=1 \
        -artifact_prefix="$folder/findings/$name-" "$folder/corpus/$name" "$seeds" >"$log" 2>&1; then
        echo "$name: $(sed -n 's/.*number_of_executed_units: *//p' "$log") inputs, no finding"
    else
        tail -n 40 "$log"
        findings+=("$name")
    fi
done
if [[ ${#findings[@]} -gt 0 ]]; then
    echo "fuzz.sh: findings in ${findings[*]}: see $folder/findings" >&2
    exit 1
fi
