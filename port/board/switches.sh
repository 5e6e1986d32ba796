#!/bin/sh
# switches: the table of switches at the end of stonepack.h, made from port/board/footprint.csv.
#
#     sh port/board/switches.sh               prints it
#     sh port/board/switches.sh --write       puts it into stonepack.h, between its first and last line
#     sh port/board/switches.sh --check       is it the one that stands there?
set -eu
cd "$(dirname "$0")/../.."
table() {
    awk -F , '
        { key = $0; sub(/,[0-9]+,[0-9]+$/, "", key); gsub(/"/, "", key); m7[key] = $(NF - 1); m4f[key] = $NF }
        function saved(name, row, lost) {
            if (!(row in m7)) { print "switches: no row " row > "/dev/stderr"; bad = 1 }
            printf " *   %-15s   %-78s %6d  %6d\n", name, lost, m7["text: all"] - m7[row], m4f["text: all"] - m4f[row]
        }
        function alone(name, lost) { saved(name, "text: " name, lost) }
        END {
            printf "/* Switches: what is lost, and the code saved of %d bytes on a Cortex-M7, of %d on an M4F in float.\n", m7["text: all"], m4f["text: all"]
            print " *"
            alone("SP_NO_IPM", "interior points, sp_limit and its calls, sp_joint_moves")
            alone("SP_NO_PLAN", "sp_plan; planar and level scenes in 3 rows a block, SP_EFFECT_DEPTH left out")
            alone("SP_NO_CRA", "the coupled check: settings.coupled.asked")
            alone("SP_NO_ADMM", "the preset of the seed, SP_STAGE_ADMM, settings.coupled.rounds")
            alone("SP_NO_DYKSTRA", "sp_qp_dykstra")
            alone("SP_NO_QP", "all quadratic programs; SP_NO_ADMM, SP_NO_DYKSTRA with them")
            alone("SP_QP_NO_CG", "SP_QP_CG, the back end without a matrix")
            alone("SP_QP_NO_POLISH", "sp_qp_settings.polish: the last digits, sharper certificates")
            alone("SP_QP_ONLY", "all that knows of stones")
            saved("SP_SMALL", "text: everything, SP_SMALL", "what is said above; SP_NO_CRA, SP_QP_NO_CG, SP_QP_NO_POLISH with it")
            alone("SP_EXACT_ONLY", "of SP_SMALL sp_sequence, SP_NO_QP, SP_NO_IPM, SP_NO_PLAN")
            print " *"
            print " * Calls left out are not declared; settings that ask for what is left out are SP_E_UNSUPPORTED. Two stop at an #error:"
            print " * SP_QP_ONLY with SP_NO_QP or SP_EXACT_ONLY, SP_REAL_MIXED with SP_REAL_FLOAT or SP_REAL_QUAD, these two. All others go together. */"
            exit bad
        }' port/board/footprint.csv
}
first='^\/\* Switches: what is lost'
last='All others go together\. \*\/$'
case ${1:-} in
--write)
    table > build/switches.txt
    sed -e "/$last/r build/switches.txt" -e "/$first/,/$last/d" stonepack.h > build/switches.h
    cmp -s build/switches.h stonepack.h || cp build/switches.h stonepack.h ;;
--check) table > build/switches.txt; sed -n "/$first/,/$last/p" stonepack.h | diff - build/switches.txt ;;
*) table ;;
esac
