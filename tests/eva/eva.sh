#!/bin/sh
# eva: Frama-C Eva over the arena, index helpers, kernels and all of solvers/proof/, of any numbers: no alarm.
#
#     sh tests/eva/eva.sh [ENTRY...]      ends with `N passed, N failed`; Debian: frama-c-base
#
# Asked is what memory and whole numbers do; numbers may be infinite or none (-warn-special-float none). Each piece of an arena
# is memory of its own. Not asked: what an arena's memory holds before it is written. Three kinds of entries:
#
#   wide.c     the certificate check at the capacities it is compiled for: one state stands for all passes of a loop, any
#              counts and any joints. A walk of a tree of cases is no deeper than the tree has nodes: Eva keeps a relation
#              (octagon) of what is compared, so a ghost compares the two in a copy of the walk. Trees have as many nodes as the
#              stack has room for splits. What a loop adds up beside its own count has no bound so.
#   proof.c    those sums, path by path, in a scene of two blocks: the corners of a block seen so far, where they are listed,
#              sweeps over rows, the pairs of blocks and the triangle of a form of shear. Walks of one vertex to its deepest
#              split (26 of refute.c, 12 of still.c; NODES nodes) tell apart the node and the depth of their stack.
#   linear.c   small.c, base.c: kernels of a given size and pattern, loop by loop; index helpers
#
# Annotations are put into copies by sed and change no statement.
set -eu
cd "$(dirname "$0")/../.."
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
for copy in wide proof; do
    mkdir -p "$tree/$copy/tests"
    cp -r stonepack.h solvers "$tree/$copy"
    cp -r tests/eva "$tree/$copy/tests"
done
nodes=$(sed -n 's/.* NODES = \([0-9]*\),.*/\1/p' tests/eva/proof.c)
loop='    for (int32_t k = 0; k < p->nodes; k++) {'
part='    while (.*state.* >> h > 7) h++;'
hints='4095, 8191, 67108863, 134217727'                  # bounds of states
ghost='/*@ ghost if (depth > k) deeper = 1; */'
for walk in refute still; do
    for copy in wide proof; do
        file=$tree/$copy/solvers/proof/$walk.c
        [ "$(grep -c "^$loop" "$file")$(grep -c "^$part" "$file")" = 11 ] || { echo "no one walk in $walk.c"; exit 1; }
    done
    sed -i "s|^$loop|    /*@ dynamic_split depth; */ /*@ loop unroll $nodes; */\\n&|" "$tree/proof/solvers/proof/$walk.c"
    file=$tree/wide/solvers/proof/$walk.c
    sed -i "s|^$loop|    /*@ ghost int deeper = 0; */\\n    /*@ widen_hints \"all\", $hints; */\\n&\\n        $ghost|
            s|^$part|    /*@ loop unroll 28; */\\n&|" "$file"
done
always=sp__load_unit:1000,sp__drop_held:300              # pointers that step along
apart() {                                               # apart FILE ENTRY: calls whose paths are told apart
    case $1,$2 in
    *,eva_even|*,eva_shear*)
        echo $always,sp__shear_open:200,sp__shear_lead:200,sp__shear_flat:200,sp__shear_pairs:500,sp__shear_joint:200 \
            sp__shear_tree:100,sp__shear_at:20,sp__shear_make:100,sp__certify_shear:100 | tr ' ' , ;;
    proof.c,*)
        echo $always,sp__certifier_least_squares:300,sp__certifier_bilateral:300,sp__certifier_hold_small:100 \
            sp__certifier_free_spin:100,sp__certify_refutation:100,sp__certify_still:100,sp__refute_unit:50 | tr ' ' , ;;
    linear.c,eva_words) echo sp_text:3000 ;;
    base.c,eva_rows) echo sp__problem_row:100 ;;
    base.c,eva_chol|base.c,eva_sort_many) echo sp__take:0 ;;
    base.c,*)
        echo eva_pieces:2000,sp__take:2000,eva_csc:400,sp__sort:400,sp__sort_sink:400,sp__csc_fill:400,sp_csc_from:400 ;;
    wide.c,eva_wide_triple) echo $always,sp__problem_points:100 ;;
    wide.c,eva_wide_still_whole) echo $always,sp__problem_points:100,sp__certify_still:100 ;;
    wide.c,eva_wide_shear) echo $always,sp__shear_lead:4 ;;
    wide.c,*) echo $always ;;
    *) echo sp__take:0 ;;
    esac
}
precision() {                                           # precision FILE ENTRY: loops that are unrolled, relations that are kept
    case $1,$2 in
    wide.c,*_walk|wide.c,*_whole)
        echo '-eva-precision 0 -eva-plevel 5000 -eva-auto-loop-unroll 6 -eva-domains symbolic-locations,octagon' ;;
    wide.c,*) echo '-eva-precision 0 -eva-plevel 5000 -eva-auto-loop-unroll 6 -eva-domains symbolic-locations,gauges' ;;
    linear.c,eva_lp|linear.c,eva_simplex) echo '-eva-precision 0 -eva-min-loop-unroll 8 -eva-domains symbolic-locations' ;;
    linear.c,eva_groups|linear.c,eva_cg|small.c,*) echo '-eva-precision 0 -eva-auto-loop-unroll 20' ;;
    linear.c,eva_words) echo '-eva-precision 0 -eva-min-loop-unroll 25' ;;
    linear.c,*) echo '-eva-precision 0 -eva-min-loop-unroll 100' ;;
    *,eva_rows) echo '-eva-precision 0 -eva-min-loop-unroll 12' ;;
    *,eva_chol) echo '-eva-precision 0 -eva-min-loop-unroll 25 -eva-plevel 400' ;;
    *,eva_sort_many) echo '-eva-precision 0 -eva-plevel 5000' ;;
    *,eva_even) echo '-eva-precision 0 -eva-auto-loop-unroll 6' ;;
    *,eva_shear*) echo '-eva-precision 0 -eva-min-loop-unroll 14' ;;
    *_walk|*_whole) echo '-eva-precision 0 -eva-auto-loop-unroll 26' ;;
    *) echo '-eva-precision 2' ;;
    esac
}
passed=0 failed=0
log=$tree/log
: > "$tree/reached"
cd tests/eva
files='base.c linear.c small.c proof.c wide.c'
# shellcheck disable=SC2086
all=$(sed -n 's/^void \(eva_[a-z_]*\)(void).*/\1/p' $files)
for entry in ${*:-$all}; do
    # shellcheck disable=SC2086
    file=$(grep -l "^void $entry(void)" $files)
    case $file in wide.c) cd "$tree/wide/tests/eva" ;; *) cd "$tree/proof/tests/eva" ;; esac
    begun=$(date +%s)
    # shellcheck disable=SC2046
    if frama-c -eva -machdep gcc_x86_64 $(precision "$file" "$entry") -eva-slevel-function "$(apart "$file" "$entry")" \
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
