# tally: counting for the scripts beside it; sourced, not run.
#
#     part NAME COMMAND...       run, show the output if it failed (and if it passed with SHOW=1; then $figure is its last line)
#     skip WHAT PACKAGE          could not be run here; a failure with STRICT=1. lack WHAT FOLDER: likewise, no package has it
#     spent                      sets $spent: seconds of processor that commands took so far; with TIMES=1 part and count tell theirs
#     total                      the closing line; the status is that of the whole script

passed=0 failed=0 skipped=''
tally_log=${TMPDIR:-/tmp}/stonepack-tally.$$
trap 'rm -f "$tally_log" "$tally_log.times"' EXIT

spent() {
    times > "$tally_log.times"                           # of this shell, then of what it has waited for
    spent=$(awk 'NR == 2 { split($1 $2, t, /[ms]/); printf "%.1f", 60 * (t[1] + t[3]) + t[2] + t[4] }' "$tally_log.times")
}
# Before a command, and after it: sets $took to what is told of it, nothing below a second.
begun() { if [ "${TIMES:-}" ]; then spent; since=$spent; fi; }
ended() {
    took=''
    if [ "${TIMES:-}" ]; then spent; took=$(awk -v a="$since" -v b="$spent" 'BEGIN { if (b - a >= 1) printf "  (%.0f s)", b - a }'); fi
}

part() {
    part_name=$1
    shift
    begun
    if "$@" > "$tally_log" 2>&1; then
        ended
        passed=$((passed + 1))
        echo "ok      $part_name$took"
        if [ -n "${SHOW:-}" ]; then
            sed 's/^/        /' "$tally_log"
            figure=$(grep -v '^ *$' "$tally_log" | tail -n 1)
        fi
    else
        failed=$((failed + 1))
        echo "FAILED  $part_name"
        tail -n 60 "$tally_log" | sed 's/^/        /'
    fi
}

# A command that ends with its own `N passed, N failed`: those numbers count.
count() {
    count_name=$1
    shift
    begun
    "$@" > "$tally_log" 2>&1
    count_status=$?
    ended
    count_line=$(sed -n '$p' "$tally_log")
    count_p=$(echo "$count_line" | sed -n 's/^\([0-9]*\) passed, [0-9]* failed$/\1/p')
    count_f=$(echo "$count_line" | sed -n 's/^[0-9]* passed, \([0-9]*\) failed$/\1/p')
    if [ -z "$count_p" ]; then count_p=0 count_f=1; fi
    if [ $count_status -ne 0 ] && [ "$count_f" -eq 0 ]; then count_f=1; fi
    passed=$((passed + count_p)) failed=$((failed + count_f))
    if [ "$count_f" -eq 0 ]; then
        echo "ok      $count_name: $count_p passed$took"
    else
        echo "FAILED  $count_name"
        tail -n 60 "$tally_log" | sed 's/^/        /'
    fi
}

lack() {
    skipped="$skipped
skipped: $1 (no $2)"
    if [ "${STRICT:-0}" = 1 ]; then failed=$((failed + 1)); fi
}

skip() {
    skipped="$skipped
skipped: $1 (apt-get install $2)"
    if [ "${STRICT:-0}" = 1 ]; then failed=$((failed + 1)); fi
}

have() { command -v "$1" > /dev/null 2>&1; }

total() {
    if [ -n "$skipped" ]; then echo "${skipped#?}"; fi
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}
