#!/usr/bin/env bash
# Installs what the Python oracles need, once: dolfinx from Debian, scikit-fem from PyPI, and where there is a Python from 3.12 on,
# also the dolfinx of today, for a process of its own; then compiles dolfinx's forms. NEWER_PYTHON=/path/to/python3 names that Python.
# Besides, a browser in which a test opens what `solve --html` writes.
# Serves Debian 12 (bookworm). Everything that is not a Debian package goes to oracles/.python, which git ignores.
set -euo pipefail
cd "$(dirname "$0")"

packages=(python3-dolfinx libpython3.11-dev python3-pip libopenblas0-pthread gcc chromium-headless-shell)
scikit_fem=12.0.2
newest_dolfinx=0.11.0.post0
python=/usr/bin/python3
installed=$PWD/.python

fail() {
    echo "oracles/setup.sh: $1" >&2
    echo "Without Python the tests use the frozen results: cargo test --release" >&2
    exit 1
}

source debian.sh

# Without its dependencies: Debian's numpy and scipy serve it, and a newer numpy would break PETSc. Moved into place when
# complete, so that an interrupted installation is made again.
if [[ ! -d $installed/site/scikit_fem-$scikit_fem.dist-info ]]; then
    rm -rf "$installed/site" "$installed/site.new"
    PIP_USER=0 "$python" -m pip install --quiet --no-cache-dir --disable-pip-version-check --root-user-action=ignore \
        --no-deps --target "$installed/site.new" "scikit-fem==$scikit_fem" ||
        fail "PyPI did not give scikit-fem $scikit_fem."
    mv "$installed/site.new" "$installed/site"
fi

# What reads the fields that `solve --vtu` writes, in a folder of its own, which only processes of its own see: it brings a numpy
# that would break PETSc. 140 MB are downloaded and 0.7 GB laid down, once, most of it VTK, in a quarter of a minute of work.
if ! cmp -s readers/requirements.txt "$installed/readers/requirements.txt"; then
    rm -rf "$installed/readers" "$installed/readers.new"
    PIP_USER=0 "$python" -m pip install --quiet --no-cache-dir --disable-pip-version-check --root-user-action=ignore \
        --no-deps --no-compile --target "$installed/readers.new" --requirement readers/requirements.txt ||
        fail "PyPI did not give meshio, pyvista and what they need."
    cp readers/requirements.txt "$installed/readers.new"
    mv "$installed/readers.new" "$installed/readers"
fi

# A compile that was killed leaves a source without its mark, for which every later run would wait.
cache=$installed/cache/fenics
mkdir -p "$cache"
for source in "$cache"/*.c; do
    if [[ -e $source && ! -e $source.cached ]]; then rm -f "$source"; fi
done
"$python" -EsB python/prewarm.py "$installed" || fail "the oracles do not run in $python."

# Today's dolfinx, with PETSc, MUMPS and MPI in wheels for Python 3.12 and glibc 2.34 and later: the tests hold its answers against those of
# Debian's. 100 MB are downloaded and 0.4 GB laid down.
newest=$installed/newest
serves() { "$1" -Ic 'import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 12))' 2>/dev/null; }
if [[ $(cat "$newest/version" 2>/dev/null) != "$newest_dolfinx" ]]; then
    rm -rf "$newest"
    for newer in ${NEWER_PYTHON:-python3.14 python3.13 python3.12 "${PYENV_ROOT:-$HOME/.pyenv}"/versions/3.1[2-9]*/bin/python3}; do
        if serves "$newer"; then
            "$newer" -m venv "$newest" && "$newest/bin/python" -m pip install --quiet --no-cache-dir --disable-pip-version-check \
                "dolfinx-solver-real==$newest_dolfinx" scipy && echo "$newest_dolfinx" >"$newest/version" && break
            echo "oracles/setup.sh: PyPI did not give dolfinx $newest_dolfinx to $newer; the tests do without it." >&2
            rm -rf "$newest"
        fi
    done
fi
if [[ -e $newest/version ]]; then
    "$newest/bin/python" -EsB python/prewarm.py "$installed" || fail "dolfinx $newest_dolfinx does not run in $newest."
fi
