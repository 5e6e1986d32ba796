#!/bin/sh
# models: files as others export them, answered without editing them.      models.sh [build/stonepack]
. "$(dirname "$0")/program.sh"
case $cli in /*) ;; *) cli=$PWD/$cli ;; esac
cd "$tmp" || exit 1

# What an exporter leaves: no supports, no friction, no contacts; y up, in mm.
bare() { sed '/^#@/d'; }
y_up_in_mm() { awk '/^#@/ { next } /^v / { printf "v %.9g %.9g %.9g\n", 1000 * $2, 1000 * $4, -1000 * $3; next } { print }'; }
first() { "$cli" "$@" | sed -n 1p; }
same() {                                                # same A B: what two runs print on standard output
    [ -n "$1" ] && [ "$1" = "$2" ] || { printf 'got:  %s\nwant: %s\n' "$1" "$2"; return 1; }
}
refuses() {                                             # refuses STATUS TEXT ARGUMENT...: one line with TEXT, nothing printed
    want=$1 text=$2
    shift 2
    "$cli" "$@" > out 2> err
    status=$?
    [ "$status" -eq "$want" ] && [ ! -s out ] && [ "$(wc -l < err)" -eq 1 ] && grep -q -e "$text" err && return 0
    echo "exit status $status, want $want"
    cat err
    return 1
}
forces() {                                              # largest compression, of what check prints
    "$cli" check "$@" | sed -n 's/^  forces *largest compression \(.*\) of a joint.*/\1/p'
}
beside_goes_with() {                                    # what stands beside, and options above it
    printf '#@ up y\n#@ unit mm\no b0\n#@ fixed\no b1?\n#@ fixed\n#@ density 2000\n#@ load b5 0 -10 0 0 900 100\n' > arch-y.obj.stonepack
    first check arch-y.obj > out
    "$cli" check --json arch-y.obj > json
    "$cli" check --unit cm --json arch-y.obj > other
    "$cli" check arch-y.obj > text
    rm arch-y.obj.stonepack
    same "$(cat out)" "arch-y.obj: STABLE" && grep -q 'remark .*arch-y.obj.stonepack' text &&
    grep -q '"free_blocks": *9,' json && grep -q '"text": *"more about this scene was read from arch-y.obj.stonepack' json &&
    ! same "$(sed 's/.*"max_compression": *\([^,]*\),.*/\1/' json)" "$(sed 's/.*"max_compression": *\([^,]*\),.*/\1/' other)" > out
}
beside_refused() {                                      # beside_refused TEXT LINES: the message names that file and the line
    printf '%b' "$2" > arch.obj.stonepack
    refuses 65 "^arch.obj.stonepack:2: .*$1" check arch.obj
    status=$?
    rm -f arch.obj.stonepack
    return $status
}

remarks() {                                             # remarks TEXT ARGUMENT...: in words and in JSON, once
    text=$1
    shift
    "$cli" check "$@" | grep '^  remark' > out
    cat out
    [ "$(grep -c -e "$text" out)" -eq 1 ] && "$cli" check --json "$@" | grep -q "\"remarks\": *\[{\"text\": *\"[^\"]*${text%%:*}"
}
quiet() { "$cli" check "$@" > out; ! grep remark out; }

"$cli" gen arch n=15 > whole.obj
bare < whole.obj > arch.obj
y_up_in_mm < whole.obj > arch-y.obj
scaled() { awk -v by="$1" '/^v / { print $1, by * $2, by * $3, by * $4; next } { print }' arch.obj; }
scaled 100 > arch-cm.obj
scaled 0.5 > arch-small.obj
{ echo '#@ density 2.4'; cat arch.obj; } > arch-light.obj
{ cat arch.obj; echo 'o far'; awk '/^v / { print $1, $2 + 50, $3, $4 } /^f / { print } /^o b1$/ { exit }' arch.obj |
    awk '/^v / { print } /^f / { print "f", $2 - 9, $3 - 9, $4 - 9, $5 - 9 }'; } > arch-far.obj
"$cli" gen h-model | sed '/^#@ gravity/d' > h-model.obj
"$cli" gen wall rows=3 bricks=3 > wall-whole.obj
awk '/^o /{ n++ } n != 1 || /^v /' wall-whole.obj | bare > wall.obj
y_up_in_mm < wall-whole.obj > wall-y.obj

part "nothing fixed: what to do about it"   sh -c "'$cli' check arch.obj | grep -q '^  remark .*no block is a support.*--fixed lowest'"
part "remark: y is up"                      remarks 'as if y were up: --up y' --fixed b0,b16 --unit mm arch-y.obj
part "remark: all are supports"              remarks 'every block is a support' --fixed lowest --unit mm arch-y.obj
part "remark: mm taken for m"               remarks '15 blocks are larger than 100 m.*: --unit mm' --fixed lowest --up y arch-y.obj
part "remark: cm taken for m"               remarks 'weighs .* t, more than any stone.*: --unit cm or mm' --fixed lowest arch-cm.obj
part "remark: m taken for mm"               remarks 'smaller than 1 mm.*: another --unit' --fixed lowest --unit mm arch-small.obj
part "remark: g/cm^3 taken for kg/m^3"      remarks 'density of 2.4 kg/m^3, less than any foam' --fixed lowest arch-light.obj
part "remark: a support far away"           remarks 'no support touches a block' --fixed far arch-far.obj
part "remark: down was told"                quiet --fixed b0,b16 --unit mm --gravity 0,0,-9.8 arch-y.obj
part "remark: nothing of a sound model"     quiet whole.obj
part "remark: a beam held by friction"      quiet h-model.obj
part "fixed: names"                         same "$(first check --fixed b0,b16 arch.obj)" "arch.obj: STABLE"
part "fixed: patterns"                      same "$(first check --fixed 'b?' --fixed 'b1*' arch.obj)" "arch.obj: STABLE"
part "fixed: the lowest"                    same "$(forces --fixed lowest arch.obj)" "$(forces whole.obj)"
part "fixed: no remark then"                sh -c "! '$cli' check --fixed lowest arch.obj | grep -q remark"
part "fixed: on every command"              sh -c "'$cli' limit --body 1,0,0 --fixed lowest arch.obj | grep -q 'MULTIPLIER 0' &&
    '$cli' sequence --fixed lowest arch.obj | grep -q 'steps' && '$cli' plan --fixed lowest arch.obj > out &&
    '$cli' convert --fixed lowest arch.obj | grep -c '^#@ fixed' | grep -qx 2 && '$cli' contacts --fixed lowest arch.obj > out"
part "fixed: a name that is not there: 64"  refuses 64 "arch.obj: --fixed 'b1,x'\|--fixed 'x\*': no block has such a name; there are b0, b1, b2, b3, \.\.\." check --fixed 'b1,x*' arch.obj
part "fixed: an empty list: 64"             refuses 64 'needs names' check --fixed '' arch.obj
part "fixed: ground"                        same "$(forces --fixed ground wall.obj)" "$(forces wall-whole.obj)"
part "fixed: ground, contacts told: 64"     refuses 64 'the file tells its contacts' check --fixed ground whole.obj
part "y up, mm: the same forces"            same "$(forces --fixed lowest --up y --unit mm arch-y.obj)" "$(forces whole.obj)"
part "gravity told instead"                 same "$(forces --fixed lowest --gravity 0,-9.80665,0 --unit mm arch-y.obj)" "$(forces whole.obj)"
part "a ground of y up, in mm"              same "$(first check --fixed ground --up y --unit mm wall-y.obj)" "wall-y.obj: STABLE"
part "upside down"                          same "$(first check --fixed lowest --up -y --unit mm arch-y.obj)" "arch-y.obj: UNSTABLE"
part "up and gravity: 64"                   refuses 64 'exclude each other' check --up y --gravity 0,0,-1 arch.obj
part "up: a wrong word: 64"                 refuses 64 'needs x, y, z' check --up up arch.obj
part "unit: a wrong word: 64"               refuses 64 'needs mm, cm, m or in' check --unit km arch.obj
part "a file beside the model"              beside_goes_with
part "beside: a name that is not there: 65" beside_refused "no block has such a name: 'x" '\no x\n'
part "beside: a support not there: 65"      beside_refused "supports 'x'" '\n#@ supports b0,x\n'
part "beside: no geometry"                  beside_refused 'the model has the geometry' '\nv 0 0 0\n'
part "beside: a bad unit: 65"               beside_refused 'unit is mm, cm, m or in' '\n#@ unit km\n'
part "beside: a load on nothing: 65"        beside_refused "block 'x', which does not exist" '\n#@ load x 0 0 0 0 0 0\n'
part "beside: fixed before any block: 65"   beside_refused "'fixed' before" '\n#@ fixed\n'

total
