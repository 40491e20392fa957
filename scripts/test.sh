#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null # nothing here asks, and a closed standard input would confuse some tools

usage() {
    cat <<'HELP'
scripts/test.sh [--all] [--no-install]

Installs missing packages (Debian, root) and runs the tests:
  1. builds the preset release (g++) with all experiments, and runs all tests;
  2. builds the program and the fuzzers by the preset asan (clang, address and
     undefined-behaviour sanitizers), runs the tests of bad input and of short commands,
     and fuzzes each reader for 3 s (scripts/fuzz.sh);
  3. runs clang-tidy on the files that changed since the merge base with origin/main, or
     on main itself since the commit before.
It takes about 35 minutes on two cores, beginning with an empty clone.

  --all          also runs all tests under sanitizers, builds the program by the preset
                 tsan (clang, thread sanitizer) and runs every command that writes on 2
                 and on 8 threads, fuzzes each reader for 60 s, repeats the tests of
                 faults many times as often, compiles all benchmarks and every installed
                 header alone, builds and tests the Debian package, installs the Python
                 package by pip, builds the documentation, runs an experiment by
                 scripts/reproduce.sh, compares every picture of docs/images with what its
                 commands make, and runs clang-tidy on every file; takes hours on two cores
  --no-install   installs nothing and checks that every program and library is there

Build folders: build/release, build/asan, build/fuzz, with --all also build/tsan. Rebuilds only changed files.
Exit 0 if everything passed; 1 otherwise; 2 if the command line is wrong.
Example: scripts/test.sh --no-install
HELP
}

all=false
fuzz_seconds=3
tidy_options=()
setup_options=()
groups=(build mpi cad python page figures tests sanitizers)
release_targets=(all endmill_tests endmill_experiments)
asan_targets=(endmill endmill_fuzzers)
# The commands that read files; the others take minutes under sanitizers.
asan_tests=(--tests-regex '^cli\.(bad_input|coefficients|eval|feed|import|info|mesh_part|post|sample|toollife)_test$')
for argument in "$@"; do
    case "$argument" in
        --all)
            export ENDMILL_FAULTS=long
            all=true fuzz_seconds=60 tidy_options=(--all)
            groups+=(benchmarks docs packaging)
            release_targets+=(endmill_benchmarks)
            asan_targets+=(endmill_tests)
            asan_tests=(--label-exclude '^scripts$') ;;
        --no-install) setup_options=(--no-install) ;;
        --help | -h) usage; exit 0 ;;
        *) echo "test.sh: unknown argument $argument, see --help" >&2; exit 2 ;;
    esac
done

elapsed() { printf '%d:%02d' $((SECONDS / 60)) $((SECONDS % 60)); }
step() { printf '== [%s] %s\n' "$(elapsed)" "$*"; }

failed=()
summaries=()

# The checks of scripts, format and layers do not depend on the compiler's flags. They
# have the label "scripts" and run once, with the release tests.
run_tests() {
    local preset=$1 log="build/$1/ctest.log"
    shift
    step "test: $preset"
    # one more than cores: some tests wait most of their time
    ctest --preset "$preset" --parallel "$(($(nproc) + 1))" --no-tests=error "$@" 2>&1 | tee "$log" ||
        failed+=("$preset tests")
    summaries+=("$preset: $(grep 'tests passed,' "$log" || echo 'no test summary')")
}

build() {
    local preset=$1
    shift
    step "build: $preset"
    cmake --build --preset "$preset" --target "$@"
}

# Findings are kept in build/fuzz/findings.
run_fuzzers() {
    local log=build/fuzz.log said
    step "fuzz: $fuzz_seconds s for each reader"
    scripts/fuzz.sh "${setup_options[@]}" "$fuzz_seconds" 2>&1 | tee "$log" || failed+=("fuzzers")
    said=$(sed -n 's/^fuzz.sh: //p' "$log")
    summaries+=("fuzz: ${said:-not run}")
}

# run NAME COMMAND...: runs a separate step, which may fail.
run() {
    local name=$1
    shift
    step "$name"
    "$@" || failed+=("$name")
}

step "set-up"
scripts/setup.sh "${setup_options[@]}" "${groups[@]}"
step "configure: release"
cmake --preset release
build release "${release_targets[@]}"
run_tests release
step "configure: asan"
# The preset names the clang of Debian 12. Other systems use the default clang.
clang=()
command -v clang++-14 >/dev/null || clang=(-D CMAKE_CXX_COMPILER=clang++)
cmake --preset asan "${clang[@]}"
build asan "${asan_targets[@]}"
run_tests asan "${asan_tests[@]}"
run_fuzzers
if $all; then
    step "configure: tsan"
    cmake --preset tsan "${clang[@]}"
    build tsan endmill
    run_tests tsan --tests-regex '^cli\.threads_test$'
    run headers cmake --build --preset release --target all_verify_interface_header_sets
    run "package: build" cmake --build --preset release --target package
    run "package: try" /usr/bin/python3 tests/package/package_test.py
    run "package: pip" /usr/bin/python3 tests/package/pip_test.py
    run documentation scripts/docs.sh "${setup_options[@]}"
    run reproduction scripts/reproduce.sh "${setup_options[@]}" economic-cl-data/table-1
    run pictures /usr/bin/python3 scripts/write_pictures.py --check --all
fi
run clang-tidy /usr/bin/python3 scripts/check_tidy.py "${tidy_options[@]}"

verdict="all passed"
if [[ ${#failed[@]} -gt 0 ]]; then
    verdict="FAILED ($(printf '%s; ' "${failed[@]}" | sed 's/; $//'))"
fi
step "$verdict - $(printf '%s; ' "${summaries[@]}" | sed 's/; $//')"
[[ ${#failed[@]} -eq 0 ]]
