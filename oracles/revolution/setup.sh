#!/usr/bin/env bash
# Installs what the scripts of bodies of revolution need beyond ../setup.sh, once: CalculiX from Debian, tamaas from PyPI.
# Serves Debian 12 (bookworm). What is not a Debian package goes to oracles/.python, which git ignores.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=(python3-numpy python3-scipy python3-pip calculix-ccx)
tamaas=2.9.0
python=/usr/bin/python3
installed=$PWD/.python

fail() {
    echo "oracles/revolution/setup.sh: $1" >&2
    exit 1
}

# shellcheck source=SCRIPTDIR/../debian.sh
source debian.sh

# Without its numpy 2: it runs with Debian's, which scipy needs. 2 MB are downloaded and 5 MB laid down.
if [[ ! -d $installed/tamaas/tamaas-$tamaas.dist-info ]]; then
    rm -rf "$installed/tamaas" "$installed/tamaas.new"
    PIP_USER=0 "$python" -m pip install --quiet --no-cache-dir --disable-pip-version-check --root-user-action=ignore \
        --no-deps --target "$installed/tamaas.new" "tamaas==$tamaas" || fail "PyPI did not give tamaas $tamaas."
    mv "$installed/tamaas.new" "$installed/tamaas"
fi
