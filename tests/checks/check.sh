#!/bin/sh
# check: everything this machine can test but what `make test` does. Ends with the seconds of every group, what could not be
# run, and `N passed, N failed`.
#
#     STRICT=1     what could not be run counts as a failure
#     EVERY=1      builds that leave parts out meet every suite, not the quick ones that check; pairs of switches are compiled from
#                  pair and package, too; every assembly is asked in weaker forms and written otherwise, not every tenth; by night
#     ONLY=text    only groups whose names contain the text
#
# The groups run side by side, one per core, each as a process of its own with ONLY; what they print comes in their order.
. tests/checks/tally.sh
TIMES=1
groups='long warnings switches combinations cpp symbols arm robot footprint pair package python sanitizers settle bits instruments plugins static cases oracle bench demo page fuzz mutants coverage windows'
if ! echo "$groups" | tr ' ' '\n' | grep -qF -- "${ONLY:-}"; then
    echo "no group of check is called $ONLY; there are $groups"
    exit 1
fi
if [ "${1:-}" = --asked ]; then exit 0; fi                  # make asks before it builds anything
longest='switches sanitizers instruments long pair combinations oracle cases'  # these begin first
out=build/check${ONLY:+/$ONLY}
mkdir -p $out
CC=${CC:-gcc}

base='-std=c99 -pedantic-errors -ffp-contract=off -fno-math-errno -Wall -Wextra -Wconversion -Wsign-conversion
 -Wdouble-promotion -Wshadow -Wvla -Wcast-align -Wcast-qual -Wfloat-equal -Wundef -Wstrict-prototypes -Wmissing-prototypes
 -Wswitch-enum -Wpointer-arith -Wwrite-strings -Werror'
gcc_only='-Wfloat-conversion -Wlogical-op -Wduplicated-cond -Wjump-misses-init'
host='-std=c99 -pedantic-errors -ffp-contract=off -fno-math-errno -Wall -Wextra -Wshadow -Wvla -Wstrict-prototypes -Wpointer-arith
 -Wwrite-strings -Werror'
all=$(ls tests/*/test_*.c | sed 's|.*/test_\(.*\)\.c|\1|' | tr '\n' ' ')
core=$(ls tests/*/test_*.c | grep -v tests/host/ | sed 's|.*/test_\(.*\)\.c|\1|')      # these need no program
slow='attack|bracket|budget|coupled|exact|hard|invariants|islands|large|limit|memory|place|plan|sequence|spared|spent|strength|strong'
quick=$(echo "$core" | grep -vxE "$slow|settle")        # a third of the time of all
wings() { for wi in "$@"; do ls tests/"$wi"/test_*.c; done | sed 's|.*/test_\(.*\)\.c|\1|'; }        # wings FOLDER...: their suites
apart='base geometry cone linear proof contacts scene'  # these stand by themselves, whatever is left out of the rest
# shellcheck disable=SC2086
if [ "${EVERY:-}" ]; then wide=$core deep=$core some=1
else wide=$(echo "$quick" | grep -vxF "$(wings $apart)") deep=$quick some=10; fi
stems() { for st in "$@"; do printf 'X(%s) ' "$st"; done; }
suite_c() { for sc in "$@"; do ls tests/*/test_"$sc".c; done | tr '\n' ' '; }
host_c="$(ls port/host/*.c port/host/*/*.c | grep -v /main.c | tr '\n' ' ') tests/scenes/gen.c"
plain='-std=c99 -ffp-contract=off -fno-math-errno -Wno-unused-function'

# clang compiles tests in half of gcc's time, those that a sanitizer watches in a third. The library is CC's, if nothing watches it.
quickest() { if have clang; then echo clang; else echo "$CC"; fi; }

# The tests of some suites: the library optimised as told, or an object that is there; what stands on it not at all.
tests_of() {                                            # tests_of "STEMS" LIBRARY "OPTIMISATION" COMPILER FLAGS...
    to_stems=$1 to_object=$2 to_opt=$3 to_cc=$4
    shift 4
    case " $to_stems " in *obj*|*worker*|*plugins*) to_more=$host_c ;; *) to_more=tests/scenes/gen.c ;; esac
    case " $* " in *SP_QP_ONLY*) to_more='' ;; esac
    case $to_object in
    *.c)
        # shellcheck disable=SC2086
        $to_cc $plain $to_opt "$@" -c "$to_object" -o $out/library.o || return 1
        to_object=$out/library.o ;;
    esac
    # shellcheck disable=SC2086,SC2046
    $(quickest) $plain -O0 "$@" -DTEST_SUITES="$(stems $to_stems)" tests/run.c $(suite_c $to_stems) $to_more "$to_object" -lm \
        -o $out/run && $out/run
}
cli_build() {                                           # cli_build COMPILER OUTPUT FLAGS...
    cb_cc=$1 cb_out=$2
    shift 2
    # shellcheck disable=SC2086
    $cb_cc -std=c99 -ffp-contract=off -fno-math-errno "$@" port/host/main.c $host_c stonepack.c -lm -o "$cb_out"
}

# ---------------------------------------------------------------------------------------------------------- warnings
warn() {                                                # the objects that come of it are looked at, too
    for w_real in '' -DSP_REAL_FLOAT -DSP_REAL_MIXED; do
        for w_opt in -O0 -O2; do
            # shellcheck disable=SC2086
            gcc $base $gcc_only $w_real $w_opt -c stonepack.c -o $out/warn.o && symbols $out/warn.o '' || return 1
        done
    done
}
warn_clang() {                                          # its warnings come from the text alone
    for w_real in '' -DSP_REAL_FLOAT -DSP_REAL_MIXED; do
        # shellcheck disable=SC2086
        clang $base $w_real -fsyntax-only stonepack.c || return 1
    done
}
warn_host() {                                           # warn_host "FILES" COMPILER PRECISION FLAGS...
    wh_files=$1 wh_cc=$2 wh_real=$3
    shift 3
    for w_file in $wh_files; do
        # shellcheck disable=SC2086
        "$wh_cc" $host ${wh_real:+"$wh_real"} -Wno-unused-function -DTEST_SUITES="$(stems $all)" "$@" "$w_file" || return 1
    done
}
# Parts that can be left out: nothing of them stays behind, and the tests of all others pass without the program.
left_out() { echo "$out/left_out$(printf %s "$*" | tr -c 'A-Z_' -).o"; }               # left_out FLAGS...: the library without
without() {                                             # without GONE-REGEX FLAGS...
    wo_gone=$1
    shift
    wo_object=$(left_out "$@")
    # shellcheck disable=SC2086
    $CC $base "$@" -Os -c stonepack.c -o "$wo_object" && symbols "$wo_object" '' || return 1
    ! nm "$wo_object" | grep -E "$wo_gone"
}
tests_without() {                                       # tests_without "SUITES" FLAGS...: on what `without` made, if it did
    tw_suites=$1
    shift
    tw_library=$(left_out "$@")
    if [ ! -f "$tw_library" ]; then tw_library=stonepack.c; fi
    tests_of "$tw_suites" "$tw_library" -O1 "$CC" "$@"
}
check_switches() {
    rm -f $out/left_out*
    no_qp=$(echo "$wide" | grep -vxE 'qp|proximal|cg|ldl|ruiz')
    no_ipm=$(echo "$wide" | grep -vxE 'limit|bracket|sliding')
    no_plan=$(echo "$wide" | grep -vxE 'plan|map|spared')
    part "SP_QP_ONLY: nothing of a stone left" without 'sp__?(scene|check|problem|dual|certificate|certify|matrix|seed|cone|support)' -DSP_QP_ONLY
    part "SP_NO_QP: no quadratic programs left" without 'sp_qp|sp__(qp|admm|program|dykstra|ldl|ruiz)' -DSP_NO_QP
    part "SP_NO_ADMM: no stage left" without 'sp__(admm_|program)|sp_settings_seed' -DSP_NO_ADMM
    part "SP_NO_DYKSTRA: no projections left" without 'dykstra' -DSP_NO_DYKSTRA
    part "SP_QP_NO_INTERIOR: no interior points left" without 'sp_qp_interior|sp__(proximal_|side_)' -DSP_QP_NO_INTERIOR
    part "SP_NO_IPM: no interior points, no limit left" without 'sp__(ipm|soc|ray_step|bchol_.*balance|bracket|limit|strong_|interior_|engine)|sp_limit|sp_joint_moves' -DSP_NO_IPM
    part "SP_NO_PLAN: no plan, no smaller search left" without 'sp_plan|sp__(plan_(flat|whole|reduces)|flat|check_flat)' -DSP_NO_PLAN
    part "SP_NO_CRA: no coupled check left" without 'sp__(cra|coupled)' -DSP_NO_CRA
    part "SP_NO_STRONG: no motion of strong verdicts left" without 'sp__(holds|starts|sweep|inertia|certify_moving)|sp_strong' -DSP_NO_STRONG
    part "SP_NO_SLIDING: no simplex, no history left" without 'sp__(simplex|band|slab|push|descend|sliding|slide|certify_sliding)|sp_sliding' -DSP_NO_SLIDING
    part "SP_SMALL: no engine but the smallest left" without 'sp__(polish|penalty|rigid|dense|sparse|yield|admm_|ipm|cra|flat|dual|newton|bchol|island|gates|auglag|proximal_|cg|ldl)' \
        -DSP_SMALL
    part "SP_EXACT_ONLY: no other stage left" without \
        'sp_sequence|sp__(polish|penalty|rigid|dense|sparse|yield|chol_|admm|ipm|cra|flat|dual|newton|bchol|order|island|gates)' \
        -DSP_EXACT_ONLY
    part "SP_NO_QP, SP_NO_CRA: both gone" without 'sp_qp|sp__(qp|cra)' -DSP_NO_QP -DSP_NO_CRA
    for sw in '-DSP_QP_ONLY -DSP_QP_NO_CG' '-DSP_QP_ONLY -DSP_QP_NO_POLISH' -DSP_QP_NO_INTERIOR \
        '-DSP_QP_ONLY -DSP_QP_NO_CG -DSP_QP_NO_POLISH' '-DSP_QP_ONLY -DSP_QP_NO_CG -DSP_QP_NO_POLISH -DSP_QP_NO_INTERIOR -DSP_REAL_FLOAT'; do
        # shellcheck disable=SC2086
        count "tests of quadratic programs, $sw" tests_without 'qp proximal' $sw
    done
    for sw_real in '' -DSP_REAL_FLOAT; do
        count "tests, SP_QP_ONLY $sw_real" tests_without 'qp proximal dykstra chol ldl cg order ruiz' -DSP_QP_ONLY $sw_real
        count "tests, SP_EXACT_ONLY $sw_real" tests_without 'small scene mesh joint contacts patch matrices closed verify near gen' -DSP_EXACT_ONLY $sw_real
    done
    count "tests, SP_SMALL, float" tests_without "$(cat tests/small/suites.txt)" -DSP_SMALL -DSP_REAL_FLOAT
    # In double the quick ones, by night all; in float those near what is left out.
    count "tests, SP_REAL_MIXED" tests_of "$deep" stonepack.c -O1 "$CC" -DSP_REAL_MIXED
    count "tests, SP_NO_QP" tests_without "$no_qp" -DSP_NO_QP
    count "tests, SP_NO_QP, float" tests_without "admm stages custom fence alternation ${EVERY:+coupled}" -DSP_NO_QP -DSP_REAL_FLOAT
    count "tests, SP_NO_IPM" tests_without "$no_ipm" -DSP_NO_IPM
    count "tests, SP_NO_IPM, float" tests_without 'stages custom settings closed near budget hard' -DSP_NO_IPM -DSP_REAL_FLOAT
    count "tests, SP_NO_STRONG" tests_without 'strong memory custom verify' -DSP_NO_STRONG
    count "tests, SP_NO_SLIDING" tests_without 'sliding strong limit memory verify' -DSP_NO_SLIDING
    count "tests, SP_NO_PLAN" tests_without "$no_plan" -DSP_NO_PLAN
    count "tests, SP_NO_PLAN, float" tests_without 'limit bracket memory budget verify' -DSP_NO_PLAN -DSP_REAL_FLOAT
    count "tests, SP_NO_ADMM, SP_NO_DYKSTRA" tests_without "$wide" -DSP_NO_ADMM -DSP_NO_DYKSTRA
    count "tests, SP_NO_ADMM, SP_NO_DYKSTRA, float" tests_without 'admm dykstra qp stages custom settings alternation' -DSP_NO_ADMM -DSP_NO_DYKSTRA -DSP_REAL_FLOAT
}
check_combinations() { count "switches, alone and in pairs, from tree, pair, package" sh tests/checks/switches.sh; }
check_warnings() {
    part "warnings: gcc, library; no data, no foreign calls" warn
    program_c="$host_c $(echo port/host/main.c tests/bench/*.c)" tests_c=$(echo tests/run.c tests/*/test_*.c)
    part "warnings: gcc, program" warn_host "$program_c" gcc '' -O1 -c -o $out/warn.o
    part "warnings: gcc, program, float" warn_host "$program_c" gcc -DSP_REAL_FLOAT -fsyntax-only
    part "warnings: gcc, tests" warn_host "$tests_c" gcc '' -fsyntax-only
    if have clang; then
        part "warnings: clang, library" warn_clang
        part "warnings: clang, program and tests" warn_host "$program_c $tests_c" clang '' -fsyntax-only
    else
        skip "warnings of clang" clang
    fi
}

# ------------------------------------------------------------------------------------------------------------- C++
cpp_header() {
    for ch_std in 98 11 17; do
        for ch_real in '' -DSP_REAL_FLOAT; do
            # shellcheck disable=SC2086
            echo '#include "stonepack.h"
                  int main() { sp_arena a; return sp_arena_init(&a, 0, 0) == SP_OK; }' |
                "$1" -std=c++$ch_std -pedantic-errors -Wall -Wextra -Werror $ch_real -I. -x c++ -fsyntax-only - || return 1
        done
    done
}
cpp_link() {
    echo '#include "stonepack.h"
          int main() { sp_arena a; return sp_arena_init(&a, 0, 0) == SP_E_ARGUMENT ? 0 : 1; }' > $out/link.cpp
    g++ -I. $out/link.cpp build/libstonepack.a -o $out/link_cpp && $out/link_cpp
}
check_cpp() {
    if have g++; then
        part "header as C++98/11/17" cpp_header g++
        part "C++ links the library" cpp_link
    else
        skip "header as C++" g++
    fi
}

# --------------------------------------------------------------------------------------------------------- symbols
# No data of its own; calls memcpy memset memmove sqrt(f) and the compiler's runtime only.
symbols() {                                             # symbols OBJECT ALLOWED-EXTRA-REGEX [PREFIX]
    s_nm=${3:-}nm
    [ -f "$1" ] || return 1
    $s_nm "$1" | awk '$2 ~ /^[dDbBC]$/ { print "data: " $0; bad = 1 } END { exit bad }' || return 1
    $s_nm -u "$1" | awk '{ print $NF }' |
        grep -Ev "^(memcpy|memset|memmove|sqrt|sqrtf|_GLOBAL_OFFSET_TABLE_${2:+|$2})\$" > $out/undefined && {
            echo "calls:"; cat $out/undefined; return 1; }
    return 0
}
symbols_small() {                                       # at -O0 and -O2 warn looks
    for sh_real in '' -DSP_REAL_FLOAT; do
        # shellcheck disable=SC2086
        $CC -std=c99 -ffp-contract=off -fno-math-errno -Os $sh_real -c stonepack.c -o $out/symbols.o && symbols $out/symbols.o '' || return 1
    done
}
freestanding() {
    # shellcheck disable=SC2086
    $CC -std=c99 -ffreestanding -ffp-contract=off -O1 -DSP_SQRT=__builtin_sqrt -c stonepack.c -o $out/free.o &&
    symbols $out/free.o ''
}
# gcc's own record of calls: no function reaches itself.
recursion() {
    for rc_real in '' -DSP_REAL_FLOAT; do
        # shellcheck disable=SC2086
        $CC -std=c99 -O0 $rc_real -fcallgraph-info -c stonepack.c -o $out/graph.o &&
        awk -f tests/checks/recursion.awk $out/graph.ci || return 1
    done
}
# Scalar or packed double instructions in the assembly of the float build (x86-64).
double_in_float() {
    $CC -std=c99 -ffp-contract=off -fno-math-errno -O2 -fno-tree-vectorize -DSP_REAL_FLOAT -S stonepack.c -o $out/float.s &&
    ! grep -nE '^[[:space:]]+(v?(add|sub|mul|div|sqrt|min|max|ucomi|comi|round)(sd|pd)|v?cvt(ss2sd|sd2ss|si2sd[lq]?|tsd2si[lq]?))[[:space:]]' \
        $out/float.s
}
check_symbols() {
    part "no data, no foreign calls, -Os" symbols_small
    part "freestanding" freestanding
    part "no recursion" recursion
    case $(uname -m) in x86_64) part "no double in the float build" double_in_float ;; esac
}

# ------------------------------------------------------------------------------------------------------------- Arm
arm_build() {                                           # arm_build NAME FLAGS...
    ab_name=$1
    shift
    rm -f $out/$ab_name.*
    arm-none-eabi-gcc -std=c99 -Os -ffp-contract=off -fno-math-errno -mthumb -mfloat-abi=hard -ffunction-sections \
        -Wall -Wextra -Wvla -Wdouble-promotion -Werror -fstack-usage "$@" -c stonepack.c -o $out/$ab_name.o
}
arm_frames() { awk -v limit=256 -f tests/checks/frames.awk $out/"$1".su; }
arm_symbols() { symbols $out/"$1".o '__aeabi_[a-z0-9_]+' arm-none-eabi-; }
arm_no_double() {
    arm-none-eabi-nm -u $out/"$1".o > $out/undefined &&
    ! grep -E '__aeabi_(d(add|sub|rsub|mul|div$|neg|cmp|2)|cd|f2d|u?i2d|u?l2d)|df[23]' $out/undefined
}
arm_sizes() {
    arm-none-eabi-size $out/m7_double.o $out/m4_float.o > $out/sizes && awk '
        NR > 1 { printf "%-28s %7d bytes of code, %d of data\n", $NF, $1, $2 + $3; if ($2 + $3) bad = 1 } END { exit bad }' $out/sizes
}
check_arm() {
    if ! have arm-none-eabi-gcc; then
        skip "32-bit Arm: frames of 256 bytes, size, no soft double" "gcc-arm-none-eabi libnewlib-arm-none-eabi"
        return
    fi
    part "Cortex-M7, double: compiles" arm_build m7_double -mcpu=cortex-m7 -mfpu=fpv5-d16
    part "Cortex-M4F, float: compiles" arm_build m4_float -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -DSP_REAL_FLOAT
    part "Cortex-M7: frames of 256 bytes" arm_frames m7_double
    part "Cortex-M4F: frames of 256 bytes" arm_frames m4_float
    part "Cortex-M7: calls" arm_symbols m7_double
    part "Cortex-M4F: calls" arm_symbols m4_float
    part "Cortex-M4F: no double routine" arm_no_double m4_float
    SHOW=1
    part "Arm sizes at -Os" arm_sizes
    SHOW=
}

# The lines that port/board/README.md shows are lines that the boards print.
board_samples() {
    { make -s robot && make -s regions && make -s -f port/board/board.mk BOARD=m4f REAL=float; } > $out/boards.txt || return 1
    grep -E '^    ([a-z-]+: (release|hold|stable|stands|[0-9]+ bytes)|wall of 10 )' port/board/README.md | sed 's/^    //' > $out/shown.txt
    [ "$(wc -l < $out/shown.txt)" -ge 7 ] || { echo "port/board/README.md shows too few lines"; return 1; }
    while read -r line; do
        grep -qF -- "$line" $out/boards.txt || { echo "not printed: $line"; return 1; }
    done < $out/shown.txt
}

check_robot() {
    if have arm-none-eabi-gcc && have qemu-system-arm; then
        part "a robot is told when to let go: Cortex-M4F in float, Cortex-M7 in double" make robot
        part "the factor in another memory: Cortex-M4F in float, Cortex-M7 in double" make regions
        part "port/board/README.md shows what the boards print" board_samples
    else
        skip "a robot on Cortex-M" gcc-arm-none-eabi,qemu-system-arm
    fi
}

# ------------------------------------------------------------------------------------------------------- footprint
check_footprint() {
    if have arm-none-eabi-gcc && have qemu-system-arm; then
        part "footprint: within 2 % of port/board/footprint.csv" sh port/board/footprint.sh --compare
    else
        skip "footprint" gcc-arm-none-eabi,qemu-system-arm
    fi
}

# ------------------------------------------------------------------------------------------------------------ pair
# Every public function used once: with SP_API static nothing may be left over.
pair_static() {
    awk '/^SP_API/ { line = $0; while (line !~ /;/) { if ((getline more) <= 0) break; line = line more }
                     sub(/\(.*/, "", line); n = split(line, w, /[ *]+/); print w[n] }' build/pair/stonepack.h > $out/public
    {
        echo '#define SP_API static'
        echo '#include "stonepack.c"'
        echo 'typedef void (*any)(void);'
        echo 'extern const any all_of_it[];'
        echo 'const any all_of_it[] = {'
        sed 's/.*/    (any)&,/' $out/public
        echo '    (any)0 };'
    } > build/pair/static.c
    for ps_std in c99 c11 c2x; do
        for ps_real in '' -DSP_REAL_FLOAT; do
            # shellcheck disable=SC2086
            $CC -std=$ps_std -pedantic-errors -Wall -Wextra -Wshadow -Werror -O0 $ps_real -c build/pair/static.c -o $out/static.o ||
                return 1
            nm $out/static.o | awk '$2 == "T" { print "visible: " $0; bad = 1 } END { exit bad }' || return 1
        done
    done
}
pair_standards() {                                      # a standard changes what is said of the text, not what is made of it
    for pp_std in c99 c11 c2x; do
        for pp_real in '' -DSP_REAL_FLOAT; do
            # shellcheck disable=SC2086
            $CC -std=$pp_std -pedantic-errors -Wall -Wextra -Wshadow -Werror $pp_real -fsyntax-only build/pair/stonepack.c || return 1
        done
    done
    $CC -std=c99 -pedantic-errors -Wall -Wextra -Wshadow -Werror -O2 -c build/pair/stonepack.c -o $out/pair.o
}
pair_tests() { tests_of "$deep" build/pair/stonepack.c -O1 "$CC"; }
# The library inside a file of the caller's: no name of it may stand in the way. Every suite compiles so (fence and convex hold
# parts of it under other names), one wing runs so.
pair_private() {
    pp_inside='-include build/pair/stonepack.c'
    if have clang; then                                 # the library is read once
        clang -std=c11 -w -DSP_API=static -x c-header build/pair/stonepack.c -o $out/inside.pch || return 1
        pp_inside="-include-pch $out/inside.pch"
    fi
    for pp_file in $(suite_c $(echo "$core" | grep -vxE "fence|convex")); do
        # shellcheck disable=SC2086
        $(quickest) -std=c11 -w -DSP_API=static $pp_inside -fsyntax-only "$pp_file" || return 1
    done
    # shellcheck disable=SC2086,SC2046
    $CC -std=c11 -ffp-contract=off -fno-math-errno -O0 -Wno-unused-function -DSP_API=static -include build/pair/stonepack.c \
        -DTEST_SUITES="$(stems scene matrices loads)" tests/run.c $(suite_c scene matrices loads) tests/scenes/gen.c -lm \
        -o $out/run_private && $out/run_private
}
pair_bits() {                                           # pair_bits STANDARD PRECISION FLAGS...
    pb_std=$1 pb_real=$2
    shift 2
    DIFFER=1 LIBRARY=build/pair/stonepack.c STD=$pb_std sh tests/corpus/corpus.sh "$pb_real" "$CC" "$@"
}
pair_bits_standards() {
    for pt_std in c99 c11 c2x; do pair_bits $pt_std double -O0 || return 1; done
    pair_bits c11 float -O0 && pair_bits c99 double -O2
}
pair_small() {                                          # its searches are others: the tree's own bits
    for ps_real in double float; do
        sh tests/corpus/corpus.sh $ps_real "$CC" -O0 -DSP_SMALL > $out/small.txt || return 1
        LIBRARY=build/pair/stonepack.c sh tests/corpus/corpus.sh $ps_real "$CC" -O1 -DSP_SMALL | diff $out/small.txt - || return 1
    done
}
check_pair() {
    sh port/pair/pair.sh stonepack.c build/pair || failed=$((failed + 1))
    part "pair: C99, C11, C2x, float" pair_standards
    part "pair: static, nothing left over" pair_static
    count "pair: tests" pair_tests
    count "pair: tests, SP_API static, C11" pair_private
    part "pair: the bits of the tree, C99, C11, C2x" pair_bits_standards
    for pa_switch in $(grep -oE 'SP_NO_[A-Z_]*' stonepack.h | sort -u | grep -vxE 'SP_NO_(IPM|PLAN)'); do    # these find other forces
        part "pair: the bits of the tree with $pa_switch" pair_bits c99 double -O0 -D"$pa_switch"
    done
    part "pair: the bits of the tree with SP_SMALL, not optimised" pair_small
}

check_package() { count "packages" sh port/package/check.sh; }

# ---------------------------------------------------------------------------------------------------------- Python
# The wheel is made by the standard library alone and tested where it was installed, with no compiler on the path.
py=python3
if /usr/bin/python3 -c 'import ensurepip' 2> /dev/null; then py=/usr/bin/python3; fi
py_bin=$out/venv/bin/python
py_wheel() {
    make -s python PYTHON=$py && cp "$(cat build/python/made)" $out/first.whl && rm build/python/made &&
    make -s python PYTHON=$py && cmp $out/first.whl "$(cat build/python/made)"
}
py_install() {
    rm -rf $out/venv
    $py -m venv $out/venv && $py_bin -m pip install -q --no-index --no-deps "$(cat build/python/made)"
}
# Without Bullet the wheel is for every Linux since glibc 2.17, asks for nothing newer, and what does is told by its tag.
py_listed() {
    pl=$out/listed
    rm -rf $pl && mkdir -p $pl/there && cp -r build/python $pl/python && cp -r build/python $pl/newer && rm -f $pl/*/stonepack/libstonepack_settle.so &&
    ! objdump -T $pl/python/stonepack/*.so* | grep -E 'GLIBC_2\.(1[89]|[2-9][0-9])' &&
    echo https://stones.example/pack > $pl/python/homepage && $py -B port/python/wheel.py $pl/python $pl | grep '/stonepack-[0-9.]*-py3-none-manylinux_2_17_x86_64.manylinux2014_x86_64.whl$' &&
    $py -m pip install -q --root-user-action=ignore --no-index --no-deps --target $pl/there $pl/*.whl &&
    grep '^Project-URL: Homepage, https://stones.example/pack$' $pl/there/*.dist-info/METADATA &&
    PYTHONPATH=$pl/there $py -B -c 'import stonepack
scene = stonepack.read("tests/scenes/arch.obj")
scene.write("'$pl'/arch.obj"), scene.check().svg("'$pl'/arch.svg")' && ls $pl/arch.obj $pl/arch.svg &&
    echo 'int stat(const char *, void *); int newer(const char *s) { char b[400]; return stat(s, b); }' |
        $CC -shared -fPIC -x c - -o $pl/newer/stonepack/libnewer.so && $py -B port/python/wheel.py $pl/newer $pl | grep manylinux_2_33_ &&
    echo 'double sin(double); double bullet(double x) { return sin(x); }' |
        $CC -shared -fPIC -Wl,-soname,libBulletDynamics-float64.so.3.24 -x c - -o $pl/libbullet.so &&
    echo 'double bullet(double); double asks(double x) { return bullet(x); }' |
        $CC -shared -fPIC -x c - -x none $pl/libbullet.so -o $pl/newer/stonepack/libasks.so && $py -B port/python/wheel.py $pl/newer $pl | grep -- -none-linux_
}
py_alone() { env -i PATH=/nonexistent PYTHONDONTWRITEBYTECODE=1 "$(pwd)/$py_bin" -I "$@"; }
py_here() { PYTHONPATH=$(pwd)/build/python /usr/bin/python3 -B tests/python/run.py "$@"; }
py_types() { mypy --python-version 3.8 --cache-dir $out/mypy build/python/stonepack; }
# Memory that Python owns and C writes: both libraries under sanitizers, arrays from malloc.
py_sanitized() {
    ps=$out/sanitized/stonepack
    rm -rf $out/sanitized && mkdir -p $out/sanitized && cp -r build/python/stonepack $ps || return 1
    ps_lib=$(echo $ps/libstonepack.so.*)
    # shellcheck disable=SC2086,SC2016
    $CC -shared $san -Wl,-soname,"$(basename "$ps_lib")" build/asan.o -o "$ps_lib" &&
    $CC $plain -O0 -fPIC -shared $san -fvisibility=hidden -ffunction-sections -fdata-sections -Wl,--gc-sections '-Wl,-rpath,$ORIGIN' \
        port/python/files.c port/host/run.c port/host/clock.c port/host/weakest.c port/host/motion.c port/host/reason.c port/host/files/*.c \
        port/host/picture/*.c port/host/command/report.c port/host/command/report_json.c "$ps_lib" -lm -o $ps/libstonepack_files.so &&
    env LD_PRELOAD="$($CC -print-file-name=libasan.so) $($CC -print-file-name=libubsan.so)" PYTHONMALLOC=malloc \
        ASAN_OPTIONS=detect_leaks=0 PYTHONPATH=$out/sanitized $py -B tests/python/run.py test_scene test_kit.Assertions
}
# A field that became longer, one that moved: the layout of ctypes is not that of the header any more.
py_drift() {
    mkdir -p $out/drift/settle
    cp settle/settle.h $out/drift/settle/
    for dr in 's/^    int32_t verified; /    int64_t verified; /' 's/^    int32_t a, b;               .. blocks; n/    int32_t b, a;   \/* n/'; do
        sed "$dr" stonepack.h > $out/drift/stonepack.h
        ! cmp -s stonepack.h $out/drift/stonepack.h || { echo "nothing drifted: $dr"; return 1; }
        ! $CC -std=c11 -I$out/drift -fsyntax-only build/python/layout.c 2> $out/drift.txt || { echo "not noticed: $dr"; return 1; }
        grep -q 'static assertion' $out/drift.txt || { cat $out/drift.txt; return 1; }
    done
}
py_warnings() {
    for pw in gcc clang; do
        # shellcheck disable=SC2086
        if have $pw; then $pw $host -O1 -c port/python/files.c -o $out/warn.o || return 1; fi
    done
}
# The example of port/ORACLE.md in C: its mistake is found by a plain loop, shrunk to 4 boxes, and by libFuzzer.
oracle_loop() {
    # shellcheck disable=SC2086
    $CC $host -O2 -I. port/oracle/packer.c build/libstonepack.a -lm -o $out/packer || return 1
    $out/packer > $out/packer.txt
    [ $? -eq 1 ] && cat $out/packer.txt && [ "$(grep -c '^  box' $out/packer.txt)" -eq 4 ]
}
oracle_fuzzer() {
    clang $plain -O1 -I. -fsanitize=fuzzer -DPACKER_FUZZER port/oracle/packer.c build/libstonepack.a -lm -o $out/packer_fuzzer || return 1
    (cd $out && ./packer_fuzzer -seed=1 -max_len=16 -max_total_time=60 -artifact_prefix=packer- > fuzzer.txt 2>&1)
    grep 'what was packed falls' $out/fuzzer.txt || { cat $out/fuzzer.txt; return 1; }
}
oracle_afl() {
    rm -rf $out/afl && mkdir -p $out/afl/in && head -c 16 /dev/zero > $out/afl/in/zeros &&
    afl-clang-fast $plain -O1 -I. -fsanitize=fuzzer -DPACKER_FUZZER port/oracle/packer.c build/libstonepack.a -lm \
        -o $out/afl/packer || return 1
    AFL_BENCH_UNTIL_CRASH=1 AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_AFFINITY=1 AFL_NO_UI=1 \
        timeout 60 afl-fuzz -s 1 -i $out/afl/in -o $out/afl/out -- $out/afl/packer > $out/afl.txt 2>&1
    grep -E '^saved_crashes +: [1-9]' $out/afl/out/default/fuzzer_stats || { tail -n 20 $out/afl.txt; return 1; }
}
check_python() {
    part "oracle: a plain loop in C finds the planted mistake" oracle_loop
    if have clang; then part "oracle: libFuzzer finds it" oracle_fuzzer
    else skip "oracle: libFuzzer finds a planted mistake" "clang libclang-rt-14-dev"; fi
    if have afl-clang-fast; then part "oracle: AFL++ finds it" oracle_afl; else skip "oracle: AFL++ finds a planted mistake" afl++; fi
    if ! $py -c 'import ensurepip' 2> /dev/null; then skip "Python: wheel and its tests" "python3 python3-venv"; return; fi
    part "Python: wheel, twice the same bytes" py_wheel
    if [ "$(uname -m)" = x86_64 ]; then part "Python: one wheel for Linux since glibc 2.17, without Bullet" py_listed; fi
    part "Python: a header that drifted is told" py_drift
    part "Python: warnings of the reader's door" py_warnings
    part "Python: installed without a compiler" py_install
    count "Python: tests where it is installed" py_alone tests/python/run.py
    if /usr/bin/python3 -c 'import numpy' 2> /dev/null; then
        count "Python: arrays of NumPy" py_here test_scene.Building
    else skip "Python: arrays of NumPy" python3-numpy; fi
    if /usr/bin/python3 -c 'import pytest, hypothesis' 2> /dev/null; then
        count "Python: strategies shrink, a planted mistake is found" py_here test_kit.Strategies
    else skip "Python: strategies, a planted mistake" "python3-pytest python3-hypothesis"; fi
    if nm build/asan.o | grep -q __asan_init; then count "Python: tests under ASan and UBSan" py_sanitized; fi
    if have mypy; then part "Python: types" py_types; else skip "Python: types" mypy; fi
    if /usr/bin/python3 -c 'import em, rosidl_adapter, rosidl_parser' 2> /dev/null; then
        count "ROS 2: definitions by rosidl, the bridge by the worker" env PYTHONPATH=build/python /usr/bin/python3 -B tests/checks/ros.py
    else skip "ROS 2: definitions by rosidl, the bridge" "python3-rosidl python3-empy"; fi
}

# ----------------------------------------------------------------------------------------------------------- sanitizers
san='-g -fsanitize=address,undefined -fno-sanitize-recover=all'
# By clang: it looks at pointers, too, where gcc takes an offset for signed.
# What searches for seconds does so by night, and all of them in float; scenes and any bytes ask the same code here.
sanitized() {
    sa_suites=$(echo "$all" | tr ' ' '\n' | grep -vxE 'bracket|coupled|exact|spared')
    # shellcheck disable=SC2086
    tests_of "$sa_suites" stonepack.c -O1 "$(quickest)" $san
}
undefined_scenes() {                                    # after sanitized: by its library
    # shellcheck disable=SC2086
    clang $plain -w -O0 $san port/host/main.c $host_c $out/library.o -lm -o $out/stonepack_ub || return 1
    for us in tests/scenes/*.obj; do
        for us_what in check 'check --coupled' 'limit --body 1,0,0' 'limit --tilt-margin' sequence; do
            # shellcheck disable=SC2086
            $out/stonepack_ub $us_what "$us" > $out/ub.txt 2>&1
            if [ $? -gt 2 ] || grep -E 'runtime error|AddressSanitizer' $out/ub.txt; then       # 64: it was not asked at all
                tail -n 3 $out/ub.txt
                echo "$us_what $us"
                return 1
            fi
        done
    done
}
# Assimp as make found it, that is in PLUG_C.
case " ${PLUG_C:-} " in
*' -DWITH_ASSIMP '*) assimp_c="-DWITH_ASSIMP $(pkg-config --cflags assimp | sed 's/-I/-isystem /g')" assimp_l=$(pkg-config --libs assimp) ;;
*) assimp_c='' assimp_l='' ;;
esac
bad_sanitized() {
    # shellcheck disable=SC2086
    $CC $plain -O0 $san $assimp_c port/host/main.c $host_c build/asan.o $assimp_l -lm -o $out/stonepack_san &&
        sh tests/checks/bad.sh $out/stonepack_san
}
# Of all that is computed nothing may depend on what was never written.
uninitialised() {
    un_suites=$(wings base scene contacts proof linear cone qp | grep -vxE 'large|order|qp')
    tests_of "$un_suites drawn" stonepack.c -O1 clang -g -fsanitize=memory -fno-sanitize-recover=all
}
# Two threads, each with its own arena, and two that share the tasks of a factor, under TSan; with one arena for both it must tell of
# a race.
# shellcheck disable=SC2086
threads() {
    th='-std=c99 -ffp-contract=off -fno-math-errno -Wall -Wextra -O1 -g -fsanitize=thread'
    th_c="tests/checks/threads.c tests/scenes/gen.c port/host/command/jobs.c port/host/command/progress.c port/host/clock.c
        port/host/files/failure.c"
    gcc $th -c stonepack.c -o $out/tsan.o && gcc $th $th_c $out/tsan.o -lpthread -lm -o $out/threads &&
        gcc $th -DPLANTED $th_c $out/tsan.o -lpthread -lm -o $out/threads_planted || return 1
    for th_try in 1 2 3 4 5 6 7 8 9 10; do               # what shares an arena may crash before TSan has told of it
        TSAN_OPTIONS=exitcode=66 $out/threads_planted > $out/planted.txt 2>&1
        [ $? -eq 66 ] && grep -q 'data race' $out/planted.txt && break
        [ $th_try -lt 10 ] || { echo "a shared arena is not noticed"; return 1; }
    done
    $out/threads
}
check_sanitizers() {
    count "tests under ASan and UBSan" sanitized
    if have clang; then part "bundled scenes under ASan and clang's UBSan" undefined_scenes; fi
    count "bad scenes under ASan and UBSan" bad_sanitized
    if have python3; then
        count "models in other forms under ASan and UBSan" python3 -B tests/checks/formats.py $out/stonepack_san
        count "bad models in other forms under ASan and UBSan" python3 -B tests/checks/bad_formats.py $out/stonepack_san
        count "a newcomer's export under ASan and UBSan" python3 -B tests/checks/newcomer.py $out/stonepack_san
    else
        skip "models in other forms under ASan and UBSan" python3
    fi
    if [ -z "$assimp_c" ]; then skip "STL, PLY, glTF and others" "pkg-config libassimp-dev"; fi
    if have python3; then
        count "requests that are no requests, timeouts, clients that die, full discs, under ASan and UBSan" \
            python3 -B tests/checks/worker.py $out/stonepack_san
    fi
    count "threads under TSan; a planted race is noticed" threads
    count "models of COMPAS under ASan and UBSan" sh tests/checks/compas.sh $out/stonepack_san
    if have clang; then
        count "tests under MSan" uninitialised
    else
        skip "clang's UBSan, MSan" clang
    fi
}

# ------------------------------------------------------------------------------------------------------------ same bits
# The corpus: every build finds the same verdicts and forces to the last bit.
corpus() {                                              # corpus COMPILER [FLAGS...], in both precisions
    for co_real in double float; do DIFFER=1 sh tests/corpus/corpus.sh $co_real "$@" || return 1; done
}
# gcc's vectoriser of straight lines fuses although it may not: none of it is in the object, and it has the bits.
unfused() {
    for un_real in double float; do
        un_flag=''
        if [ $un_real = float ]; then un_flag=-DSP_REAL_FLOAT; fi
        # shellcheck disable=SC2086
        gcc $plain -O3 -march=x86-64-v3 $un_flag -c stonepack.c -o $out/unfused.o || return 1
        objdump -d $out/unfused.o | grep -E 'vfn?m(add|sub)' && return 1
        if grep -qw avx2 /proc/cpuinfo; then DIFFER=1 LIBRARY=$out/unfused.o sh tests/corpus/corpus.sh $un_real gcc -O1 || return 1; fi
    done
    return 0
}
check_bits() {
    part "same bits: gcc -O1, double" env DIFFER=1 sh tests/corpus/corpus.sh double gcc -O1
    part "same bits: gcc -O2, float" env DIFFER=1 sh tests/corpus/corpus.sh float gcc -O2
    part "same bits: gcc -Os" corpus gcc -Os
    case $(uname -m) in
    x86_64) part "same bits: gcc -O3 for AVX2, no fused multiply-add" unfused ;;
    *) part "same bits: gcc -O3 -march=native" corpus gcc -O3 -march=native
       skip "same bits: no fused multiply-add" "x86-64" ;;
    esac
    if have clang; then part "same bits: clang -O2" corpus clang -O2; else skip "same bits: clang" clang; fi
    if have tcc; then part "same bits: tcc" corpus tcc; else skip "same bits: tcc" tcc; fi
}

# --------------------------------------------------------------------------------------------------------------- long
# Suites of packages, which `make test` had not yet; of the smallest form all samples of claims of which daily work asks few. Of
# the others nightly.sh asks all, under sanitizers.
long() {                                                # long RUNNER SUITE...
    lo_run=$1 lo_p=0 lo_f=0
    shift
    for lo; do
        LONG=1 "$lo_run" "$lo/" > $out/long.txt 2>&1
        # shellcheck disable=SC2046
        set -- $(sed -n '$p' $out/long.txt)
        [ "${2:-}" = passed, ] || { cat $out/long.txt; return 1; }
        lo_p=$((lo_p + $1)) lo_f=$((lo_f + $3))
        grep -A 9 '^FAILED' $out/long.txt
    done
    echo "$lo_p passed, $lo_f failed"
}
check_long() {
    count "suites of packages" long build/run plugins settle
    # shellcheck disable=SC2046
    count "all samples of every claim, SP_SMALL" long build/run_small $(grep -l SOME_OF tests/*/test_*.c | sed 's|.*/test_\(.*\)\.c|\1|')
}

# ------------------------------------------------------------------------------------------------------------- the rest
# Solvers of others: what make found of them (PLUGINS, PLUG_C, PLUG_L).
warn_plugins() {                                        # warn_plugins COMPILER DIRECTORY
    for wp_real in '' -DSP_REAL_FLOAT; do
        for wp_file in "$2"/*.c port/host/command/solvers.c tests/host/test_plugins.c; do
            # shellcheck disable=SC2086
            "$1" $host $wp_real $PLUG_C -O1 -Wno-unused-function -c "$wp_file" -o $out/warn.o || return 1
        done
    done
}
sanitized_plugins() {                                   # sanitized_plugins FILTER
    # shellcheck disable=SC2086
    $CC $plain -DTEST_SUITES='X(plugins)' -O0 $san $PLUG_C -UWITH_BULLET tests/run.c tests/host/test_plugins.c $host_c \
        $(for sp in ${PLUGINS:-}; do ls "$sp"/*.c; done) build/asan.o $PLUG_L -lm -o $out/run_plugins && $out/run_plugins "$1"
}
plugin() {                                              # plugin NAME DIRECTORY
    part "$1: warnings" warn_plugins "$CC" "$2"
    count "$1: tests" build/run "plugins/${2#port/}"
    count "$1: tests, float" build/run_float "plugins/${2#port/}"
    count "$1: tests under ASan and UBSan" sanitized_plugins "plugins/${2#port/}"
}
check_plugins() {
    case " ${PLUGINS:-} " in
    *" port/ipopt "*) plugin Ipopt port/ipopt ;;
    *) skip "Ipopt as a solver, the published coupled program" "coinor-libipopt-dev pkg-config" ;;
    esac
    case " ${PLUGINS:-} " in
    *" port/osqp "*) plugin OSQP port/osqp ;;
    *) echo "none    OSQP as a solver: no Debian package; install OSQP 1.x, then make check OSQP=PREFIX" ;;
    esac
}

check_static() {
    part "gcc -fanalyzer: quadratic programs" sh tests/checks/analyze.sh gcc -DSP_QP_ONLY
    part "gcc -fanalyzer: the program" sh tests/checks/analyze.sh gcc-program
    if have clang-tidy; then part "clang-tidy: double, float, SP_SMALL; the program, settle" sh tests/checks/analyze.sh clang-tidy; else skip "clang-tidy" clang-tidy; fi
    if have cppcheck; then part "cppcheck: library, program, settle" sh tests/checks/analyze.sh cppcheck; else skip "cppcheck" cppcheck; fi
    part "TRUST.md has a row of all that runs" sh tests/checks/trust.sh --compare
}
# ---------------------------------------------------------------------------------------------------------------- settle
settle_flags() {
    for sf in bullet-float64 bullet; do
        if pkg-config --exists $sf 2> /dev/null; then
            bullet_i=$(pkg-config --cflags $sf | sed 's/-I/-isystem /g') bullet_l=$(pkg-config --libs $sf)
            return 0
        fi
    done
    return 1
}
settle_warnings() {
    for sw_real in '' -DSP_REAL_FLOAT; do
        # shellcheck disable=SC2086
        "$1" $host $sw_real -O1 -DWITH_BULLET -Wno-unused-function -c port/host/command/settle.c -o $out/warn.o &&
        "$1" $host $sw_real -O1 -DWITH_BULLET -Wno-unused-function -c tests/settle/test_settle.c -o $out/warn.o &&
        for sw_c in settle/*.c; do "$1" $host $sw_real -O2 -c $sw_c -o $out/warn.o || return 1; done || return 1
    done
    # shellcheck disable=SC2086
    "$2" -std=c++11 -pedantic-errors -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror -O2 $bullet_i -c settle/bullet.cpp -o $out/warn.o
}
settle_sanitized() {
    # shellcheck disable=SC2086
    g++ -std=c++11 -O1 $san $bullet_i -c settle/bullet.cpp -o $out/settle_san.o &&
    $CC $plain -O0 $san -DWITH_BULLET -DTEST_SUITES='X(settle)' tests/run.c tests/settle/test_settle.c settle/*.c $host_c build/asan.o \
        $out/settle_san.o $bullet_l -lstdc++ -lm -o $out/run_settle && $out/run_settle
}
settle_cases() { python3 tests/checks/settle_cases.py build/stonepack ../shared/cases; }
check_settle() {
    if ! have g++ || ! settle_flags; then
        skip "where stones come to rest" "g++ pkg-config libbullet-dev"
        return
    fi
    part "settle: warnings, gcc and g++" settle_warnings gcc g++
    if have clang++; then part "settle: warnings, clang" settle_warnings clang clang++; fi
    count "settle: tests under ASan and UBSan" settle_sanitized
    if [ -d ../shared/cases ]; then
        SHOW=1
        part "settle agrees with statics on cases of known truth" settle_cases
        SHOW=
    else lack "settle on cases of known truth" ../shared/cases; fi
}
cases() { python3 ../shared/tools/run_cases.py --cli build/stonepack --jobs 2; }
pictures() {
    sh tests/checks/demo.sh && for pi in build/demo/*.svg; do rsvg-convert -w 900 "$pi" -o "${pi%.svg}.png" || return 1; done
}
coupled() {                                             # coupled SCENES: its answers, judged in 113 bits from the written results
    cli_build "$CC" $out/quad -O2 -w -DSP_REAL_QUAD -D_XOPEN_SOURCE=700 -D_DEFAULT_SOURCE -include quadmath.h '-DSP_SQRT(x)=sqrtq(x)' -Wl,--no-as-needed -lquadmath &&
    python3 -B tests/checks/coupled_cases.py build/stonepack "$1" --quad $out/quad --every "$some"
}
strong() {                                              # strong SCENES: proofs judged in 113 bits, attempts to move, written otherwise
    # shellcheck disable=SC2046
    $CC -std=gnu99 -O2 -w -ffp-contract=off -fno-math-errno -Ibuild tests/instruments/friction.c port/host/run.c port/host/clock.c \
        $(echo port/host/files/*.c) -lm -o $out/friction &&
    python3 -B tests/checks/strong_cases.py build/stonepack "$@" --quad $out/quad --attack $out/friction --attempts 20 --random 10
}
check_cases() {
    if ! have python3; then skip "cases of known truth, triples in 113 bits" python3; return; fi
    SHOW=1
    if [ -d ../shared/cases ]; then
        part "cases of known truth" cases
        part "coupled check on cases of known truth: shares, 113 bits, monotone, invariant" coupled ../shared/cases
    else
        lack "cases of known truth" ../shared/cases
        part "coupled check on the bundled scenes: 113 bits, monotone, invariant" coupled tests/scenes
    fi
    part "strong verdicts: 113 bits, attempts to move, written otherwise" strong tests/scenes
    SHOW=
}
once=5075,5094,5115,5125,5337,5374,5400,5454,5473,5476,5494,17,58,128,461,5327,5575,6141,6148
strong_once=1047,1053,1065
check_oracle() {
    if /usr/bin/python3 -c 'import numpy, scipy.optimize' 2> /dev/null; then
        SHOW=1
        part "random scenes near their limit, against linear programming" /usr/bin/python3 -B tests/oracle/random.py --quick
        part "scenes that were undecided once" /usr/bin/python3 -B tests/oracle/random.py --seeds $once
        part "joints with strength that were undecided once" /usr/bin/python3 -B tests/oracle/random.py --kind strength --seeds $strong_once
        part "limits, against linear programming" /usr/bin/python3 -B tests/oracle/random.py --limits --seed 1 --count 40
        part "linear programmes, against HiGHS" /usr/bin/python3 -B tests/oracle/lp.py
        part "build orders, against linear programming" /usr/bin/python3 -B tests/oracle/sequence.py
        part "build orders of the tests, against linear programming" /usr/bin/python3 -B tests/oracle/sequence.py --orders
        SHOW=
    else
        skip "random scenes against linear programming" "python3-numpy python3-scipy"
    fi
}
# What was wrong in quad alone.
quad_tests() {
    # shellcheck disable=SC2086
    $CC $plain -O0 -w -DSP_REAL_QUAD -D_XOPEN_SOURCE=700 -include quadmath.h '-DSP_SQRT(x)=sqrtq(x)' '-DTEST_SUITES=X(mesh)' \
        tests/run.c tests/scene/test_mesh.c tests/scenes/gen.c stonepack.c -Wl,--no-as-needed -lquadmath -lm -o $out/run_quad &&
        $out/run_quad mesh/in_quad_
}
check_instruments() {                                   # the battery of hard scenes in other arithmetic; nightly.sh has more
    for in_name in float mixed rounding traps flush near; do
        part "battery: $in_name" sh tests/instruments/instruments.sh $in_name
    done
    count "tests, quad" quad_tests
    SHOW=1
    part "battery: quad; each scene's omega, growth of rounding, time" sh tests/instruments/instruments.sh quad
    if have python3; then part "double, mixed, quad, float: the same verdicts outside their bands" sh tests/instruments/instruments.sh precisions
    else skip "precisions side by side" python3; fi
    SHOW=
    if [ -d ../shared/cases ] && have python3; then
        SHOW=1
        part "cases of known truth in other arithmetic" sh tests/instruments/instruments.sh cases
        SHOW=
        part "cases: mixed" sh tests/instruments/instruments.sh cases-mixed
    elif have python3; then lack "cases of known truth in other arithmetic" ../shared/cases; fi
}
# Both with a seed of their own, so that a failure comes again; nightly.sh has more.
check_fuzz() {
    count "any bytes into every reader and question" env FUZZ_SEED=1 sh tests/fuzz/fuzz.sh --quick
    figure=$(grep -oE '[0-9]+ executions' "$tally_log" | awk '{ n += $1 } END { print n " executions" }')
    if ! have afl-clang-fast; then skip "any bytes by AFL++" afl++; fi
}
check_mutants() {
    if have python3 && have tcc; then
        SHOW=1
        part "12 mutants of the certificate check are noticed" \
            python3 -B tests/mutation/mutate.py --of proof --sample 12 --seed 1 --least 100
        SHOW=
    else skip "mutants" "python3 tcc"; fi
}
# nightly.sh has all suites and folders.
check_coverage() {
    if have python3 && have clang-19 && have llvm-cov-19; then
        SHOW=1
        part "conditions of the certificate check that its suites show to decide" \
            env OF=proof LEFT=1 LEAST=100 sh tests/mutation/coverage.sh scale search moving leaf still \
            corner refute triple forces strong shear sliding verify claims shapes
        SHOW=
    else skip "MC/DC of the certificate check" "python3 clang-19 llvm-19 libclang-rt-19-dev"; fi
}
check_bench() {
    part "bench, quick: no wrong verdict" sh -c "build/bench --quick > $out/bench.csv"
    if have python3; then
        part "numbers of all pages stand in their CSV" python3 -B tests/bench/words.py
        part "accuracy.svg is drawn from cost.csv" drawn accuracy tests/bench/figures/cost.csv
        part "concept.svg is drawn by concept.py" drawn concept
    else skip "numbers of the pages against CSV" python3; fi
}
drawn() { python3 -B "tests/bench/$1.py" ${2:+"$2"} | cmp - "tests/bench/figures/$1.svg"; }
check_demo() {
    if have rsvg-convert; then part "demo, pictures are readable SVG" pictures
    else part "demo" sh tests/checks/demo.sh; skip "pictures as PNG" librsvg2-bin; fi
}

# The page: the program's answers to the bit, and the page in a browser.
page_html() { make -s page; }
page_warnings() {
    # shellcheck disable=SC2086
    for pw in port/page/*.c; do gcc $host -O1 -c "$pw" -o $out/warn.o || return 1; done
}
check_page() {
    part "page: warnings" page_warnings
    pa_lacks=$(sh port/page/build.sh --lacks | tr '\n' ' ')
    if [ "$pa_lacks" ]; then skip "a page in a browser" "$pa_lacks"; return; fi
    part "page: built" page_html
    count "page: the program's answers to the bit" node tests/checks/page_bits.mjs build/page/core.wasm build/stonepack
    if have chromium; then count "page: in a browser" node tests/checks/page_browser.mjs build/page/stonepack.html chromium $out/screens
    else skip "page: in a browser" chromium; fi
}

# Windows: the program and the tests by mingw-w64, run by wine. Only its workers need POSIX, and say so.
# Tests that hold parts of the library count their work: at -O0 they would call the sqrt of mingw-w64, which rounds 1 of 4,000
# numbers the other way; sqrt.h has the processor's.
mingw=x86_64-w64-mingw32-gcc
wine=$(command -v wine64 || command -v wine || { [ ! -x /usr/lib/wine/wine64 ] || echo /usr/lib/wine/wine64; }) || :
exe() { "$wine" "$out/stonepack.exe" "$@"; }
windows_runs() {
    tests_windows="$quick csv_out obj picture tilt"
    # shellcheck disable=SC2086,SC2046
    $mingw $plain -w -O1 -c stonepack.c -o $out/library.o &&
    $mingw $plain -w -O0 port/host/main.c $host_c $out/library.o -lm -o $out/stonepack.exe &&
    $mingw $plain -w -O0 -include tests/checks/sqrt.h -DTEST_SUITES="$(stems $tests_windows)" tests/run.c \
        $(suite_c $tests_windows) $host_c $out/library.o -lm -o $out/run.exe
}
windows_tests() { "$wine" $out/run.exe | tr -d '\r'; }
told_alike() {                                          # told_alike ARGUMENTS...: the program's own words and status, but for times
    build/stonepack "$@" > $out/here.txt
    ta_here=$?
    exe "$@" > $out/there.txt
    [ $? -eq $ta_here ] || { echo "another exit status: $*"; return 1; }
    for ta in here there; do sed 's/, [0-9.]* [num]*s, by/, by/; s/"seconds": *[^,}]*//g' $out/$ta.txt > $out/$ta.told; done
    cmp $out/here.told $out/there.told
}
windows_program() {
    for wp in arch arch-falling h-model; do
        told_alike check "tests/scenes/$wp.obj" && told_alike check --json --forces "tests/scenes/$wp.obj" || return 1
    done
    told_alike contacts tests/scenes/wall.obj && told_alike convert tests/scenes/wall.obj && told_alike plan tests/scenes/wall.obj &&
    told_alike sequence --json tests/scenes/two-cubes.obj && told_alike gen arch n=5
}
windows_worker() {
    exe check --worker 5 tests/scenes/arch.obj 2> $out/told.txt && return 1
    grep "can't start a worker: that needs POSIX" $out/told.txt && exe check --worker 5 --fallback --quiet tests/scenes/arch.obj
}
check_windows() {
    if ! have $mingw || [ -z "$wine" ]; then skip "Windows: program and tests" "gcc-mingw-w64-x86-64-win32 wine64"; return; fi
    WINEDEBUG=-all WINEPREFIX=$(pwd)/$out/wine
    export WINEDEBUG WINEPREFIX
    part "Windows: program and tests compile" windows_runs
    count "Windows: tests under wine" windows_tests
    part "Windows: the program tells the same, byte for byte" windows_program
    part "Windows: a worker is told to need POSIX" windows_worker
}

side_by_side() {
    # shellcheck disable=SC2086
    printf '%s\n' $longest $groups | awk '!seen[$1]++' |
        xargs -P "$(nproc 2> /dev/null || echo 1)" -I{} sh -c "ONLY={} sh '$0' > $out/{}.log 2>&1"
}
joined() {                                              # joined GROUP: what it printed, and its numbers added
    jo_line=$(sed -n '$p' "$out/$1.log")
    if echo "$jo_line" | grep -qxE '[0-9]+ passed, [0-9]+ failed'; then
        sed '$d' "$out/$1.log" | grep -vE '^(skipped|seconds): '
        # shellcheck disable=SC2086
        set -- "$1" $jo_line
        passed=$((passed + $2)) failed=$((failed + $4))
        jo_skipped=$(grep '^skipped: ' "$out/$1.log") && skipped="$skipped
$jo_skipped"
    else
        failed=$((failed + 1))
        echo "FAILED  $1: no end"
        tail -n 20 "$out/$1.log"
    fi
}
# What each group took, slowest first.
slowest_first() {
    echo "seconds of processor, and by the clock:"
    for sf in $groups; do sed -n 's/^seconds: //p' "$out/$sf.log"; done | sort -k2,2 -n -r |
        awk '{ printf "    %-14s %7.0f %7.0f\n", $1, $2, $3; a += $2 } END { printf "    %-14s %7.0f\n", "all", a }'
}

# told GROUP BEFORE CLOCK PASSED FAILED: a line for trust.sh.
told() {
    if [ "${EVERY:-}" ]; then return; fi                # nightly.sh has its row
    awk -v a="$2" -v b="$spent" -v g="$1" -v day="$(date +%Y-%m-%d)" -v of="$(git rev-parse --short HEAD 2> /dev/null)" -v clock=$(($(date +%s) - $3)) \
        -v p="$4" -v f="$5" -v said="$(echo "${figure:-}" | tr '|\\' '/ ')" \
        'BEGIN { printf "%s,%s,%s,%d,%d,%.0f,%d,%s\n", g, day, of, p, f, b - a, clock, said }' >> build/told.csv
}

if [ "${ONLY:-}" ]; then
    for group in $groups; do
        case $group in *"$ONLY"*) ;; *) continue ;; esac
        spent
        before=$spent clock=$(date +%s) was_p=$passed was_f=$failed figure=
        check_"$group"
        spent
        told "$group" "$before" "$clock" "$((passed - was_p))" "$((failed - was_f))"
        echo "seconds: $group $(awk -v a="$before" -v b="$spent" 'BEGIN { print b - a }') $(($(date +%s) - clock))"
    done
else
    side_by_side
    for group in $groups; do joined "$group"; done
    slowest_first
fi
total
