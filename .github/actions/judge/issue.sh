#!/usr/bin/env bash
# Reads the form *Judge my answer* from BODY and fetches into answers/ what is attached. Anybody may have written BODY: nothing of it
# is run, and only names, units and links of the expected shape go on.
set -euo pipefail

refuse() {
    echo "$1" >refused.md
    echo "sheet=refused.md" >>"$GITHUB_OUTPUT"
    exit 1
}

# What has a shape in the lines below a heading of the form.
field() { awk -v heading="### $1" '{ gsub(/^[ \t]+|[ \t\r]+$/, "") } /^### / { on = $0 == heading; next } on' <<<"$BODY" | grep -oE "$2" || true; }

name=$(field Case '^[a-z][a-z-]*$' | head -n 1)
if [[ -z $name ]]; then refuse 'No case is named: open an issue by the form *Judge my answer*.'; fi
links=$(field Answer 'https://github\.com/([A-Za-z0-9._-]+/)?[A-Za-z0-9._-]+/files/[0-9]+/[A-Za-z0-9][A-Za-z0-9._-]*' | head -n 5)
if [[ -z $links ]]; then refuse 'No file is attached: drag one into *Answer*, packed by gzip where GitHub does not take it.'; fi
wrong=$(field Units '.+' | grep -vE '^([a-z]+=[^[:space:]]+|_No response_)$' | head -n 1 || true)
# shellcheck disable=SC2016 # Markdown.
if [[ -n $wrong ]]; then refuse 'A line of *Units* is not of the form `quantity=unit`, as `pressure=MPa`: edit it.'; fi
mkdir answers
number=0
for link in $links; do
    number=$((number + 1))
    curl --proto '=https' -sSfL --max-time 60 --max-filesize 25000000 --output "answers/$number-${link##*/}" "$link" ||
        refuse "\`${link##*/}\` cannot be fetched: attach it again."
done
{ echo "case=$name"; echo 'units<<END'; field Units '^[a-z]+=[^[:space:]]+$'; echo END; } >>"$GITHUB_OUTPUT"
