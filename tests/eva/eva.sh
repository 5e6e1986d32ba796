#!/bin/sh
# eva: Frama-C Eva over the arena, index helpers, kernels and all of solvers/proof/, of any numbers: no alarm.
#
#     sh tests/eva/eva.sh [ENTRY...]      ends with `N passed, N failed`; Debian: frama-c-base
#
# Asked is what memory and whole numbers do; numbers may be infinite or none (-warn-special-float none). What is told apart path
# by path, for Eva knows no relation between two numbers: the sweeps a search of scales has taken, the blocks that are held, the
# corners of a block seen so far, the pairs of blocks of a form of shear. Loops over the rows of its triangles are unrolled.
# The walks of trees of cases (sp__refute_walk, sp__still_walk) are told apart by the node they are at and by how deep their
# stack is: a state that was split d times then lies between two numbers. That takes two annotations above the loop of each; a
# copy gets them below, and they change no statement. Asked are trees of at most NODES nodes of one vertex, the deepest one
# among them (26 splits of refute.c, 12 of still.c), and of FEW nodes of four. Each piece of an arena is memory of its own.
# Not asked: that the stack is as deep as a longer tree of several vertices splits, for which there would have to be a state of
# each; a static assertion beside each walk says why it is. Nor what an arena's memory holds before it is written.
set -eu
cd "$(dirname "$0")/../.."
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree/tests"
cp -r stonepack.h solvers "$tree"
cp -r tests/eva "$tree/tests"
nodes=$(sed -n 's/.* NODES = \([0-9]*\),.*/\1/p' tests/eva/proof.c)
for walk in refute still; do
    copy=$tree/solvers/proof/$walk.c
    loop='    for (int32_t k = 0; k < p->nodes; k++) {'
    sed -i "s|^$loop|    /*@ dynamic_split depth; */ /*@ loop unroll $nodes; */\\n&|" "$copy"
    [ "$(grep -c dynamic_split "$copy")" = 1 ] || { echo "no one walk in $walk.c"; exit 1; }
done
cd "$tree/tests/eva"
apart() {                                               # apart FILE ENTRY
    case $1,$2 in
    *,eva_even|*,eva_shear*)
        echo sp__shear_open:200,sp__shear_lead:200,sp__shear_flat:200,sp__shear_pairs:500,sp__shear_joint:200 \
            sp__shear_tree:100,sp__shear_at:20,sp__shear_make:100,sp__certify_shear:100 | tr ' ' , ;;
    proof.c,*)
        echo sp__certifier_least_squares:300,sp__certifier_bilateral:300,sp__certifier_hold_small:100 \
            sp__certifier_free_spin:100,sp__certify_refutation:100,sp__certify_still:100,sp__refute_unit:50 | tr ' ' , ;;
    *) echo eva_pieces:2000,sp__take:2000,eva_csc:400,sp__sort:400,sp__sort_sink:400,sp__csc_fill:400,sp_csc_from:400 ;;
    esac
}
precision() {                                           # precision ENTRY: calls above and loops are told apart instead
    case $1 in
    eva_even) echo '-eva-precision 0 -eva-auto-loop-unroll 6' ;;
    eva_shear*) echo '-eva-precision 0 -eva-min-loop-unroll 14' ;;
    *_walk|*_whole) echo '-eva-precision 0 -eva-auto-loop-unroll 26' ;;
    *) echo '-eva-precision 2' ;;
    esac
}
passed=0 failed=0
log=$tree/log
: > "$tree/reached"
all=$(sed -n 's/^void \(eva_[a-z_]*\)(void).*/\1/p' base.c proof.c)
for entry in ${*:-$all}; do
    file=$(grep -l "^void $entry(void)" base.c proof.c)
    begun=$(date +%s)
    # shellcheck disable=SC2046
    if frama-c -eva -machdep gcc_x86_64 $(precision "$entry") -eva-slevel-function "$(apart "$file" "$entry")" \
            -eva-alloc-builtin fresh -eva-no-alloc-returns-null -eva-split-return full -warn-special-float none \
            -main "$entry" "$file" > "$log" 2>&1 \
            && grep -q ' 0 alarms generated' "$log" && ! grep -q 'implicit-function-declaration' "$log"; then
        passed=$((passed + 1))
        statements=$(sed -n 's/.*these functions, \([0-9]* statements\) reached.*/\1/p' "$log")
        echo "ok      $entry: $statements, $(($(date +%s) - begun)) s"
    else
        failed=$((failed + 1))
        echo "FAILED  $entry"
        grep -A 3 'eva:alarm\|User Error\|implicit-function' "$log" | head -n 20
    fi
    sed -n 's/.*Values at end of function \([a-z0-9_]*\):.*/\1/p' "$log" >> "$tree/reached"
done
if [ $# = 0 ]; then                                     # no function of solvers/proof/ is left out
    defined='s/^\(SP__NOINLINE[A-Z_]* \)*static [^=;]*[ *]\(sp__[a-z0-9_]*\)(.*/\2/p'
    for name in $(sed -n "$defined" ../../solvers/proof/*.c); do
        grep -qx "$name" "$tree/reached" || { failed=$((failed + 1)); echo "FAILED  $name is not reached"; }
    done
fi
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
