#!/usr/bin/env bash
# Judges the files that the Action is given in INPUTS, as JSON: the sheet goes to the summary of the job, every check to JUnit XML.
# Exits as `contact-vv judge` does. What is in an answer is never taken for a command of the shell or of the workflow.
set -euo pipefail
shopt -s nullglob
# Bash 3 of macOS has no `**`.
shopt -s globstar 2>/dev/null || deep=refused

folder=$(mktemp -d)
sheet=$folder/sheet.md

# Publishes the sheet and ends; the log shows what is not met or wrong.
finish() {
    echo "sheet=$sheet" >>"${GITHUB_OUTPUT:-/dev/null}"
    cat "$sheet" >>"${GITHUB_STEP_SUMMARY:-/dev/null}"
    if (($1 > 0)); then
        echo "::error title=contact-vv judge::$(awk '{ gsub(/%/, "%25"); gsub(/\r/, ""); printf "%s%%0A", $0 }' "$sheet")"
    fi
    exit "$1"
}

refuse() {
    echo "$1" >"$sheet"
    finish 2
}

# An input; of several lines those that are not empty, without blanks around them.
input() { jq -r --arg name "$1" '.[$name] // ""' <<<"$INPUTS" | sed -e 's/^[[:space:]]*//' -e 's/[[:space:]]*$//' -e '/^$/d'; }

program=$(input program)
if [[ -z $program ]]; then
    case ${RUNNER_OS:-unknown}-${RUNNER_ARCH:-unknown} in
        Linux-X64) target=x86_64-unknown-linux-musl ;;
        Linux-ARM64) target=aarch64-unknown-linux-musl ;;
        macOS-X64) target=x86_64-apple-darwin ;;
        macOS-ARM64) target=aarch64-apple-darwin ;;
        Windows-X64) target=x86_64-pc-windows-msvc ;;
        *) refuse "No contact-vv is released for this runner: build one, and name it by the input \`program\`." ;;
    esac
    version=$(input version)
    if [[ $version == latest ]]; then place=latest/download; else place=download/v${version#v}; fi
    from=$GITHUB_SERVER_URL/$REPOSITORY/releases/$place/contact-vv-$target.tar.gz
    curl --proto '=https' -sSfL --retry 3 "$from" | tar -xzf - -C "$folder" ||
        refuse "\`$from\` is not to be had: name a release by the input \`version\`."
    program=$folder/contact-vv
fi

command -v "$program" >/dev/null || refuse "There is no program \`$program\`: build it in a step before, or leave the input \`program\` out."
# Remove an older report: after a refusal it would be taken for this one's.
junit=$(input junit)
if [[ $junit == *.xml && -f $junit ]]; then rm -f -- "$junit"; fi
command=("$program" judge --markdown "--junit=$(input junit)")
while IFS= read -r option; do command+=("$option"); done < <(
    input units | sed 's/^/--unit=/'
    input columns | sed 's/^/--column=/'
    input options
)
command+=(-- "$(input case)")
while IFS= read -r pattern; do
    if [[ -e $pattern ]]; then
        command+=("$pattern")
        continue
    fi
    if [[ -n ${deep:-} && $pattern == *'**'* ]]; then refuse "The shell of this runner knows no \`**\`: name the folders."; fi
    # shellcheck disable=SC2206 # A glob; a name with blanks is one name.
    IFS='' files=($pattern)
    if ((${#files[@]} == 0)); then refuse "No file matches \`$pattern\`, of the input \`files\`."; fi
    command+=("${files[@]}")
done < <(input files)

code=0
"${command[@]}" >"$sheet" 2>"$folder/wrong" || code=$?
if [[ -s $folder/wrong ]]; then
    # An answer may be quoted: it neither ends the block nor fills the summary.
    { echo '```text'; head -c 60000 "$folder/wrong" | tr '\140' "'"; echo; echo '```'; } >>"$sheet"
fi
finish "$code"
