#!/bin/sh
# footprint: what the library takes on a Cortex-M7 in double and on a Cortex-M4F in float, as CSV; built with -Os.
#
#     sh port/board/footprint.sh > port/board/footprint.csv      (make footprint)
#     sh port/board/footprint.sh --compare [whole]               is a row more than 2 % off the committed one, or gone, or new?
#                                                                Whole: of builds that one switch leaves a part out of, too
#
#     text       bytes of code and constants: of all, of builds that leave parts out, of what a linker takes for a few calls
#                (ld --gc-sections) out of the build before it, of each part: the functions of its file, those merged into
#                callers counted there
#     data       bytes of .data and .bss
#     stack      the deepest of a public call: bound, along any chain of calls [stack.awk]; painted, in all checks below
#     arena      bytes that the scene and its check take
#     1000 insn  thousands of instructions of sp_check, counted by QEMU
cd "$(dirname "$0")/../.." || exit 1
out=build/footprint
table=port/board/footprint.csv
mkdir -p $out
alone='SP_NO_QP SP_NO_CRA SP_NO_STRONG SP_NO_SLIDING SP_NO_IPM SP_NO_PLAN SP_NO_ADMM SP_NO_DYKSTRA SP_QP_NO_CG SP_QP_NO_POLISH SP_QP_NO_INTERIOR'
flags='-std=c99 -Os -ffp-contract=off -fno-math-errno -mthumb -mfloat-abi=hard -ffunction-sections -fdata-sections'
m7='-mcpu=cortex-m7 -mfpu=fpv5-d16'
m4f='-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -DSP_REAL_FLOAT'

compiler() { arm-none-eabi-gcc -dumpfullversion; }

# A change of more than 2 % of a row, rows that only one of the tables has, calls that may take more than 1024 bytes of stack,
# and smallest builds of more text than they may have.
compare() {
    awk -F '\t' -v left="$left" '
        function off(name, was, is,   d) {
            d = is > was ? is - was : was - is
            if (d <= 0.02 * was && (was == "") == (is == "")) return
            printf "%s: was %s, is %s\n", name, was == "" ? "nothing" : was, is == "" ? "nothing" : is
            bad = 1
        }
        { gsub(/"/, ""); n = split($0, f, ","); key = f[1]; for (k = 2; k < n - 1; k++) key = key "," f[k] }
        FNR == 1 { next }
        NR == FNR { m7[key] = f[n - 1]; m4f[key] = f[n]; next }
        !(key in m7) { print "new row: " key; bad = 1; next }
        { off(key " (M7)", m7[key], f[n - 1]); off(key " (M4F)", m4f[key], f[n]); seen[key] = 1 }
        /^stack, bound/ {
            for (k = n - 1; k <= n; k++) if (f[k] + 0 > 1024) { print key ": more than 1024"; bad = 1 }
        }
        /smallest check/ {                              # what fits where: 16 kB with interfaces given, 24 with contacts found
            most = /given/ ? 16384 : 24576
            for (k = n - 1; k <= n; k++) if (f[k] + 0 > most) { print key ": more than " most; bad = 1 }
        }
        /linked: quadratic programs/ {                  # dense and sparse; no conjugate gradients, polish, interior points
            for (k = n - 1; k <= n; k++) if (f[k] + 0 > 12288) { print key ": more than 12288"; bad = 1 }
        }
        /everything, SP_SMALL/ {                        # every public call in its smallest form
            for (k = n - 1; k <= n; k++) if (f[k] + 0 > 49152) { print key ": more than 49152"; bad = 1 }
        }
        /painted/ { for (k = n - 1; k <= n; k++) if (f[k] + 0 > bound[k]) { print key ": more than its bound"; bad = 1 } }
        /bound: sp_check/ { for (k = n - 1; k <= n; k++) bound[k] = f[k] + 0 }
        END {
            n = split(left, f, " ")
            for (k = 1; k <= n; k++) seen["text: " f[k]]        # not measured today
            for (key in m7) if (!(key in seen)) { print "row gone: " key; bad = 1 }
            if (bad) print "if it is meant to be so: make footprint"
            exit bad
        }' $table $out/now.csv
}

row() { printf '"%s",%s,%s\n' "$1" "$2" "$3"; }         # row WHAT M7 M4F

compile() {                                             # compile OUTPUT FLAGS...
    c_out=$1
    shift
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $flags "$@" -c stonepack.c -o $out/"$c_out".o || exit 1
}
both() {                                                # both FLAGS...: m7.o and m4f.o
    # shellcheck disable=SC2086
    { compile m7 $m7 "$@" & compile m4f $m4f "$@"; wait $!; } || exit 1
}
text() { arm-none-eabi-size $out/"$1".o | awk 'NR == 2 { print $1 }'; }
data() { arm-none-eabi-size $out/"$1".o | awk 'NR == 2 { print $2 + $3 }'; }
build() {                                               # build WHAT FLAGS...
    b_what=$1
    shift
    both "$@"
    row "text: $b_what" "$(text m7)" "$(text m4f)"
}
linked() {                                              # linked WHAT CALLS...: of the last build
    l_what=$1
    shift
    for l_on in m7 m4f; do
        # shellcheck disable=SC2046
        arm-none-eabi-ld -r --gc-sections $(printf -- '-u %s ' "$@") $out/$l_on.o -o $out/$l_on-linked.o || exit 1
    done
    row "text, linked: $l_what" "$(text m7-linked)" "$(text m4f-linked)"
}
pairs() { awk -v kind="$1" -v at=$out/m7.txt '           # m7.txt and m4f.txt, "name<tab>number" each, side by side
    BEGIN { FS = "\t"; while ((getline line < at) > 0) { split(line, f, "\t"); m7[f[1]] = f[2]; name[++n] = f[1] } }
    { m4f[$1] = $2 }
    END { for (k = 1; k <= n; k++) printf "\"%s: %s\",%s,%s\n", kind, name[k], m7[name[k]], m4f[name[k]] }' $out/m4f.txt; }

parts() {
    for p_on in m7 m4f; do
        arm-none-eabi-nm -S -l $out/$p_on.o | awk '
            BEGIN { for (i = 0; i < 16; i++) hex[substr("0123456789abcdef", i + 1, 1)] = i }
            NF > 4 && $3 ~ /[tTrR]/ { n = 0; for (i = 1; i <= length($2); i++) n = 16 * n + hex[substr($2, i, 1)]
                                      f = $NF; sub(/:[0-9]*$/, "", f); sub(/.*\//, "", f); size[f] += n }
            END { for (f in size) print f "\t" size[f] }' | LC_ALL=C sort > $out/$p_on.txt
    done
    pairs 'text, part'
}
stacks() {
    for s_on in m7 m4f; do
        awk -f port/board/stack.awk $out/$s_on.ci > $out/$s_on.stack || { cat $out/$s_on.stack >&2; exit 1; }
        awk '{ print $1 "\t" $2 }' $out/$s_on.stack > $out/$s_on.txt
    done
    awk '$2 >= 256' $out/m7.txt > $out/deep.txt && mv $out/deep.txt $out/m7.txt
    pairs 'stack, bound'
}

# What port/board/cost.c prints on a board, as "name<tab>number".
cost() {                                                # cost BOARD REAL
    make --no-print-directory -s -f port/board/board.mk BOARD="$1" REAL="$2" OPT=-Os out=$out/"$1" cost > $out/"$1".cost || {
        cat $out/"$1".cost >&2; exit 1; }
}
costs() {                                               # costs KIND AWK-PROGRAM
    for k_on in m7 m4f; do
        awk 'NR > 1 { scene = substr($0, 1, 20); sub(/ *$/, "", scene); stage = substr($0, 22, 14); sub(/ *$/, "", stage) }
            NR > 1 '"$2" $out/$k_on.cost > $out/$k_on.txt
    done
    pairs "$1"
}

all() {
    echo "\"bytes, -Os, arm-none-eabi-gcc $(compiler)\",M7 double,M4F float"
    build SP_QP_ONLY -DSP_QP_ONLY
    build 'SP_QP_ONLY, no Dykstra, CG, polish, interior points' -DSP_QP_ONLY -DSP_NO_DYKSTRA -DSP_QP_NO_CG -DSP_QP_NO_POLISH -DSP_QP_NO_INTERIOR
    linked 'quadratic programs' sp_qp_default sp_qp_memory sp_qp_solve
    build 'SP_NO_QP, SP_NO_CRA, SP_NO_IPM, SP_NO_PLAN' -DSP_NO_QP -DSP_NO_CRA -DSP_NO_IPM -DSP_NO_PLAN
    linked 'check, interfaces given' sp_scene_create sp_scene_body sp_scene_joint sp_check sp_verify
    linked 'check, contacts found' sp_scene_create sp_scene_block sp_contacts_find sp_check sp_verify
    build SP_EXACT_ONLY -DSP_EXACT_ONLY
    linked 'smallest check, interfaces given' sp_scene_create sp_scene_body sp_scene_joint sp_check sp_verify
    linked 'smallest check, contacts found' sp_scene_create sp_scene_block sp_contacts_find sp_check sp_verify
    linked 'smallest verification, interfaces given' sp_scene_create sp_scene_body sp_scene_joint sp_verify
    for a_switch in $alone; do build $a_switch -D$a_switch; done
    build 'everything, SP_SMALL' -DSP_SMALL
    both -g -fcallgraph-info=su
    row 'text: all' "$(text m7)" "$(text m4f)"
    row 'data: all' "$(data m7)" "$(data m4f)"
    parts
    stacks
    cost m7 double
    cost m4f float
    costs 'stack, painted' '&& $NF > most { most = $NF } END { print "sp_check\t" most }'
    costs 'arena, scene' '&& scene !~ /,/ && !(scene in seen) { seen[scene]; print scene "\t" $(NF - 2) }'
    costs 'arena, check' '&& scene !~ /,/ && !((scene, stage) in seen) {
        seen[scene, stage]
        print scene ", " stage "\t" $(NF - 1) }'
    costs '1000 insn' '{
        tol = stage == "exact" ? ", tol " $(NF - 5) : ""
        print scene ", " stage tol ": " $(NF - 4) "\t" $(NF - 3) }'
}

case ${1:-} in
--compare)
    if ! grep -q "gcc $(compiler)\"" $table; then echo "another compiler than the table's: $(compiler)"; exit 0; fi
    left=''
    if [ "${2:-}" != whole ]; then left=$alone alone=''; fi
    all > $out/now.csv && compare ;;
*) all ;;
esac
