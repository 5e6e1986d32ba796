#!/bin/sh
# trust: the table of what runs, in tests/TRUST.md: a row for every group of `make check` and every line of `make nightly`.
#
#     sh tests/checks/trust.sh             rows of groups that ran here since `make clean` (build/told.csv, written by check.sh)
#                                          and of NIGHTLY.md are written anew, all others stay as they are, or are written
#                                          without a day
#     sh tests/checks/trust.sh --compare   status 1 where a group or a line has no row, or a row is of none
#
# The table stands between two lines that begin with `<!-- runs`.
set -eu
page=tests/TRUST.md told=build/told.csv new=build/trust.md
mkdir -p build
groups=$(sed -n "s/^groups='\(.*\)'$/\1/p" tests/checks/check.sh)
rows() { sed -n '/^<!-- runs begin/,/^<!-- runs end/p' $page | grep '^| `' || :; }
lines() { sh tests/checks/nightly.sh --list; }
night() {                                               # night LINE: its row
    grep -F "| $1 |" tests/NIGHTLY.md | sed 's/^/| `nightly` /' | grep . || echo "| \`nightly\` | $1 | | | | |"
}
named() { awk -F ' [|] ' '{ print $1 " | " $2 }' | LC_ALL=C sort; }     # the first two columns

# group GROUP: its row: what it said last, else what is there.
group() {
    [ ! -f $told ] || line=$(grep "^$1," $told | tail -n 1)
    if [ "${line:-}" ]; then
        echo "$line" | awk -F, '{ printf "| `check` | %s | %s | %s | %d | %d passed, %d failed |\n", $1, $2, $3, $6, $4, $5 }'
    else
        rows | grep -F "| \`check\` | $1 |" || echo "| \`check\` | $1 | | | | |"
    fi
}

if [ "${1:-}" = --compare ]; then
    { for g in $groups; do echo "| \`check\` | $g"; done; lines | sed 's/^/| `nightly` | /'; } |
        LC_ALL=C sort > build/trust_want.txt
    rows | sed 's/ |$/ | /' | named | diff build/trust_want.txt -
    exit
fi
{
    sed '/^<!-- runs begin/q' $page
    echo
    echo '| run by | what | day | commit | seconds of processor | figure |'
    echo '|---|---|---|---|--:|---|'
    for g in $groups; do line=; group "$g"; done
    lines | while read -r l; do night "$l"; done
    echo
    sed -n '/^<!-- runs end/,$p' $page
} > $new
cp $new $page
