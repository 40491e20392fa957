#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null # nothing here asks a question

usage() {
    cat <<'HELP'
scripts/docs.sh [--no-install]

Builds the documentation with Doxygen: guide, experiments and API as one site, which opens
offline from build/docs/html/index.html. The API covers the installed headers. Installs
missing packages (Debian, root). Warnings are errors, such as a public item without a
comment, a broken link or a parameter that does not exist.

  --no-install   installs nothing and checks that Doxygen and Graphviz are there

Exit 0 without warnings; 1 with warnings, which it prints; 2 if the command line is wrong.
Example: scripts/docs.sh
HELP
}

setup_options=()
for argument in "$@"; do
    case "$argument" in
        --help | -h) usage; exit 0 ;;
        --no-install) setup_options=(--no-install) ;;
        *) echo "docs.sh: unknown argument $argument, see --help" >&2; exit 2 ;;
    esac
done

scripts/setup.sh "${setup_options[@]}" docs
rm -rf build/docs
mkdir -p build/docs
status=0
doxygen docs/Doxyfile >build/docs/log.txt 2>&1 || status=$?
sed "s#^$PWD/##" build/docs/warnings.txt | sort -u >build/docs/warnings_sorted.txt
warnings=$(grep -cE ': (warning|error):' build/docs/warnings_sorted.txt || true)
if [[ $status -ne 0 || $warnings -ne 0 ]]; then
    cat build/docs/warnings_sorted.txt >&2
    [[ -s build/docs/warnings_sorted.txt ]] || cat build/docs/log.txt >&2
    echo "docs.sh: $warnings warnings" >&2
    exit 1
fi
echo "docs.sh: no warnings; the site is build/docs/html/index.html"
