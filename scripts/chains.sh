#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null # nothing here asks a question

usage() {
    cat <<'HELP'
scripts/chains.sh [PART ...]

Leads parts from a setup to checked five-axis programs, as docs/guide/five-axes.md does: setup,
plan --setups (3+2 axes), verify, and for two machines of different kinds setup --path, post and
verify of the program. Prints a line for each step.

  PART  walled-saddle, dome or teapot (default: all)

Needs build/release/src/cli/endmill. Results: results/chains/PART. All parts together take
about five minutes. Exit 0 if every path and program is clean; 1 if not; 2 if the command line
is wrong.
Example: scripts/chains.sh dome
HELP
}

endmill=build/release/src/cli/endmill
machines=(ca-table-table cb-head-head)

status=0

# step EXPECTED NAME COMMAND...: runs a command silently and prints its name, exit code and
# seconds. Another exit code than expected makes that of this script 1.
step() {
    local expected=$1 name=$2 code=0 start=$SECONDS
    shift 2
    "$@" >"$folder/$name.log" 2>&1 || code=$?
    printf '%-14s %-24s exit %d, %d s\n' "$part" "$name" "$code" $((SECONDS - start))
    [ "$code" = "$expected" ] || status=1
}

# chain RESOLUTION_MM: the chain of $part, for the arrays mesh, skip and cut.
chain() {
    local resolution=$1
    # One setup does not suffice, so the first command ends with 1.
    step 1 setup "$endmill" setup "${mesh[@]}" "${skip[@]}" --machine W/xyBz/T --max-setups 8 \
        --incidence-deg 85 -o "$folder/setup" --force
    step 0 plan "$endmill" plan "${mesh[@]}" "${skip[@]}" --setups "$folder/setup/summary.json" \
        "${cut[@]}" --inner-tolerance 0.05 --strategy planar -o "$folder/plan" --force
    step 0 verify "$endmill" verify "$folder/plan/toolpath.csv" --resolution "$resolution" \
        -o "$folder/verify" --force
    local machine
    for machine in "${machines[@]}"; do
        local file=datasets/machines/$machine.json
        step 0 "setup-$machine" "$endmill" setup --path "$folder/plan/toolpath.csv" \
            --machine "$file" -o "$folder/setup-$machine" --force
        step 0 "post-$machine" "$endmill" post "$folder/plan/toolpath.csv" --machine "$file" \
            --setup "$folder/setup-$machine/summary.json" --feed 1000 --spindle-rpm 8000 \
            -o "$folder/post-$machine" --force
        step 0 "verify-$machine" "$endmill" verify "$folder/post-$machine/toolpath.ngc" \
            --part "${mesh[@]}" "${skip[@]}" "${cut[@]}" --tolerance 0.05 --inaccessible report \
            --resolution "$resolution" -o "$folder/verify-$machine" --force
    done
}

parts=("$@")
[ $# -gt 0 ] || parts=(walled-saddle dome teapot)
for part in "${parts[@]}"; do
    case $part in
    walled-saddle | dome | teapot) ;;
    -h | --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
    esac
done

for part in "${parts[@]}"; do
    folder=results/chains/$part
    mkdir -p "$folder"
    case $part in
    walled-saddle)
        mesh=(datasets/meshes/walled-saddle.off)
        skip=(--skip-facets datasets/meshes/walled-saddle-bottom.txt)
        cut=(--cutter ball:8 --scallop 0.3)
        resolution=0.5
        ;;
    dome)
        seq 0 1 >"$folder/bottom.txt"
        mesh=(datasets/meshes/dome.stl)
        skip=(--skip-facets "$folder/bottom.txt")
        cut=(--cutter ball:8 --scallop 0.3)
        resolution=0.5
        ;;
    teapot) # it has no bottom; lengths in the file are inches
        mesh=(datasets/meshes/teapot-288.off --units inch)
        skip=()
        cut=(--cutter ball:6 --scallop 0.5)
        resolution=0.8
        ;;
    esac
    chain "$resolution"
done
exit "$status"
