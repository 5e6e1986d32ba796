#!/bin/sh
# floors: the parts of solvers/ stand on one another as solvers/README.md says.
#
#     sh tests/checks/floors.sh [LINES]                 LINES: the longest file there may be, default 700
#
#   1. a folder includes only itself and folders earlier in the list; proof/ nothing of a search; statics/ and seed/ nothing of proof/
#   2. who stands above proof/ calls it through the names listed here
#   3. no include stands inside a condition, but those of the spine under one for all that knows of stones
#   4. every part compiles alone, in double and in float
#   5. no private name is defined twice, but where a precision or the smallest build takes another way
#   6. no file is longer than LINES
#   7. no line of the core is wider than 128 columns
#   8. no switch stands inside a body: there is one of two rooms, or an expression; of precisions a few
#   9. a test that is written is run
. tests/checks/tally.sh
most=${1:-700}
floors='base linear qp geometry cone scene contacts proof statics seed coupled check small limit strong sliding sequence memory'

# What proof/ offers to those above: making a certificate check, asking it, what its answers are measured by.
offered='sp__certifier sp__scale sp__certifier_need sp__certifier_carve sp__certifier_open sp__certifier_begin sp__certifier_scales
 sp__certifier_cone sp__certifier_load sp__certifier_force_cap sp__certify_forces sp__certify_mechanism sp__certify_motion sp__certify_rank
 sp__certify_rest sp__certifier_make_admissible sp__certify_coupled sp__certifier_remove_spin sp__certify_refutation sp__certify_pressure sp__certify_moving sp__certify_sliding sp__certify_shear sp__certify_even sp__shear_need sp__shear_open SP__SLIDES SP__MOVES sp__certify_still sp__still_need sp__still_delta sp__still_row sp__still_sign sp__still_children
 SP__STILL_FORCE SP__STILL_RUB SP__STILL_ENDS SP__STILL_CONE SP__STILL_NEAR SP__STILL_ROWS SP__STILL_DEPTH SP__STILL_DEEP SP__STILL_POINTS sp__motion_write
 sp__motion_read sp__lengths sp__coupled_lengths sp__refute sp__refute_need sp__budget_sweeps SP__FLOPS_CERTIFICATE
 SP__COUPLED_TOL SP__GIVE SP__SLIP SP__PROOF_DEPTH'

# Quoted includes of the parts, as `folder/part.c folder/part.c`.
includes() {
    for part in solvers/*/*.c; do
        sed -n 's/^#[ ]*include[ ]*"\([^"]*\)".*/\1/p' "$part" | while read -r name; do
            folder=$(basename "$(dirname "$part")")
            case $name in
            ../../*) ;;
            ../*) echo "$folder/$(basename "$part") ${name#../}" ;;
            *) echo "$folder/$(basename "$part") $folder/$name" ;;
            esac
        done
    done
}
downward() {
    includes | awk -v floors="$floors" '
        BEGIN { n = split(floors, f, " "); for (k = 1; k <= n; k++) level[f[k]] = k }
        { split($1, a, "/"); split($2, b, "/"); from = a[1]; to = b[1] }
        !(from in level) || !(to in level) { print $1 " includes " $2 ": no floor of that name"; bad = 1; next }
        level[to] > level[from] { print $1 " includes " $2 ", which comes later"; bad = 1 }
        from == "proof" && to !~ /^(base|linear|cone|scene|proof)$/ { print $1 " includes " $2 ": proof/ knows base, linear, cone and scene only"; bad = 1 }
        from ~ /^(statics|seed)$/ && to == "proof" { print $1 " includes " $2 ": no search knows what judges it"; bad = 1 }
        END { exit bad }'
}
# Names of a part: what begins at the left edge or ends a typedef.
names() {
    awk '
        FNR == 1 { inside = 0 }
        /^#define (SP|sp)__/ { sub(/\(.*/, "", $2); print $2, FILENAME; next }
        /^(SP__[A-Z_]+ )?(static|SP_API) / && /\(/ { s = $0; sub(/\(.*/, "", s); n = split(s, w, /[ *]+/); if (w[n] ~ /^sp_/) print w[n], FILENAME; next }
        /^(typedef )?(struct|enum) sp__[a-z_0-9]+ \{/ { s = $0; sub(/^typedef /, "", s); split(s, w, " "); print w[2], FILENAME; next }
        /^static const/ { s = $0; sub(/[\[=].*/, "", s); n = split(s, w, /[ *]+/); if (w[n] == "") n--; print w[n], FILENAME }
    ' "$@"
}
through() {
    names solvers/proof/*.c | awk -v offered="$offered" '
        BEGIN { n = split(offered, o, /[ \n]+/); for (k = 1; k <= n; k++) ok[o[k]] = 1 }
        FILENAME == "-" { if (!($1 in ok)) hidden[$1] = $2; next }
        { line = $0
          gsub(/"([^"\\]|\\.)*"/, "", line)
          if (line ~ /^ \*/ || line ~ /^\/\*/) next
          sub(/\/\*.*/, "", line)
          while (match(line, /(sp|SP)__[A-Za-z_0-9]+/)) {
              name = substr(line, RSTART, RLENGTH)
              line = substr(line, RSTART + RLENGTH)
              if (name in hidden) { print FILENAME " uses " name " of " hidden[name] ", which proof/ does not offer"; bad = 1 }
          } }
        END { exit bad }' - solvers/coupled/*.c solvers/check/*.c solvers/limit/*.c solvers/strong/*.c solvers/sliding/*.c solvers/sequence/*.c solvers/small/*.c solvers/memory/*.c
}
unconditional() {
    awk '
        FNR == 1 { depth = 0; guard = 0; where = "" }
        /^#[ ]*if/ { depth++; if (depth == 1 && FILENAME != "stonepack.c" && !guard) { guard = 1; depth = 0 } else if (depth == 1) where = $0 }
        /^#[ ]*endif/ { if (depth > 0) depth-- }
        /^#[ ]*include[ ]*"/ && depth > 0 && !(FILENAME == "stonepack.c" && depth == 1 && where == "#ifndef SP_QP_ONLY") {
            print FILENAME ":" FNR ": an include inside a condition"; bad = 1 }
        END { exit bad }' stonepack.c solvers/*/*.c
}
alone() {                                               # alone FLAGS...
    for part in solvers/*/*.c; do
        ${CC:-gcc} -std=c99 -fsyntax-only -Werror=implicit-function-declaration "$@" "$part" || { echo "$part does not compile alone"; return 1; }
    done
}
once() {
    names solvers/*/*.c | sort -u | awk '
        { split($2, p, "/"); if (p[2] == "small" || $2 ~ /(small_[a-z]+|convex|envelope)\.c$/) next; if ($1 in at && at[$1] != $2) { print $1 " is defined in " at[$1] " and in " $2; bad = 1 } at[$1] = $2 }
        END { exit bad }'
}
short() { wc -l stonepack.c solvers/*/*.c | awk -v most="$most" '$2 != "total" && $1 > most { print $2 " has " $1 " lines"; bad = 1 } END { exit bad }'; }

narrow() {
    awk 'length($0) > 128 { print FILENAME ":" FNR ": " length($0) " columns"; bad = 1 } END { exit bad }' stonepack.[ch] solvers/*/*.c
}

# A body opens with a brace at the left edge and closes with one. SP_REAL_*: precision.
bodies() {
    awk -v most="$1" '
        FNR == 1 { body = 0 }
        /^\{/ { body = 1 }
        /^\}/ { body = 0 }
        /^#[ ]*(if|elif)/ && !/SP_REAL_/ && body { print FILENAME ":" FNR ": " $0; n++ }
        END { print n + 0 " conditionals inside bodies, at most " most + 0; exit n > most }' stonepack.c solvers/*/*.c
}

run() {
    awk '
        /^ *TEST\(/ { name = $0; sub(/.*TEST\(/, "", name); sub(/\).*/, "", name); written[FILENAME ": " name] }
        /^ *RUN[A-Z_]*\(/ { name = $0; sub(/.*RUN[A-Z_]*\(/, "", name); sub(/\).*/, "", name); listed[FILENAME ": " name] }
        END { for (k in written) if (!(k in listed)) { print k " is in no TEST_LIST"; bad = 1 } exit bad }' tests/*/test_*.c
}

part "floors: folders include only what stands below" downward
part "floors: proof/ is asked through what it offers" through
part "floors: no include inside a condition" unconditional
part "floors: every part compiles alone" alone
part "floors: every part compiles alone, float" alone -DSP_REAL_FLOAT
part "floors: no private name twice" once
part "floors: no file over $most lines" short
part "floors: no line over 128 columns" narrow
part "floors: no switch inside a body" bodies 0
part "floors: every test that is written is run" run
total
