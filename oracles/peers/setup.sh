#!/usr/bin/env bash
# Installs the finite element codes this project is timed against, once: GetFEM and CalculiX, both from Debian.
# No test needs them.
# Serves Debian 12 (bookworm). Writes nothing into the repository.
set -euo pipefail

packages=(python3-getfem python3-numpy python3-scipy calculix-ccx)
python=/usr/bin/python3

fail() {
    echo "oracles/peers/setup.sh: $1" >&2
    echo "Only the comparison of times needs these codes; no test does." >&2
    exit 1
}

missing=()
for package in "${packages[@]}"; do
    dpkg-query --show --showformat='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if ((${#missing[@]})); then
    release=$(. /etc/os-release 2>/dev/null && echo "${ID:-unknown} ${VERSION_ID:-}" || echo unknown)
    [[ $release == "debian 12" ]] ||
        fail "this serves Debian 12 and is run on $release, where ${missing[*]} are missing; use the container debian:12."
    if ((EUID == 0)); then as_root=(env); else as_root=(sudo env); fi
    command -v "${as_root[0]}" >/dev/null ||
        fail "${missing[*]} are missing, and installing them needs root or sudo."
    apt=("${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 -q)
    "${apt[@]}" update || fail "Debian's servers do not answer; ${missing[*]} are missing."
    "${apt[@]}" install -y --no-install-recommends "${missing[@]}" || fail "Debian did not install ${missing[*]}."
fi

"$python" -EsBc "import getfem" || fail "GetFEM does not run in $python."
version=$(ccx -v) || true # ccx -v ends with a code of its own
[[ $version == *Version* ]] || fail "ccx does not run."
