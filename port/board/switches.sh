#!/bin/sh
# switches: the table of switches, made from port/board/footprint.csv: in stonepack.h as a comment, in solvers/README.md as a table.
#
#     sh port/board/switches.sh               prints both
#     sh port/board/switches.sh --write       puts them where they belong, each between its first and last line
#     sh port/board/switches.sh --check       are they the ones that stand there?
set -eu
cd "$(dirname "$0")/../.."
mkdir -p build
table() {                                               # table comment|page
    awk -F , -v as="$1" '
        { key = $0; sub(/,[0-9]+,[0-9]+$/, "", key); gsub(/"/, "", key); m7[key] = $(NF - 1); m4f[key] = $NF }
        function saved(name, row, lost,    a, b) {
            if (!(row in m7)) { print "switches: no row " row > "/dev/stderr"; bad = 1 }
            a = m7["text: all"] - m7[row]
            b = m4f["text: all"] - m4f[row]
            if (as == "comment") { printf " *   %-17s %-78s %6d  %6d\n", name, lost, a, b; return }
            gsub(/(sp|SP)_[A-Za-z_]+(\.[a-z.]+)?|settings\.[a-z.]+/, "`&`", lost)
            printf "| `%s` | %s | %.1f | %.1f |\n", name, lost, a / 1024, b / 1024
        }
        function alone(name, lost) { saved(name, "text: " name, lost) }
        END {
            if (as == "comment") {
                printf "/* Switches: what is lost, and the code saved of %d bytes on a Cortex-M7, of %d on an M4F in float.\n", m7["text: all"], m4f["text: all"]
                print " *"
            } else {
                printf "| switch | what is lost | kB saved of %.1f on M7, double | of %.1f on M4F, float |\n", m7["text: all"] / 1024, m4f["text: all"] / 1024
                print "|---|---|--:|--:|"
            }
            alone("SP_NO_IPM", "interior points, sp_limit and its calls, sp_joint_moves")
            alone("SP_NO_PLAN", "sp_plan; planar and level scenes in 3 rows a block, SP_EFFECT_DEPTH left out")
            alone("SP_NO_CRA", "the coupled check: settings.coupled.asked")
            alone("SP_NO_STRONG", "sp_strong: what friction holds whatever it does")
            alone("SP_NO_SLIDING", "sp_sliding: limits without dilatancy")
            alone("SP_NO_ADMM", "the preset of the seed, SP_STAGE_ADMM, settings.coupled.rounds")
            alone("SP_NO_DYKSTRA", "sp_qp_dykstra")
            alone("SP_NO_QP", "all quadratic programs; with SP_NO_ADMM, SP_NO_DYKSTRA")
            alone("SP_QP_NO_CG", "SP_QP_CG, the back end without a matrix")
            alone("SP_QP_NO_POLISH", "sp_qp_settings.polish: the last digits, sharper certificates")
            alone("SP_QP_NO_INTERIOR", "interior points for quadratic programs: SP_QP_INTERIOR, sp_qp_interior")
            alone("SP_QP_ONLY", "all that knows of stones")
            saved("SP_SMALL", "text: everything, SP_SMALL", "all but the smallest form; with SP_NO_CRA; no CG, polish, interior points")
            alone("SP_EXACT_ONLY", "as SP_SMALL, and sp_sequence; with SP_NO_QP, SP_NO_IPM, SP_NO_PLAN")
            if (as == "comment") {
                print " *"
                print " * Calls left out are not declared; settings that ask for what is left out are SP_E_UNSUPPORTED. Any may be combined, but"
                print " * two contradictions stop at an #error: SP_QP_ONLY with SP_NO_QP or SP_EXACT_ONLY; more than one of SP_REAL_MIXED,"
                print " * SP_REAL_FLOAT, SP_REAL_QUAD. */"
            }
            exit bad
        }' port/board/footprint.csv
}
# Each place: its file, what it holds, its first and its last line.
places() {
    printf '%s\t%s\t%s\t%s\n' \
        stonepack.h comment '^\/\* Switches: what is lost' '^ \* SP_REAL_FLOAT, SP_REAL_QUAD\. \*\/$' \
        solvers/README.md page '^| switch | what is lost' '^| `SP_EXACT_ONLY`'
}
write() {                                               # write FILE AS FIRST LAST
    table "$2" > build/switches.txt
    sed -e "/$4/r build/switches.txt" -e "/$3/,/$4/d" "$1" > build/switches.new
    cmp -s build/switches.new "$1" || cp build/switches.new "$1"
}
same() { table "$2" > build/switches.txt; sed -n "/$3/,/$4/p" "$1" | diff - build/switches.txt; }
each() {                                                # each COMMAND
    places | { status=0; while IFS='	' read -r file as first last; do "$1" "$file" "$as" "$first" "$last" || status=1; done; exit $status; }
}
case ${1:-} in
--write) each write ;;
--check) each same ;;
*) table comment; table page ;;
esac
