#!/usr/bin/env bash
# Exports cases, solves them by the newest version of every code that PyPI has for this Python, and judges what they answer: newest.sh CODE…
# GetFEM is Debian's or Ubuntu's (python3-getfem). CONTACT_VV names the program; what is installed goes to target/newest.
set -euo pipefail
cd "$(dirname "$0")/.."

program=${CONTACT_VV:-target/release/contact-vv}
place=$PWD/target/newest
cases=(cylinder truncated-hertz pin-rod)
# What a code is asked by, and what installs it.
declare -A method=([dolfinx]=active-set [scikit_fem]=active-set [ngsolve]=active-set [sfepy]="contact --times 10" [felupe]="contact --times 100" [getfem]=basic)
declare -A packages=([dolfinx]="dolfinx-solver-real" [scikit_fem]="scikit-fem" [ngsolve]="ngsolve" [sfepy]="sfepy" [felupe]="felupe meshio" [getfem]="")

failed=()
for code in "${@:-${!method[@]}}"; do
    python=/usr/bin/python3
    if [[ -n ${packages[$code]} ]]; then
        python=$place/$code/bin/python
        [[ -x $python ]] || python3 -m venv "$place/$code"
        read -ra wanted <<<"${packages[$code]}"
        "$python" -m pip install --quiet --disable-pip-version-check --upgrade "${wanted[@]}" scipy || { failed+=("$code: not installed") && continue; }
    fi
    read -ra asked <<<"${method[$code]}"
    for case in "${cases[@]}"; do
        folder=$place/$case
        "$program" export "$case" "$folder" --force >/dev/null
        if ! told=$("$python" "$folder/run_$code.py" "$folder" "${asked[@]}" | tail -n 1); then
            failed+=("$code, $case: the script failed")
            continue
        fi
        echo "$case: $told"
        # shellcheck disable=SC2001 # A pattern that no expansion has.
        file=$folder/$(sed 's/.*"file": "\([^"]*\)".*/\1/' <<<"$told")
        # A table and JSON say their units.
        units=()
        if [[ $file == *.vtu ]]; then units=(--unit position=mm --unit pressure=MPa --unit displacement=mm); fi
        "$program" judge "$case" "$file" --order 2 "${units[@]+"${units[@]}"}" >"$file.txt" || { cat "$file.txt" && failed+=("$code, $case: not met, or refused"); }
    done
done
printf '%s\n' "${failed[@]+"${failed[@]}"}" >&2
((${#failed[@]} == 0))
