#!/bin/sh
# trust: the table of what runs, in tests/TRUST.md: a row for every stage of .ci/run but `make check`, for every group of that, and
# for every line of `make nightly`.
#
#     sh tests/checks/trust.sh             rows of what ran here since `make clean` (build/told.csv, written by .ci/run and
#                                          check.sh) and of NIGHTLY.md are written anew, all others stay as they are, or are
#                                          written without a day
#     sh tests/checks/trust.sh --compare   status 1 where something has no row, or a row is of nothing
#
# The table stands between two lines that begin with `<!-- runs`.
set -eu
page=tests/TRUST.md told=build/told.csv new=build/trust.md
mkdir -p build
groups=$(sed -n "s/^groups='\(.*\)'$/\1/p" tests/checks/check.sh)
rows() { sed -n '/^<!-- runs begin/,/^<!-- runs end/p' $page | grep '^| `' || :; }
lines() { sh tests/checks/nightly.sh --list; }
stages() { sed -n 's/^stage "\([^"]*\)" .*/\1/p' .ci/run | grep -vxE 'clean|packages|everything'; }
night() {                                               # night LINE: its row
    grep -F "| $1 |" tests/NIGHTLY.md | sed 's/^/| `nightly` /' | grep . || echo "| \`nightly\` | $1 | | | | |"
}
named() { awk -F ' [|] ' '{ print $1 " | " $2 }' | LC_ALL=C sort; }     # the first two columns

# told BY WHAT: its row: what it said last, else what is there.
told() {
    line=
    [ ! -f $told ] || line=$(grep "^$2," $told | tail -n 1)
    if [ "$line" ]; then
        echo "$line" | awk -F, -v by="$1" '{
            said = $0
            sub(/^([^,]*,)*[0-9]+,[0-9]+,[0-9]+,[0-9]+,/, "", said)             # what follows four numbers
            printf "| `%s` | %s | %s | %s | %d | %d passed, %d failed%s |\n", by, $1, $2, $3, $6, $4, $5, said == "" ? "" : "; " said }'
    else
        rows | grep -F "| \`$1\` | $2 |" || echo "| \`$1\` | $2 | | | | |"
    fi
}
# What of .ci/run is asked of promises alone, in minutes.
minutes() {
    awk -F ' *[|] *' '/^[|] `(check|.ci\/run)` [|] (sanitizers|instruments|oracle|static|fuzz|mutants|coverage|any bytes) / { s += $6; n++ }
        END { printf "Of `.ci/run` these take %.0f minutes of processor: sanitizers, instruments, oracle, static, fuzz, mutants, coverage, any bytes.\n", s / 60 }' "$1"
}

if [ "${1:-}" = --compare ]; then
    { stages | sed 's|^|\| `.ci/run` \| |'; for g in $groups; do echo "| \`check\` | $g"; done; lines | sed 's/^/| `nightly` | /'; } |
        LC_ALL=C sort > build/trust_want.txt
    rows | sed 's/ |$/ | /' | named | diff build/trust_want.txt -
    exit
fi
{
    sed '/^<!-- runs begin/q' $page
    echo
    echo '| run by | what | day | commit | seconds of processor | figure |'
    echo '|---|---|---|---|--:|---|'
    stages | while read -r s; do told .ci/run "$s"; done
    for g in $groups; do told check "$g"; done
    lines | while read -r l; do night "$l"; done
} > $new
{
    echo
    minutes $new
    echo
    sed -n '/^<!-- runs end/,$p' $page
} >> $new
cp $new $page
