#!/usr/bin/env bash
# Installs the finite element codes this project is timed against and that the scoreboard asks, once: GetFEM and CalculiX from Debian, and by
# oracles/setup.sh scikit-fem and dolfinx. No test needs GetFEM and CalculiX.
# Serves Debian 12 (bookworm). Writes nothing into the repository.
set -euo pipefail

packages=(python3-getfem python3-numpy python3-scipy calculix-ccx)
python=/usr/bin/python3

fail() {
    echo "oracles/peers/setup.sh: $1" >&2
    echo "Only the comparison of times needs these codes; no test does." >&2
    exit 1
}

source "$(dirname "$0")/../debian.sh"

"$python" -EsBc "import getfem" || fail "GetFEM does not run in $python."
version=$(ccx -v) || true # ccx -v ends with a code of its own
[[ $version == *Version* ]] || fail "ccx does not run."

bash "$(dirname "$0")/../setup.sh"
