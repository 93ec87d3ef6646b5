#!/usr/bin/env bash
# Makes the wheel of the program as cargo has compiled it, and passes its examples, and those of the README, where there is nothing
# of ours but the wheel: in a new environment with numpy alone. Another Python than Debian's may be named.
set -euo pipefail
cd "$(dirname "$0")"
python=${1:-/usr/bin/python3}
maturin=$PWD/../target/maturin-1.16.0
export PIP_USER=0 PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_ROOT_USER_ACTION=ignore

fail() {
    echo "python/check.sh: $1" >&2
    exit 1
}

if ! "$python" -m pip --version >/dev/null 2>&1; then
    packages=(python3-pip)
    source ../oracles/debian.sh
fi
[[ -x $maturin/bin/maturin ]] || "$python" -m pip install --quiet --no-deps --target "$maturin" "maturin==${maturin##*-}" ||
    fail "PyPI did not give maturin ${maturin##*-}."

# What cargo has compiled is taken as it is: neither another profile nor stripped, which would compile or link anew.
alone=$(mktemp -d)
trap 'rm -rf "$alone"' EXIT
# maturin would compile the package alone, with other features of its dependencies than the workspace has.
mkdir "$alone/bin"
cat >"$alone/bin/cargo" <<END
#!/bin/sh
if [ "\$1" = rustc ]; then
    cd "$PWD/.." && exec "$(command -v cargo)" build --release --bin contact-vv --message-format json-render-diagnostics
fi
exec "$(command -v cargo)" "\$@"
END
chmod +x "$alone/bin/cargo"
PATH=$alone/bin:$PATH "$maturin/bin/maturin" build --quiet --release --compatibility linux --out "$alone"
examples=$PWD/examples.py
cd "$alone"
"$python" -m venv --without-pip here
"$python" -m pip --python here/bin/python install --quiet numpy ./*.whl || fail "PyPI did not give numpy."
here/bin/python -I -X utf8 "$examples"
