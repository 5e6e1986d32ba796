#!/bin/sh
# settle: the command as a program.      settle.sh [build/stonepack]
. "$(dirname "$0")/program.sh"

refused() {                                             # refused STATUS TEXT COMMAND...
    re_text=$2
    re_status=$1
    shift 2
    exits "$re_status" "$@" 2> "$tmp/err" && grep -q "$re_text" "$tmp/err"
}
fall() { "$cli" settle "$tmp/loose.obj" -o "$tmp/rest$1.obj" --frames "$tmp/fall$1.svg" --set steps=900,tamps=0 > "$tmp/told$1"; }
twice() { fall 1 && fall 2 && cmp "$tmp/rest1.obj" "$tmp/rest2.obj" && cmp "$tmp/fall1.svg" "$tmp/fall2.svg"; }
near() { exits 0 "$cli" settle "$tmp/two.obj" --near 0.001 -o "$tmp/near.obj" && grep -q '^#@ interface a b' "$tmp/near.obj" &&
         exits 0 "$cli" check "$tmp/near.obj"; }
box() { exits 0 "$cli" settle "$tmp/loose.obj" -o "$tmp/box.obj" --set width=3,depth=3,height=2,floor=0.1,steps=900 &&
        grep -q '^o container' "$tmp/box.obj" && exits 0 "$cli" check "$tmp/box.obj"; }
half() {                                                # no room for the scene, or for the pictures
    for ha in -o --frames; do
        (trap '' XFSZ; ulimit -f 1; exits 70 "$cli" settle "$tmp/loose.obj" $ha "$tmp/half" --set steps=1,tamps=0,ramp_steps=0) &&
        test ! -e "$tmp/half" || return 1
    done
}
stopped() {                                             # Ctrl-C: stones as they are then, all of them, and 130
    "$cli" gen rubble count=300 > "$tmp/many.obj"
    timeout --preserve-status -s INT 2 "$cli" settle "$tmp/many.obj" -o "$tmp/then.obj" --set rest_steps=90000,energy=1e-12 > "$tmp/told" 2> "$tmp/err"
    [ $? -eq 130 ] && grep -q 'stopped by Ctrl-C; stones as they were then' "$tmp/err" && [ "$(grep -c '^o ' "$tmp/then.obj")" -eq 301 ]
}
falls_out() {                                           # whichever way is down
    "$cli" gen two-cubes offset=0.7 | grep -v interface > "$tmp/z.obj"
    awk '/^v / { print "v", $2, $4, -$3; next } { print }' "$tmp/z.obj" > "$tmp/y.obj"
    exits 1 "$cli" settle "$tmp/z.obj" -o "$tmp/out.obj" && exits 1 "$cli" settle --up y "$tmp/y.obj" -o "$tmp/out.obj" &&
    exits 1 "$cli" settle --up -z --set steps=900,tamps=0 "$tmp/two.obj" -o "$tmp/out.obj"
}
units() {                                               # --confirm does not ask in which unit a scene is
    for un in 1 0.001 1000; do
        awk -v u=$un '$1 == "v" { print "v", $2 * u, $3 * u, $4 * u; next } { print }' "$tmp/two.obj" > "$tmp/u.obj"
        exits 0 "$cli" settle --confirm "$tmp/u.obj" || return 1
    done
}

"$cli" gen rubble count=8 > "$tmp/loose.obj"
cat > "$tmp/two.obj" <<'END'
o a
#@ fixed
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
f 1 2 3 4
o b
v -.5 -.5 0
v .5 -.5 0
v .5 .5 0
v -.5 .5 0
v -.5 -.5 1
v .5 -.5 1
v .5 .5 1
v -.5 .5 1
f 8 7 6 5
f 9 10 11 12
f 5 6 10 9
f 6 7 11 10
f 7 8 12 11
f 8 5 9 12
END
cat > "$tmp/open.obj" <<'END'
o ground
#@ fixed
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
f 1 2 3 4
o post
#@ fixed
END

part "the same bytes twice: scene and pictures" twice
part "what settled is a scene that check finds stable" exits 0 "$cli" check "$tmp/rest1.obj"
part "contacts by faces: --near" near
part "a container is written and holds" box
part "--confirm in mm, m and km" units
part "a stone falls out, also with y up"    falls_out
part "Ctrl-C keeps the stones as they are then" stopped
part "--confirm: both stand" exits 0 "$cli" settle --confirm "$tmp/two.obj"
"$cli" gen two-cubes offset=0.6 > "$tmp/fall.obj"
part "--confirm: both fall" exits 1 "$cli" settle --confirm --json "$tmp/fall.obj"
"$cli" gen h-model > "$tmp/h.obj"
part "--confirm: they differ" exits 2 "$cli" settle --confirm "$tmp/h.obj"
part "a support without a mesh is refused by name" refused 65 "block 'post'" "$cli" settle "$tmp/open.obj" -o "$tmp/x.obj"
sed 's/^v \([-.0-9]* [-.0-9]*\) 1$/v \1 1e-7/' "$tmp/two.obj" > "$tmp/thin.obj"
part "a stone too thin is refused by name" refused 65 "block 'b': .*too thin" "$cli" settle "$tmp/thin.obj" -o "$tmp/x.obj"
part "no scene" exits 64 "$cli" settle -o "$tmp/x.obj"
part "nothing asked for" exits 64 "$cli" settle "$tmp/two.obj"
part "an unknown setting" exits 64 "$cli" settle "$tmp/two.obj" --confirm --set speed=3
part "a setting that is no number" exits 64 "$cli" settle "$tmp/two.obj" --confirm --set dt=fast
part "a setting out of range" exits 64 "$cli" settle "$tmp/two.obj" --confirm --set dt=-1
part "a file that can't be written" exits 70 "$cli" settle "$tmp/two.obj" -o "$tmp/no/such/place.obj" --set steps=1,tamps=0,ramp_steps=0
part "nothing half written" half
part "what settled is told, though it can't be written" sh -c "'$cli' settle '$tmp/two.obj' -o '$tmp/no/such/place.obj' > '$tmp/told' 2> '$tmp/err'
    [ \$? -eq 70 ] && grep -q ': 1 of 1 stone settled in [0-9]* steps' '$tmp/told' && grep -q \"can't write\" '$tmp/err'"
apart() {                                               # what keeps still in Bullet and touches nothing for statics: the first line tells why
    sed 's/^\(v [-.0-9]* [-.0-9]*\) 1$/\1 1.0001/; /^#@ interface/d' "$tmp/two.obj" | awk '/^o b/ { on = 1 } on && /^v/ && $4 == 0 { $4 = 0.0001 } { print }' > "$tmp/apart.obj"
    "$cli" settle --confirm "$tmp/apart.obj" > "$tmp/told"
    grep -q ': statics says unstable, .*, but 1 pair of blocks nearly touches$' "$tmp/told" || { cat "$tmp/told"; return 1; }
    ! "$cli" settle --confirm "$tmp/two.obj" | grep nearly
}
part "--confirm: near misses are told first" apart
part "a file beside: not settled in its place" sh -c "cp '$tmp/two.obj' '$tmp/in.obj' && echo '#@ unit m' > '$tmp/in.obj.stonepack' &&
    '$cli' settle '$tmp/in.obj' -o '$tmp/in.obj' 2> '$tmp/err'; [ \$? -eq 64 ] && cmp '$tmp/in.obj' '$tmp/two.obj'"
part "settings explained" exits 0 "$cli" settle --set help
total
