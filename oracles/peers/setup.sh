#!/usr/bin/env bash
# Installs the finite element codes this project is timed against and that the scoreboard asks, once: GetFEM, SfePy and CalculiX from
# Debian, NGSolve, Kratos, Akantu and FElupe from PyPI, and by oracles/setup.sh scikit-fem and dolfinx. Timed are NGSolve, scikit-fem
# and dolfinx. No test needs the first seven.
# Serves Debian 12 (bookworm). What is not a Debian package goes to oracles/.python, which git ignores.
set -euo pipefail

packages=(python3-getfem python3-sfepy python3-numpy python3-scipy python3-meshio calculix-ccx)
python=/usr/bin/python3

fail() {
    echo "oracles/peers/setup.sh: $1" >&2
    echo "Only the comparison of times needs these codes; no test does." >&2
    exit 1
}

# shellcheck source=SCRIPTDIR/../debian.sh
source "$(dirname "$0")/../debian.sh"

"$python" -EsBc "import getfem" || fail "GetFEM does not run in $python."
"$python" -EsBc "import sfepy.discrete" || fail "SfePy does not run in $python."
version=$(ccx -v) || true # ccx -v ends with a code of its own
[[ $version == *Version* ]] || fail "ccx does not run."

bash "$(dirname "$0")/../setup.sh"

# Wheels of PyPI into a folder of oracles/.python; what they depend on must be named; moved into place when complete.
laid() {
    local folder how=$2
    folder=$PWD/$(dirname "$0")/../.python/$1
    shift 2
    [[ $(cat "$folder/requirements.txt" 2>/dev/null) == "$*" ]] && return
    rm -rf "$folder" "$folder.new"
    PIP_USER=0 "$python" -m pip install --quiet --no-cache-dir --disable-pip-version-check --root-user-action=ignore \
        --no-deps --no-compile "$how" "$folder.new" "$@" || fail "PyPI did not give $*."
    echo "$*" >"$folder.new/requirements.txt"
    mv "$folder.new" "$folder"
}

# NGSolve: 90 MB are downloaded and 0.3 GB laid down; Kratos: 60 MB and 0.2 GB; Akantu: 7 MB and 30 MB; FElupe: 1 MB and 2 MB.
# Numpy, scipy and meshio are Debian's.
laid ngsolve --prefix ngsolve==6.2.2608 netgen-mesher==6.2.2608 netgen-occt==7.8.1 ngsolve-openblas==0.3.33
laid kratos --target KratosMultiphysics==10.4.4 KratosStructuralMechanicsApplication==10.4.4 \
    KratosContactStructuralMechanicsApplication==10.4.4 KratosLinearSolversApplication==10.4.4
laid akantu --target akantu==5.0.7.post1
laid felupe --target felupe==11.3.0
