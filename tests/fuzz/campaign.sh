#!/bin/sh
# campaign: very many executions of every target, in pieces that add up. Needs clang.
#
#     sh tests/fuzz/campaign.sh HOW TARGET      a piece of CAMPAIGN_SECONDS (300) of clock, unless the campaign is whole: libFuzzer,
#                                               HOW is sanitized (ASan, clang's UBSan), forgotten (MSan) or optimised
#                                               (-O2, for depth)
#                                               MORE=1: a piece although it is whole
#     sh tests/fuzz/campaign.sh --keep [TARGET...]  the fewest inputs that reach what all of them reached, into tests/fuzz/kept
#     sh tests/fuzz/campaign.sh --table         what was reached, of which commits
#
# A piece adds a row to campaign.csv, to be committed with what --keep wrote; inputs are kept in build/fuzz/corpus between pieces,
# what fails in build/fuzz/campaign-TARGET-*. Targets: see fuzz.sh. The last line is the sum over all pieces.
set -eu
. tests/fuzz/targets.sh
csv=tests/fuzz/campaign.csv
[ -f $csv ] || echo "target,how,day,commit,executions,seconds,findings" > $csv

wanted() {                                              # wanted TARGET HOW: executions of a whole campaign
    case $1,$2 in scene,optimised) echo 1000000 ;; scene,*) echo 100000 ;; *,optimised) echo 10000000 ;; *) echo 1000000 ;; esac
}
sum() {                                                 # sum TARGET HOW: what was reached
    awk -F, -v t="$1" -v h="$2" -v w="$(wanted "$1" "$2")" '
        function thousands(n) { while (n >= 1000) { s = sprintf(",%03d", n % 1000) s; n = int(n / 1000) } return n s }
        $1 == t && $2 == h { n += $5; f += $7; p++; if (!first) first = $4; last = $4 }
        END { s = ""; a = thousands(n + 0); s = ""; b = thousands(w)
              printf "%s of %s executions, %d pieces, commits %s to %s, %d findings\n",
                     a, b, p, p ? first : "none", p ? last : "none", f }' $csv
}
left() { awk -F, -v t="$1" -v h="$2" -v w="$(wanted "$1" "$2")" '$1 == t && $2 == h { w -= $5 } END { print (w > 0 ? w : 0) }' $csv; }

piece() {                                               # piece HOW TARGET
    pi_left=$(left "$2" "$1")
    if [ "$pi_left" -eq 0 ]; then
        if [ -z "${MORE:-}" ]; then sum "$2" "$1"; return; fi
        pi_left=-1                                      # as many as there is time for
    fi
    guided "$2" "$1"
    seeds "$2"
    unpack "$2"
    mkdir -p "$out/corpus/$2"
    case $1 in optimised) pi_mute=2 ;; *) pi_mute=0 ;; esac    # what refuses says so: gigabytes, optimised; its inputs tell
    pi_log=$out/campaign-$1-$2.log pi_from=$(date +%s) pi_status=0
    FUZZ_SOME=1 "$out/$1-$2" -max_total_time="${CAMPAIGN_SECONDS:-300}" -runs="$pi_left" -timeout=120 -entropic=0 -rss_limit_mb=3000 \
        -max_len=4000 -print_final_stats=1 -close_fd_mask=$pi_mute -artifact_prefix="$out/campaign-$2-" \
        "$out/corpus/$2" "$out/seeds/$2" "$out/kept/$2" > "$pi_log" 2>&1 || pi_status=$?
    pi_runs=$(awk '/stat::number_of_executed_units/ { n = $2 } /^#[0-9]+/ { m = substr($1, 2) } END { print n ? n : m + 0 }' "$pi_log")
    echo "$2,$1,$(date +%Y-%m-%d),$(git rev-parse --short HEAD),$pi_runs,$(($(date +%s) - pi_from)),$((pi_status != 0))" >> $csv
    if [ $pi_status -ne 0 ]; then grep -vE '^#[0-9]+' "$pi_log" | tail -n 40; fi
    sum "$2" "$1"
    return $pi_status
}
keep() {                                                # keep TARGET: the fewest inputs, one a line in base64, shortest first
    guided "$1" optimised
    seeds "$1"
    unpack "$1"
    mkdir -p "$out/corpus/$1" tests/fuzz/kept
    rm -rf "$out/least/$1"
    mkdir -p "$out/least/$1"
    "$out/optimised-$1" -set_cover_merge=1 -timeout=120 -max_len=4000 "$out/least/$1" "$out/kept/$1" "$out/corpus/$1" \
        > "$out/keep-$1.log" 2>&1 || { tail -n 20 "$out/keep-$1.log"; return 1; }
    for ke in "$out/least/$1"/*; do base64 -w 0 "$ke"; echo; done | awk '{ print length($0), $0 }' | LC_ALL=C sort -k1n -k2 |
        cut -d ' ' -f 2- > "tests/fuzz/kept/$1"
    echo "$1: $(wc -l < "tests/fuzz/kept/$1") inputs kept, $(wc -c < "tests/fuzz/kept/$1") bytes"
}
case ${1:-} in
--keep) shift
    for t in ${*:-scene qp obj qps json blob}; do keep "$t"; done ;;
--table)
    for h in sanitized optimised forgotten; do for t in scene qp obj qps json blob; do echo "$t, $h: $(sum $t $h)"; done; done ;;
sanitized | optimised | forgotten)
    case ${2:-} in scene | qp | obj | qps | json | blob) piece "$1" "$2" ;; *) echo "no target is called ${2:-}"; exit 1 ;; esac ;;
*) sed -n '2,13s/^# \{0,1\}//p' "$0"; exit 64 ;;
esac
