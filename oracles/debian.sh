# Installs the Debian packages named in `packages` that are missing; sourced by the set-ups, which define `fail`.
# Serves Debian 12 (bookworm).
# shellcheck shell=bash disable=SC2154 # `packages` is theirs.
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
