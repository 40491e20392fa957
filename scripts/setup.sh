#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages of scripts/packages.txt that are missing. Debian, as root;
# anybody else is told the command and exit 1. Nothing missing: nothing is done.
set -euo pipefail

packages_file="$(dirname "${BASH_SOURCE[0]}")/packages.txt"
mapfile -t wanted < <(sed 's/#.*//' "$packages_file" | tr -s '[:space:]' '\n' | sed '/^$/d')

installed() {
    # The second letter of the state is i for an installed package, held ones included.
    dpkg-query --show --showformat='${db:Status-Abbrev} ${Package}\n' "${wanted[@]}" 2>/dev/null |
        awk 'substr($1, 2, 1) == "i" { print $2 }'
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "set-up: needs Debian's apt-get; on Debian 12 it would be:" >&2
    echo "  apt-get install --no-install-recommends ${wanted[*]}" >&2
    exit 1
fi

mapfile -t missing < <(comm -23 <(printf '%s\n' "${wanted[@]}" | sort -u) <(installed | sort -u))
if [[ ${#missing[@]} -eq 0 ]]; then
    exit 0
fi
if [[ $EUID -ne 0 ]]; then
    echo "set-up: ${#missing[@]} packages are missing; as root:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
fi

echo "set-up: installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
# Another apt-get may hold the lock on a machine that has just started.
apt_get=(apt-get -q -o DPkg::Lock::Timeout=120)
"${apt_get[@]}" update </dev/null
"${apt_get[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null
