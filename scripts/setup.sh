#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
    cat <<'HELP'
scripts/setup.sh [--no-install] [--list] [GROUP ...]

Installs the missing Debian packages of the groups, or of all groups. It needs root and
apt-get only if something is missing. The other scripts call it with the groups they need.

  build        compiler, CMake and libraries: the program endmill and the experiments
  mpi          Open MPI and Boost.MPI: the program endmill-mpi
  python       pybind11 and NumPy: the Python package
  page         npm and esbuild: the page of endmill view, and Chromium, which tests it
  cad          OpenCASCADE: the program endmill-cad, which reads STEP and IGES
  figures      draws the figures of results/report.html
  benchmarks   libraries that the benchmarks compare with
  tests        test framework, checks of format and style, interpreter of G-code
  sanitizers   clang with its sanitizers and fuzzer
  docs         Doxygen and Graphviz
  paper        LaTeX and Matplotlib: the replication paper
  packaging    makes the Debian package

  --no-install   installs nothing. Checks that every program and library exists, from any
                 source, and lists the missing ones. For other Linux distributions.
  --list         prints the packages of the groups

Exit 0 if nothing is missing; 1 if something is missing; 2 if the command line is wrong.
Example: scripts/setup.sh build figures
HELP
}

packages_file=scripts/packages.txt

fail() {
    echo "setup.sh: $2" >&2
    exit "$1"
}

# Prints "PACKAGE|TEST|REASON" of every package of a group.
packages_of() {
    awk -v group="[$1]" '
        /^\[/ { inside = ($0 == group) }
        inside && /\|/ && !/^#/ { gsub(/ *\| */, "|"); print }' "$packages_file"
}

mapfile -t all_groups < <(sed -n 's/^\[\(.*\)\]$/\1/p' "$packages_file")
action=install
groups=()
for argument in "$@"; do
    case "$argument" in
        --help | -h) usage; exit 0 ;;
        --no-install) action=look ;;
        --list) action=list ;;
        -*) fail 2 "unknown option $argument, see --help" ;;
        *)
            [[ " ${all_groups[*]} " == *" $argument "* ]] ||
                fail 2 "no group $argument; there are: ${all_groups[*]}"
            groups+=("$argument") ;;
    esac
done
if [[ ${#groups[@]} -eq 0 ]]; then
    groups=("${all_groups[@]}")
fi
mapfile -t wanted < <(for group in "${groups[@]}"; do packages_of "$group"; done)

# --- Without installing: look for the contents of the packages. ---

# Prints the numbers of the CMake tests ("cmake ..." or "library ...") that fail. One
# small project runs all of them in the same way as the build.
failed_cmake_tests() {
    local folder number test status=0
    folder=$(mktemp -d)
    {
        echo "cmake_minimum_required(VERSION 3.25)"
        echo "project(probe LANGUAGES C CXX)"
        while IFS='|' read -r number test; do
            case "$test" in
                "cmake "*)
                    local arguments=${test#cmake }
                    echo "find_package($arguments QUIET)"
                    echo "if(NOT ${arguments%% *}_FOUND)" ;;
                "library "*)
                    echo "find_library(library_$number ${test#library })"
                    echo "if(NOT library_$number)" ;;
            esac
            echo "  file(APPEND missing.txt \"$number\\n\")"
            echo "endif()"
        done
    } >"$folder/CMakeLists.txt"
    sed -i "s#missing.txt#$folder/missing.txt#" "$folder/CMakeLists.txt"
    cmake -G Ninja -S "$folder" -B "$folder/build" >"$folder/log" 2>&1 || status=$?
    if [[ $status -ne 0 ]]; then
        cat "$folder/log" >&2
        rm -rf "$folder"
        return 1
    fi
    cat "$folder/missing.txt" 2>/dev/null || true
    rm -rf "$folder"
}

# Succeeds if a test other than a CMake test succeeds.
passes() {
    local kind=${1%% *} subject=${1#* } name
    case "$kind" in
        program)
            for name in $subject; do
                command -v "$name" >/dev/null && return 0
            done
            return 1 ;;
        python) /usr/bin/python3 -c "import $subject" >/dev/null 2>&1 ;;
        tex) command -v kpsewhich >/dev/null && kpsewhich "$subject" >/dev/null ;;
        header) echo "#include <$subject>" | c++ -fsyntax-only -x c++ - >/dev/null 2>&1 ;;
        sanitizer)
            echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
                "$(command -v clang++-14 || command -v clang++ || echo false)" \
                    "-fsanitize=$subject" -x c++ -o /dev/null - >/dev/null 2>&1 ;;
        *) fail 1 "$packages_file: unknown test '$1'" ;;
    esac
}

look() {
    local i missing=() packages=() package test reason cmake_tests="" failed
    for i in "${!wanted[@]}"; do
        IFS='|' read -r package test reason <<<"${wanted[i]}"
        case "$test" in
            "cmake "* | "library "*) cmake_tests+="$i|$test"$'\n' ;;
            *) passes "$test" || missing+=("$i") ;;
        esac
    done
    if [[ -n $cmake_tests ]]; then
        if command -v cmake >/dev/null && command -v ninja >/dev/null && command -v c++ >/dev/null; then
            failed=$(failed_cmake_tests <<<"${cmake_tests%$'\n'}") || fail 1 "CMake failed, see above"
            mapfile -t -O "${#missing[@]}" missing <<<"$failed"
        else
            echo "setup.sh: the libraries cannot be looked for without cmake, ninja and c++" >&2
        fi
    fi
    for i in "${missing[@]}"; do
        [[ -n $i ]] || continue
        IFS='|' read -r package test reason <<<"${wanted[i]}"
        printf '  %-32s %s (Debian package %s)\n' "${test#program }" "$reason" "$package" >&2
        packages+=("$package")
    done
    if [[ ${#packages[@]} -gt 0 ]]; then
        fail 1 "${#packages[@]} of ${#wanted[@]} requirements are missing, listed above"
    fi
}

# --- Debian ---

# Prints the packages whose program is not there. Node.js, for one, often comes from elsewhere, and
# then excludes the package.
without_programs_there() {
    local package name test reason
    for package; do
        for name in "${wanted[@]}"; do
            IFS='|' read -r name test reason <<<"$name"
            [[ $name == "$package" && $test == "program "* ]] && passes "$test" && continue 2
        done
        echo "$package"
    done
}

install_missing() {
    local names missing apt_get
    mapfile -t names < <(printf '%s\n' "${wanted[@]}" | cut -d'|' -f1 | sort -u)
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "setup.sh: only Debian packages can be installed; --no-install looks for what is there" >&2
        fail 1 "on Debian 12: apt-get install --no-install-recommends ${names[*]}"
    fi
    # The second letter of the state is i for an installed package, even if it is held.
    mapfile -t missing < <(comm -23 <(printf '%s\n' "${names[@]}") <(
        dpkg-query --show --showformat='${db:Status-Abbrev} ${Package}\n' "${names[@]}" 2>/dev/null |
            awk 'substr($1, 2, 1) == "i" { print $2 }' | sort -u))
    mapfile -t missing < <(without_programs_there "${missing[@]}")
    if [[ ${#missing[@]} -eq 0 ]]; then
        return
    fi
    if [[ $EUID -ne 0 ]]; then
        echo "setup.sh: ${#missing[@]} packages are missing; install them as root:" >&2
        echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
        fail 1 "if they are installed by other means, use --no-install"
    fi
    echo "setup.sh: installing ${missing[*]}"
    export DEBIAN_FRONTEND=noninteractive
    # Another apt-get may hold the lock on a machine that has just started.
    apt_get=(apt-get -q -o DPkg::Lock::Timeout=120)
    "${apt_get[@]}" update </dev/null
    "${apt_get[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null
}

case "$action" in
    list) printf '%s\n' "${wanted[@]}" | cut -d'|' -f1 ;;
    look) look ;;
    install) install_missing ;;
esac
