#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null # nothing here asks, and a closed standard input would confuse some tools

usage() {
    cat <<'HELP'
scripts/test.sh [--all] [--help]

Installs missing packages (Debian, root), builds the preset release (g++) and runs all
tests, builds the program and the fuzzers by the preset asan (clang, address and
undefined-behaviour sanitizers), runs the tests of the program and fuzzes each reader
for 5 s (scripts/fuzz.sh), then clang-tidy on the files that changed since the merge base
with origin/main (on main itself: since the commit before).

  --all    all tests under sanitizers too, fuzzes for 60 s each, compiles every installed
           header alone, and clang-tidy on every file: about an hour on two cores

Build folders: build/release, build/asan, build/fuzz. Safe to run again: only what
changed is rebuilt. Exit 0 if everything passed, 1 otherwise.
HELP
}

all=false
fuzz_seconds=5
tidy_options=()
asan_targets=(endmill endmill_fuzzers)
asan_tests=(--label-regex '^cli$')
for argument in "$@"; do
    case "$argument" in
        --all) 
            all=true fuzz_seconds=60 tidy_options=(--all)
            asan_targets=(all endmill_fuzzers)
            asan_tests=(--label-exclude '^scripts$') ;;
        --help | -h) usage; exit 0 ;;
        *) echo "test.sh: unknown argument $argument, see --help" >&2; exit 2 ;;
    esac
done

elapsed() { printf '%d:%02d' $((SECONDS / 60)) $((SECONDS % 60)); }
step() { printf '== [%s] %s\n' "$(elapsed)" "$*"; }

failed=()
summaries=()

# The checks of scripts, format and layers do not depend on the compiler's flags:
# they carry the label "scripts" and run once, with the release tests.
run_tests() {
    local preset=$1 log="build/$1/ctest.log"
    shift
    step "test: $preset"
    ctest --preset "$preset" --parallel "$(nproc)" --no-tests=error "$@" 2>&1 | tee "$log" ||
        failed+=("$preset tests")
    summaries+=("$preset: $(grep 'tests passed,' "$log" || echo 'no test summary')")
}

build() {
    local preset=$1
    shift
    step "configure: $preset"
    cmake --preset "$preset"
    step "build: $preset"
    cmake --build --preset "$preset" --target "$@"
}

# What they find is kept in build/fuzz/findings.
run_fuzzers() {
    local log=build/fuzz.log said
    step "fuzz: $fuzz_seconds s for each reader"
    scripts/fuzz.sh "$fuzz_seconds" 2>&1 | tee "$log" || failed+=("fuzzers")
    said=$(sed -n 's/^fuzz.sh: //p' "$log")
    summaries+=("fuzz: ${said:-not run}")
}

# A header that needs another one before it is no interface.
compile_headers() {
    step "headers: each alone"
    cmake --build --preset release --target all_verify_interface_header_sets ||
        failed+=("headers")
}

step "set-up"
scripts/setup.sh
build release all
run_tests release
build asan "${asan_targets[@]}"
run_tests asan "${asan_tests[@]}"
run_fuzzers
if $all; then
    compile_headers
fi
step "clang-tidy"
/usr/bin/python3 scripts/check_tidy.py "${tidy_options[@]}" || failed+=("clang-tidy")

verdict="all passed"
if [[ ${#failed[@]} -gt 0 ]]; then
    verdict="FAILED ($(printf '%s; ' "${failed[@]}" | sed 's/; $//'))"
fi
step "$verdict - $(printf '%s; ' "${summaries[@]}" | sed 's/; $//')"
[[ ${#failed[@]} -eq 0 ]]
