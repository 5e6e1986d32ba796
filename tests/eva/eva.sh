#!/bin/sh
# eva: Frama-C Eva over the arena, index helpers, kernels and the certificate check, of any numbers: no alarm.
#
#     sh tests/eva/eva.sh [ENTRY...]      ends with `N passed, N failed`; Debian: frama-c-base
#
# Asked is what memory and whole numbers do; numbers may be infinite or none (-warn-special-float none). What is told apart path by
# path, for Eva knows no relation between two numbers: the sweeps a search of scales has taken, the blocks that are held, the
# corners of a block seen so far.
# Not asked: the walks of trees of cases (sp__refute_walk, sp__still_walk), which need that their stack is as deep as the states
# that were split, a relation Eva does not keep: a static assertion beside each says why, tests/proof walks them. Nor the form of
# shear (sp__certify_shear): by rows of a triangle one behind the other, of which Eva loses where each begins; it leaves alarms.
set -eu
cd tests/eva
apart() {                                               # apart FILE ENTRY
    case $1,$2 in
    *,eva_even)
        echo sp__shear_open:200,sp__shear_lead:200,sp__shear_flat:200,sp__shear_pairs:500 \
            sp__shear_joint:200,sp__shear_tree:100,sp__shear_at:20 | tr ' ' , ;;
    proof.c,*) echo sp__certifier_least_squares:300,sp__certifier_bilateral:300,sp__certifier_hold_small:100,sp__certifier_free_spin:100 ;;
    *) echo eva_pieces:2000,sp__take:2000,eva_csc:400,sp__sort:400,sp__sort_sink:400,sp__csc_fill:400,sp_csc_from:400 ;;
    esac
}
precision() {                                           # precision ENTRY: trees and pairs are told apart by the calls above instead
    case $1 in eva_even) echo '-eva-precision 0 -eva-auto-loop-unroll 6' ;; *) echo '-eva-precision 2' ;; esac
}
passed=0 failed=0
log=$(mktemp)
trap 'rm -f "$log"' EXIT
all=$(sed -n 's/^void \(eva_[a-z_]*\)(void).*/\1/p' base.c proof.c)
for entry in ${*:-$all}; do
    file=$(grep -l "^void $entry(void)" base.c proof.c)
    # shellcheck disable=SC2046
    if frama-c -eva $(precision "$entry") -eva-split-return full -eva-slevel-function "$(apart "$file" "$entry")" -warn-special-float none \
            -main "$entry" "$file" > "$log" 2>&1 && grep -q ' 0 alarms generated' "$log"; then
        passed=$((passed + 1))
        echo "ok      $entry: $(sed -n 's/.*these functions, \([0-9]* statements\) reached.*/\1/p' "$log")"
    else
        failed=$((failed + 1))
        echo "FAILED  $entry"
        grep -A 3 'eva:alarm\|User Error' "$log" | head -n 20
    fi
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
