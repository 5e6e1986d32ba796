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
beside_marked() {                                       # as editors of Windows write it: byte order mark, CR LF
    printf '\357\273\277#@ mu 0.1\r\n#@ unit mm\r\n' > arch.obj.stonepack
    "$cli" convert arch.obj > out 2> err
    status=$?
    rm arch.obj.stonepack
    [ $status -eq 0 ] && grep -q '^#@ mu 0\.1' out
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
"$cli" gen two-cubes | awk '/^o / { print $1, n++ ? "stone" : "ground"; next } !/interface/ { print }' > joint-far.obj
echo '#@ interface ground stone 0 0 50 1 0 50 1 1 50 0 1 50' >> joint-far.obj
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
part "remark: friction told by its angle"   remarks "friction of 'b1' and 'b2' is 35, more than of any stones.*: --mu 0.7" --mu 35 wall-whole.obj
part "remark: nothing slides, as meant"     quiet --mu 1e6 wall-whole.obj
part "remark: a joint off its blocks"       remarks "1 joint lies off the blocks told for it, that of 'ground' and 'stone'" joint-far.obj
part "remark: down was told"                quiet --fixed b0,b16 --unit mm --gravity 0,0,-9.8 arch-y.obj
part "remark: nothing of a sound model"     quiet whole.obj
part "remark: a beam held by friction"      quiet h-model.obj
# Two flat arches side by side, whose wedges lean by a few degrees: as compas_dem's barrel vault.
"$cli" gen arch n=9 half=5 radius=20 t=0.02 ends=1 | awk '/^#@ interface/ { next } { print } /^v /{ y = $3; $3 += 0.5; m[++n] = $0; next }
    /^o / { $2 = "c" $2 } /^f / { for (k = 2; k <= NF; k++) $k += 72 } { m[++n] = $0 } END { for (k = 1; k <= n; k++) print m[k] }' > flat.obj
part "remark: stones of a flat vault rest"  quiet flat.obj
# Each vertex moved on its own by up to d: jitter SEED D < SCENE; its own contacts are left out.
jitter() { awk -v seed="$1" -v d="$2" 'BEGIN { srand(seed) } /^#@ (interface|points)/ { next }
    /^v / { printf "v"; for (k = 2; k < 5; k++) printf " %.17g", $k + d * (2 * rand() - 1); print ""; next } { print }'; }
touching() { "$cli" contacts --json "$@" | tr -d ' \n' | grep -o '"a":"[^"]*","b":"[^"]*"' | sort -u; }
honest() {                                              # honest MODEL VERDICT PAIRS: without an option as of the exact model, or told
    "$cli" check "$1" > out
    sed -n 1p out | grep -q 'but [0-9]* pairs\{0,1\} of blocks nearly touch' && return 0
    same "$(sed -n 1p out)" "$1: $2" || return 1        # it stands, whatever is missing
    touching "$1" | comm -13 - "$3" > missing
    [ ! -s missing ] || grep -q '^  remark .* nearly touch .*--contact-distance' out
}
seed=0
jittered() {                                            # jittered MODEL: 4 d counts all joints, and the verdict is the exact one
    want=$(first check "$1"); want=${want#*: }
    touching "$1" > exact
    for d in 1e-9 1e-8 1e-7 2e-7 5e-7 1e-6 1e-5 1e-4 1e-3; do
        seed=$((seed + 1))
        jitter $seed $d < "$1" > jittered.obj
        near=$(awk -v d=$d 'BEGIN { print 4 * d }')
        honest jittered.obj "$want" exact || { echo "seed $seed, d $d: another verdict or a joint missing, and nothing tells"; return 1; }
        same "$(first check --contact-distance $near jittered.obj)" "jittered.obj: $want" || { echo "seed $seed, d $d"; return 1; }
        touching --contact-distance $near jittered.obj | cmp - exact || { echo "seed $seed, d $d: other joints"; return 1; }
    done
}
halves() {                                              # all pairs touch, some by a half of their faces, and so it falls
    jitter 6 1e-6 < whole.obj > jittered.obj
    same "$(touching jittered.obj)" "$(touching whole.obj)" && honest jittered.obj STABLE /dev/null
}
misses() {                                              # misses MODEL D: told in the first line; the option of the remark helps
    jitter 7 "$2" < "$1" > jittered.obj
    first check jittered.obj | tee out | grep -q 'UNSTABLE, but [0-9]* pairs of blocks nearly touch$' || return 1
    "$cli" check --json jittered.obj | grep -o '"option": *"--contact-distance [^"]*' | sed 's/.*"//' > option
    same "$(first check $(cat option) jittered.obj)" "jittered.obj: STABLE"
}
told_by() {                                             # told_by "COMMAND" [first]: words, JSON, picture; the first line, too
    jitter 7 1e-4 < whole.obj > jittered.obj
    # shellcheck disable=SC2086
    "$cli" $1 jittered.obj > out 2> err
    cat out err | grep -q '^  remark .* nearly touch .*--contact-distance 0.1%$' || { echo "words"; cat out; return 1; }
    [ -z "${2-}" ] || sed -n 1p out | grep -q ', but 16 pairs of blocks nearly touch$' || { echo "first line"; cat out; return 1; }
    [ "$1" != convert ] || return 0
    # shellcheck disable=SC2086
    "$cli" $1 --json jittered.obj | tr -d ' \n' > json
    grep -q '"touching":{[^}]*"near_pairs":16},"remarks":\[{"text":"16pairs' json || { echo "JSON"; cat json; return 1; }
    case $1 in plan* | contacts*) return 0 ;; esac
    # shellcheck disable=SC2086
    "$cli" $1 --svg nears.svg jittered.obj > out
    grep -q 'mind: 16 pairs of blocks nearly touch' nears.svg && grep -q '[ >]--contact-distance 0.1%<' nears.svg || { echo "picture"; return 1; }
    rm nears.svg
}
verify_tells() {                                        # its first line, too, of what falls; of a sliding state
    jitter 7 1e-4 < whole.obj > jittered.obj
    "$cli" check --json --forces jittered.obj > result.json
    "$cli" verify jittered.obj result.json 2> err | grep -q '^jittered.obj: unstable by .*, but 16 pairs of blocks nearly touch$' || return 1
    grep -q 'nearly touch .*--contact-distance 0.1%$' err || return 1
    "$cli" check --json --forces whole.obj > result.json
    "$cli" verify whole.obj result.json > out && ! grep nearly out
}
# Triangles with coordinates rounded to 1e-6 m, as many exporters write them; its own contacts are left out.
rounded() { awk '/^#@ interface/ { next } /^v / { printf "v %.6f %.6f %.6f\n", $2, $3, $4; next }
    /^f / { for (k = 3; k < NF; k++) print "f", $2, $k, $(k + 1); next } { print }'; }
pairs() { "$cli" contacts "$@" | awk '$2 != "contacts" && $4 ~ /^[0-9]+$/ { print $1, $2 }' | sort -u; }
keeps() {                                               # keeps MODEL ARGUMENT...: rounded it has the same pairs and verdict
    model=$1
    shift
    want=$(first check "$model")
    rounded < "$model" > rounded.obj
    same "$(pairs "$@" rounded.obj)" "$(pairs "$model")" && same "$(first check "$@" rounded.obj)" "rounded.obj: ${want#*: }"
}
in_a_file() {                                           # the same words in the scene
    jitter 7 1e-4 < wall-whole.obj > jittered.obj
    printf '#@ contact_distance 0.1%%\n#@ contact_angle 1\n' >> jittered.obj
    same "$(first check jittered.obj)" "jittered.obj: STABLE" &&
    first check --contact-angle 0 jittered.obj | grep -q 'UNSTABLE, but'
}

# How contacts and verdict depend on the distance: a row each, one in force, the same in JSON.
swept() {
    jitter 7 1e-5 < whole.obj > jittered.obj
    "$cli" contacts --sweep jittered.obj > out
    cat out
    grep -q '^jittered.obj: STABLE with 16 pairs that touch, the same from 0.00[0-9]*% to 1%$' out || return 1
    [ "$(grep -c '[0-9]% .*STABLE$' out)" -eq 13 ] && [ "$(grep -c '^\* 0.0001% .*UNSTABLE$' out)" -eq 1 ] || return 1
    for share in 0.0001% 0.001% 1%; do
        pairs=$(awk -v share=$share '{ sub(/^\*/, " ") } $1 == share { print $4, "contacts" }' out)
        "$cli" contacts --quiet --contact-distance $share jittered.obj | grep -q "^$pairs " || { echo "$share: $pairs"; return 1; }
        verdict=$(awk -v share=$share '{ sub(/^\*/, " ") } $1 == share { print $NF }' out)
        first check --quiet --contact-distance $share jittered.obj | grep -q ": $verdict" || { echo "$share: $verdict"; return 1; }
    done
    "$cli" contacts --sweep --json jittered.obj | tr -d ' ' > json
    [ "$(grep -o '"least_distance"' json | wc -l)" -eq 13 ] && grep -q '"steady":{"from":.*,"to":0.01,"pairs":16,"verdict":"stable"}' json
}
sweep_in_force() {                                      # a distance between two of the rows has its own, in metres, mm or %
    "$cli" contacts --sweep --contact-distance 4e-5 whole.obj | grep -c '^\* 0.00714.*4e-05' | grep -qx 1 &&
    "$cli" contacts --sweep --contact-distance 2% whole.obj | grep -A1 '^  1% ' | grep -q '^\* 2% ' &&
    "$cli" contacts --sweep --contact-distance 0 whole.obj | grep -q '^\* 0% '
}
sweep_of_nothing() {
    "$cli" gen two-cubes offset=0.3 | awk '/^#@ interface/ { next } /^o /{ n++ } /^v / && n == 2 { $4 += 5 } { print }' > apart.obj
    first contacts --sweep apart.obj | grep -q 'nothing touches at any distance' || return 1
    printf 'o a\n#@ fixed\no b\n#@ fixed\n' > bare.obj
    refuses 65 'no block has faces' contacts --sweep bare.obj
}

# A half cylinder of $1 facets in a cradle of $2 facets on 140 degrees, radius and length 1: prisms along y.
cradle() {
    awk -v m="$1" -v q="$2" 'function point(x, z) { X[n] = x; Z[n++] = z }
        function arc(facets, a, b,   k) { for (k = 0; k <= facets; k++) point(cos(a + (b - a) * k / facets), sin(a + (b - a) * k / facets)) }
        function prism(name,   k, s) {
            print name
            for (k = 0; k < n; k++) printf "v %.17g 0 %.17g\nv %.17g 1 %.17g\n", X[k], Z[k], X[k], Z[k]
            s = "f"; for (k = 0; k < n; k++) s = s " " (at + 2 * k + 1); print s
            s = "f"; for (k = n - 1; k >= 0; k--) s = s " " (at + 2 * k + 2); print s
            for (k = 0; k < n; k++) { s = (k + 1) % n; print "f", at + 2 * k + 1, at + 2 * k + 2, at + 2 * s + 2, at + 2 * s + 1 }
            at += 2 * n; n = 0
        }
        BEGIN {
            pi = atan2(0, -1)
            arc(m, pi, 2 * pi); prism("o half")
            point(-1.2, -1.3); point(1.2, -1.3); point(1.2, sin(-pi / 9))
            arc(q, 17 * pi / 9, 10 * pi / 9); point(-1.2, sin(-pi / 9)); prism("o cradle\n#@ fixed")
        }'
}
curved() {                                              # curved M Q D: found at D, all 140 degrees of the cylinder, in patches
    cradle "$1" "$2" > curved.obj
    "$cli" contacts --contact-distance "$3" curved.obj | awk '$1 == "half" { n++; area += $3 }
        END { print n, area; exit !(n >= 10 && area > 2.3 && area < 2.4435) }' &&
    same "$(first check --contact-distance "$3" curved.obj)" "curved.obj: STABLE" &&
    first check curved.obj | grep -q '^curved.obj: UNSTABLE, but 1 pair of blocks nearly touches$'
}

slate() {                                               # slate NAME X Z AT: 0.3 x 0.2 x 0.001
    awk -v name="$1" -v x="$2" -v z="$3" -v at="$4" 'BEGIN { n = split("0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1", v, " ")
        print "o", name
        for (k = 1; k < n; k += 3) print "v", x + v[k] * 0.3, v[k + 1] * 0.2, z + v[k + 2] * 0.001
        m = split("4 3 2 1,5 6 7 8,1 2 6 5,2 3 7 6,3 4 8 7,4 1 5 8", f, ",")
        for (k = 1; k <= m; k++) { split(f[k], c, " "); print "f", c[1] + at, c[2] + at, c[3] + at, c[4] + at } }'
}
slates() {                                              # two thirds of the upper hang over: it falls, and nothing nearly touches
    { slate support 0 0 0; slate lower 0 0.001 8; slate upper 0.2 0.002 16; } > slates.obj
    same "$(first check --fixed support slates.obj)" "slates.obj: UNSTABLE" || return 1
    for d in 0.1% 1% 0.004 50%; do
        same "$(first check --fixed support --contact-distance $d slates.obj)" "slates.obj: UNSTABLE" || return 1
        "$cli" contacts --contact-distance $d slates.obj | grep -q '^2 contacts' || { echo "$d: not 2 contacts"; return 1; }
    done
}

leaf() {                                                # leaf NAME X0 X1 Z0 Z1 AT: 1 deep
    awk -v name="$1" -v a="$2" -v b="$3" -v lo="$4" -v hi="$5" -v at="$6" 'BEGIN {
        n = split("0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1", v, " ")
        print "o", name
        for (k = 1; k < n; k += 3) print "v", v[k] ? b : a, v[k + 1], v[k + 2] ? hi : lo
        m = split("4 3 2 1,5 6 7 8,1 2 6 5,2 3 7 6,3 4 8 7,4 1 5 8", f, ",")
        for (k = 1; k <= m; k++) { split(f[k], c, " "); print "f", c[1] + at, c[2] + at, c[3] + at, c[4] + at } }'
}
bridged_told() {                                        # a cube on a leaf under its edge falls, unless it is joined across the leaf
    { leaf floor 0 1 -1 0 0; leaf sheet 0 0.1 0 0.001 8; leaf cube 0 1 0.001 1 16; } > sheet.obj
    same "$(first check --fixed floor --contact-distance 0.0005 sheet.obj | cut -d, -f1)" "sheet.obj: UNSTABLE" &&
    same "$(first check --fixed floor --contact-distance 1% sheet.obj)" "sheet.obj: STABLE, but 1 joint reaches across a block" &&
    same "$(first limit --body 1,0,0 --fixed floor --contact-distance 1% sheet.obj | cut -d, -f2)" " but 1 joint reaches across a block" &&
    remarks "that of 'floor' and 'cube' across 'sheet'" --fixed floor --contact-distance 1% sheet.obj
}

bridge_left_out() {                                     # no distance across the leaf is proposed; a gap beside it is, by its own
    same "$(first check --fixed floor sheet.obj)" "sheet.obj: UNSTABLE" || return 1
    { leaf floor 0 1 -1 0 0; leaf sheet 0 0.1 0 0.001 8; leaf cube 0 1 0.00101 1 16; } > gap.obj
    same "$(first check --fixed floor gap.obj)" "gap.obj: UNSTABLE, but 1 pair of blocks nearly touches" &&
    remarks ': --contact-distance 0.001%$' --fixed floor gap.obj
}

ledges() { leaf left -1 0.003 -1 0 0; leaf right 0.997 2 -1 0 8; leaf beam 0 1 "$1" 0.3 16; }
narrow_kept() {                                         # a beam that bears 3 mm at each end, of faces in one plane to the bit
    ledges 0 > ledges.obj
    for d in 0.001 0.01 5% 50%; do
        same "$(first check --fixed left,right --contact-distance $d ledges.obj)" "ledges.obj: STABLE" || return 1
    done
    "$cli" check --fixed left,right --contact-distance 0.01 ledges.obj | grep remark && return 1
    return 0
}
narrow_told() {                                         # 2e-7 m above, which the default distance counts
    ledges 2e-7 > ledges.obj
    same "$(first check --fixed left,right ledges.obj)" "ledges.obj: STABLE" &&
    same "$(first check --fixed left,right --contact-distance 0.01 ledges.obj)" "ledges.obj: UNSTABLE, but 2 pairs of blocks nearly touch" &&
    remarks '2 pairs of blocks touch where it is narrower than the contact distance.*: --contact-distance$' --fixed left,right --contact-distance 0.01 ledges.obj
}

inside_told() {                                         # a stone sunk into its support by a tenth
    on_floor -0.1 -0.1 > sunk.obj
    same "$(first check sunk.obj)" "sunk.obj: UNSTABLE, but 1 pair of blocks lies inside each other" && remarks 'lies inside each other and does not touch: floor and cube' sunk.obj
}
twice_told() {                                          # each stands alone, at the place of the other
    { on_floor 0 0; on_floor 0 0 | awk '/^o cube/ { on = 1; print "o copy"; next } on && /^v/ { print }
        on && /^f/ { print "f", $2 + 8, $3 + 8, $4 + 8, $5 + 8 }'; } > twice.obj
    same "$(first check twice.obj)" "twice.obj: STABLE, but 1 pair of blocks lies inside each other" && remarks 'cube and copy by 1 m' twice.obj
}

told() { "$cli" check --json "$@" | grep -o '"touching": *[^}]*' | tr -d ' '; }
distance_in_json() {                                    # the distance in force, and how many pairs nearly touch
    jitter 7 1e-4 < whole.obj > jittered.obj
    "$cli" check --json whole.obj | grep -q '"touching": *null' &&
    same "$(told --contact-distance 5e-4 jittered.obj)" '"touching":{"distance":0.0005,"share":false,"angle":null,"near_pairs":0' &&
    told --contact-distance 25% --contact-angle 30 jittered.obj | grep -q '"distance":0.25,"share":true,"angle":\(30\|29.99\).*"near_pairs":0' &&
    told jittered.obj | grep -q '"share":true,.*"near_pairs":16'
}
in_millimetres() {                                      # the distance is in metres, whatever the unit of the model
    jitter 7 1e-4 < whole.obj | y_up_in_mm > jittered.obj
    same "$(first check --fixed b0,b16 --up y --unit mm --contact-distance 4e-4 jittered.obj)" "jittered.obj: STABLE" &&
    printf '#@ unit mm\n#@ up y\n#@ supports b0,b16\n#@ contact_distance 0.0004\n' > jittered.obj.stonepack &&
    same "$(first check jittered.obj)" "jittered.obj: STABLE"
    status=$?
    rm -f jittered.obj.stonepack
    return $status
}

# Faces that are there twice count once: listed again, begun at another corner, or of a second shell with its own vertices.
awk '/^f / { print } /^f / && name == "b5" { print $1, $3, $4, $5, $2 } /^o / { name = $2 } !/^f /' arch.obj > listed-twice.obj
awk '{ print } /^o / { n = 0 } /^v / { v[n++] = $0; all++ } /^f / && n { f[all / 8, c[all / 8]++] = $0 } END {
    for (k = 0; k < n; k++) print v[k]
    for (k = 0; k < c[all / 8]; k++) { split(f[all / 8, k], w, " "); print "f", w[2] + 8, w[3] + 8, w[4] + 8, w[5] + 8 } }' arch.obj > shell-twice.obj
counts_once() {                                         # counts_once MODEL FACES ARGUMENT...: the forces of the arch, and it is told
    model=$1 faces=$2
    shift 2
    same "$("$cli" convert "$@" "$model" 2> err | grep -c '^f ')" "$(grep -c '^f ' arch.obj)" || return 1
    grep -q "remark .*$faces faces of 1 block, the first '.*', were there twice: counted once" err || { cat err; return 1; }
    same "$(forces "$@" "$model")" "$(forces "$@" arch.obj)"
}
# A file that is one object without a name, named after it; its shells; what has no faces.
grep '^[vf]' wall.obj > 'a wall.obj'
{ echo 'o Camera'; cat arch.obj; printf 'o Curve\nl 1 2\n'; } > curves.obj
one_block() {
    same "$("$cli" convert "$@" 'a wall.obj' 2> err | grep '^o ')" "$(printf 'o a_wall')"
}
shells() {
    same "$("$cli" convert --quiet --split 'a wall.obj' | grep -c '^o a_wall[.][0-9]*$')" "$(grep -c '^o ' wall.obj)" &&
    same "$(forces --split --fixed ground 'a wall.obj')" "$(forces --fixed ground wall.obj)"
}
turned_shells() {                                       # stones that share faces, along no axis: how joints are rounded tells nothing
    for scene in 'flat-arch n=7' 'arch n=15' 'tower n=6 lean=0'; do
        for turn in 0.3 1 2 3.7 5; do
            "$cli" gen $scene | awk -v t=$turn '/^v / { x = cos(t) * $2 - sin(t) * $3; y = sin(t) * $2 + cos(t) * $3
                printf "v %.7f %.7f %.7f\n", x, cos(t) * y - sin(t) * $4, sin(t) * y + cos(t) * $4 } /^f /' > turned.obj
            same "$scene: $("$cli" convert --quiet --split turned.obj | grep -c '^o ')" "$scene: $("$cli" gen $scene | grep -c '^o ')" || return 1
        done
    done
}
crossed_shells() {                                      # a cube on a cube; of the warped face between them each has its own triangles
    for lift in 1.006 0.994; do
        printf 'v %s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' '0 0 1' '1 0 1' "1 1 $lift" '0 1 1' '0 0 2' '1 0 2' '1 1 2' '0 1 2' > crossed.obj
        printf 'f %s\n' '4 3 2 1' '5 6 7' '5 7 8' '1 2 6 5' '2 3 7 6' '3 4 8 7' '4 1 5 8' \
            '6 5 8' '6 8 7' '9 10 11 12' '5 6 10 9' '6 7 11 10' '7 8 12 11' '8 5 9 12' >> crossed.obj
        same "$lift: $("$cli" convert --quiet --split crossed.obj | grep -c '^o ')" "$lift: 2" || return 1
    done
}
unlike_sizes() {                                        # the face between them is warped by 1.5 % of the one, 0.5 % of the other
    for order in '6 5 8 7' '5 8 7 6' '8 7 6 5' '7 6 5 8'; do
        printf 'v %s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' '0 0 1' '1 0 1' '1 1 1.06' '0 1 1' '0 0 4' '1 0 4' '1 1 4' '0 1 4' > unlike.obj
        printf '%s\n' 'o low' 'f 4 3 2 1' 'f 5 6 7 8' 'f 1 2 6 5' 'f 2 3 7 6' 'f 3 4 8 7' 'f 4 1 5 8' \
            'o high' "f $order" 'f 9 10 11 12' 'f 5 6 10 9' 'f 6 7 11 10' 'f 7 8 12 11' 'f 8 5 9 12' >> unlike.obj
        same "$(first check --fixed low unlike.obj)" "unlike.obj: STABLE" &&
        remarks "2 warped faces of 2 blocks, the first 'low', were cut" --fixed low unlike.obj > out || { cat out; return 1; }
    done
}
part "a warped face is cut as the one it meets" unlike_sizes
part "no o line: one block, named as the file" one_block
part "no o line, --split: its shells"       shells
part "--split: shells that share faces, turned" turned_shells
part "--split: a face they share, cut two ways" crossed_shells
part "from a pipe: the block is 'block'"    sh -c "'$cli' convert - < 'a wall.obj' 2> err | grep -qx 'o block'"
part "objects without faces: passed over"   remarks "2 objects without faces, the first 'Camera', were passed over" --fixed lowest curves.obj
part "the same answer as without them"      same "$(forces --fixed lowest curves.obj)" "$(forces --fixed lowest arch.obj)"
part "faces listed twice count once"        counts_once listed-twice.obj 6 --fixed b0,b16
part "a shell that is there twice"          counts_once shell-twice.obj 6 --fixed b0,b15
part "the same with --split"                counts_once shell-twice.obj 6 --split --fixed b0,b15

on_floor() {                                            # a cube on z = 0 whose bottom is at $1 where x = 0, at $2 where x = 1
    awk -v l="$1" -v r="$2" 'BEGIN { n = split("0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1", v, " ")
        split("1 4 3 2,5 6 7 8,1 2 6 5,2 3 7 6,3 4 8 7,4 1 5 8", f, ",")
        for (b = 0; b < 2; b++) {
            print b ? "o cube" : "o floor\n#@ fixed"
            for (k = 1; k < n; k += 3)
                print "v", v[k] * (b ? 1 : 3) - !b, v[k + 1] * (b ? 1 : 3) - !b, b ? v[k + 2] + (v[k] ? r : l) : v[k + 2] - 1
            for (k = 1; k <= 6; k++) {
                split(f[k], c, " ")
                print "f", c[1] + 8 * b, c[2] + 8 * b, c[3] + 8 * b, c[4] + 8 * b
            }
        } }'
}
area() {                                                # area WANTED ARGUMENT...: of the only contact, to 1e-4
    want=$1
    shift
    "$cli" contacts "$@" | awk -v want="$want" '$1 == "floor" { n++; a = $3 } END { print n, a; exit !(n == 1 && a < want + 1e-4 && a > want - 1e-4) }'
}
on_floor 0 1e-5 > edge.obj
on_floor -9e-4 9e-4 > middle.obj
on_floor 1e-4 1e-4 > gap.obj
on_floor -1e-4 -1e-4 > deep.obj
between() { "$cli" contacts --json --contact-distance 2e-4 "$1" | tr -d ' \n' | grep -q "$2"; }
part "tilted about an edge: a strip"        area 0.1 --contact-distance 1e-6 edge.obj
part "the same at the default distance"     area 0.17320508 edge.obj    # 1e-6 of sqrt 3, over 1e-5
part "tilted about the middle: a strip"     area 0.2222 --contact-distance 2e-4 --contact-angle 1 middle.obj
part "tilted, all within: the whole"        area 1 --contact-distance 1e-3 middle.obj
part "a gap: the whole face"                area 1 --contact-distance 2e-4 gap.obj
part "a gap: the plane between"             between gap.obj '"points":.*4\.9*[0-9]*e-05\|5e-05\|5\.0[0-9]*e-05'
part "an overlap: the whole face"           area 1 --contact-distance 2e-4 deep.obj

"$cli" gen wall rows=10 bricks=15 > wall-150.obj
"$cli" gen dome > dome.obj
"$cli" gen arch n=15 t=0.09 > thin.obj
# Of 4 d all joints and the exact verdict; without it the same, or the first line says why not.
part "jitter: arch of 15, 4 d, or told"     jittered whole.obj
part "jitter: wall of 150, 4 d, or told"    jittered wall-150.obj
part "jitter: dome, 4 d, or told"           jittered dome.obj
part "jitter: an arch that falls, 4 d"      jittered thin.obj
part "jitter: halves of faces that touch"   halves
part "a dome rounded to 1e-6"               keeps dome.obj
part "the same with the distance told"      keeps dome.obj --contact-distance 4e-6
part "near misses of a dome are told"       misses dome.obj 1e-5
part "near misses of an arch are told"      misses whole.obj 1e-5
part "near misses of a wall are told"       misses wall-150.obj 1e-4
for command in check "check --coupled" "check --strong" "limit --body 1,0,0" "limit --tilt-margin" sequence cost "contacts --sweep"; do
    part "near misses told by $command"     told_by "$command" first
done
part "near misses told by verify"          verify_tells
for command in plan contacts convert; do
    part "near misses told by $command"     told_by "$command"
done
part "curved: facets of one in the other's" curved 24 17 0.0025
part "curved: fewer facets than the cradle" curved 9 14 0.03
part "curved: as many, at other places"     curved 100 100 0.0003
part "no distance reaches through a slate"  slates
part "a joint across a sheet is told"       bridged_told
part "no distance across a thin block is proposed" bridge_left_out
part "an exact contact narrower than the distance is kept" narrow_kept
part "another one is told"                  narrow_told
part "a sunk stone is told, not only felled" inside_told
part "two stones at one place are told"     twice_told
part "contacts --sweep: a row a distance"   swept
part "contacts --sweep: the one in force"   sweep_in_force
part "contacts --sweep: nothing to find"    sweep_of_nothing
part "the distance in JSON"                 distance_in_json
part "the distance is in m, a model in mm"  in_millimetres
part "a distance told in mm is remarked on" remarks 'the contact distance, 0.5 m, is .* in metres, whatever the unit' --fixed b0,b16 --up y --unit mm --contact-distance 0.5 arch-y.obj
part "a sound distance is not"              quiet --fixed b0,b16 --up y --unit mm --contact-distance 0.0005 arch-y.obj
part "contact_distance in a scene"          in_a_file
part "contact distance: a wrong word: 64"   refuses 64 'needs a length' check --contact-distance 60% arch.obj
part "contact distance: below 0: 64"        refuses 64 'needs a length' check --contact-distance -1 arch.obj
part "contact angle: too large: 64"         refuses 64 'degrees from 0 to 30' check --contact-angle 31 arch.obj

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
slab_fits() {                                           # it reaches beyond the wall, by no more than a fifth of its length
    "$cli" convert --fixed ground wall.obj 2> err | awk '/^o / { ground = $2 == "ground" } /^v / { if (ground) { if (!n++ || $2 < g) g = $2; if (n == 1 || $2 > h) h = $2 }
        else { if (!m++ || $2 < a) a = $2; if (m == 1 || $2 > b) b = $2 } } END { exit !(g < a && h > b && h - g < 1.4 * (b - a)) }'
}
part "fixed: ground, as wide as the model"  slab_fits
sheets() {                                              # a plane of one face: the ground, if it is told so; a stone that lacks a face is none
    awk 'BEGIN { print "o Plane\nv -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4" } /^f / { for (k = 2; k <= NF; k++) $k += 4 } { print }' wall.obj > plane.obj
    sed 's/^f 1 2 3 4$/f 1 2 3\nf 1 3 4/' plane.obj > plane-cut.obj
    awk '!(/^f / && ++n == 2)' wall.obj > lacks.obj
    for model in plane.obj plane-cut.obj; do
        same "$(forces --fixed Plane $model)" "$(forces wall-whole.obj)" &&
        refuses 65 "^$model:1: block 'Plane': the mesh is open.*: --fixed Plane$" check $model || return 1
    done
    refuses 65 "^lacks.obj:[0-9]*: block '.*': the mesh is open: an edge lacks its opposite$" check lacks.obj
}
as_keywords() {                                         # blocks that are called ground and lowest: they alone, and told
    sed 's/^o b5$/o lowest/; s/^o b9$/o ground/' arch.obj > words.obj
    for word in lowest ground; do
        "$cli" check --fixed $word words.obj > out
        grep -q "^  scene .*17 blocks, 16 free" out && grep -q "^  remark  *'$word' is a block of this model" out || { cat out; return 1; }
    done
    { printf '#@ supports lowest\n'; cat words.obj; } > words-told.obj
    remarks "'lowest' is a block of this model" words-told.obj && ! "$cli" check --fixed 'low*' words.obj | grep "a block of this model"
}
nearly_lowest() {                                       # within 1 % of its own height, not beyond
    for by in 0.009 0.011; do
        awk -v by=$by 'NR == FNR { if (/^v / && (!n++ || $4 < low)) low = $4; next } /^o / { on = $2 == "b16" } /^v / && on { $4 += by * h } { print }' \
            h="$(awk '/^o / { on = $2 == "b16" } /^v / && on { if (!n++ || $4 < a) a = $4; if (n == 1 || $4 > b) b = $4 } END { printf "%.17g", b - a }' arch.obj)" \
            arch.obj arch.obj > lifted.obj
        "$cli" check --fixed lowest lifted.obj | sed -n 's/.* \([0-9]* free\);.*/\1/p'
    done > out
    same "$(cat out)" "15 free
16 free" && "$cli" check --help | tr '\n' ' ' | tr -s ' ' | grep -q 'within 1 % of their own height'
}
part "a sheet of one face can be the ground" sheets
part "a block called ground or lowest: told" as_keywords
part "lowest: within 1 % of a block's height" nearly_lowest
part "fixed: ground, contacts told: 64"     refuses 64 'the file tells its contacts' check --fixed ground whole.obj
part "y up, mm: the same forces"            same "$(forces --fixed lowest --up y --unit mm arch-y.obj)" "$(forces whole.obj)"
part "gravity told instead"                 same "$(forces --fixed lowest --gravity 0,-9.80665,0 --unit mm arch-y.obj)" "$(forces whole.obj)"
part "a ground of y up, in mm"              same "$(first check --fixed ground --up y --unit mm wall-y.obj)" "wall-y.obj: STABLE"
part "upside down"                          same "$(first check --fixed lowest --up -y --unit mm arch-y.obj)" "arch-y.obj: UNSTABLE"
asked_twice() {                                         # by a file and an option: one slab, and nothing is told of a block called so
    echo '#@ supports ground' > wall.obj.stonepack
    "$cli" check --fixed ground --fixed ground wall.obj > out
    rm wall.obj.stonepack
    grep -q 'is a block of this model' out && { cat out; return 1; }
    same "$(forces --fixed ground wall.obj)" "$(sed -n 's/^  forces *largest compression \(.*\) of a joint.*/\1/p' out)"
}
part "a ground that is asked for twice"     asked_twice
part "up and gravity: 64"                   refuses 64 'exclude each other' check --up y --gravity 0,0,-1 arch.obj
part "up: a wrong word: 64"                 refuses 64 'needs x, y, z' check --up up arch.obj
part "unit: a wrong word: 64"               refuses 64 'needs mm, cm, m or in' check --unit km arch.obj
part "a file beside the model"              beside_goes_with
part "a file beside it with a byte order mark" beside_marked
part "beside: a name that is not there: 65" beside_refused "no block has such a name: 'x" '\no x\n'
part "beside: a support not there: 65"      beside_refused "supports 'x'" '\n#@ supports b0,x\n'
part "--support is told by its name"        refuses 64 "^arch.obj: --support '7': no block has such a name" check --support 7 arch.obj
cut_name() {
    sed 's/^o b0$/o base block/' arch.obj > named.obj
    refuses 64 "'base': no block has such a name, blanks of names are written _; there are base_block" check --fixed base,b16 named.obj &&
    same "$(forces --fixed 'base block,b16' named.obj)" "$(forces --fixed b0,b16 arch.obj)"
}
part "fixed: a name that is cut: told"      cut_name
part "beside: no geometry"                  beside_refused 'the model has the geometry' '\nv 0 0 0\n'
part "beside: a bad unit: 65"               beside_refused 'unit is mm, cm, m or in' '\n#@ unit km\n'
part "beside: a group, which says nothing: 65" beside_refused "after 'o NAME', not 'g NAME'" '\ng b5\n#@ density 3000\n'
part "beside: a load on nothing: 65"        beside_refused "block 'x', which does not exist" '\n#@ load x 0 0 0 0 0 0\n'
part "beside: fixed before any block: 65"   beside_refused "'fixed' before" '\n#@ fixed\n'
no_xml() {                                              # U+FFFF in a name is no text of XML
    awk '/^o b1$/ { print "o x\357\277\277"; next } { print }' arch.obj > noncharacter.obj
    "$cli" check --quiet --fixed b0,b16 --names --svg noncharacter.svg noncharacter.obj > out &&
    grep -q '>x?<' noncharacter.svg && ! LC_ALL=C grep -q "$(printf '\357\277\277')" noncharacter.svg
}
part "a name with U+FFFF in a picture"      no_xml

total
