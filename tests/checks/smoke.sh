#!/bin/sh
# smoke: the program's commands, exit codes and pipes.      smoke.sh [build/stonepack]
here=$(dirname "$0")
. "$here/tally.sh"
cli=${1:-build/stonepack}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp" "$tally_log"' EXIT

exits() {                                               # exits STATUS COMMAND...
    want=$1
    shift
    "$@"
    got=$?
    [ $got -eq "$want" ] || { echo "exit status $got, want $want: $*"; return 1; }
}
says() {                                                # says TEXT COMMAND...
    text=$1
    shift
    "$@" > "$tmp/said"
    grep -q -- "$text" "$tmp/said" || { echo "no '$text' in:"; head -c 2000 "$tmp/said"; return 1; }
}
gen() { "$cli" gen "$@" > "$tmp/scene.obj"; }
scene_exits() {                                         # scene_exits STATUS GEN-ARGUMENTS...
    want=$1
    shift
    gen "$@" || return 1
    exits "$want" "$cli" check "$tmp/scene.obj"
}
round_trip() {                                          # scene -> convert -> the same verdict and numbers
    gen arch && "$cli" convert "$tmp/scene.obj" > "$tmp/again.obj" &&
    "$cli" check --json - < "$tmp/scene.obj" | sed 's/"seconds":[^,}]*//g' > "$tmp/a" &&
    "$cli" check --json - < "$tmp/again.obj" | sed 's/"seconds":[^,}]*//g' > "$tmp/b" && cmp "$tmp/a" "$tmp/b"
}
found_or_given() {                                      # contacts found are the contacts given: same verdict
    gen "$1" && grep -v '^#@ interface' "$tmp/scene.obj" > "$tmp/bare.obj"
    "$cli" check "$tmp/scene.obj"; a=$?
    "$cli" check "$tmp/bare.obj"; b=$?
    [ $a -eq $b ] && [ $a -le 1 ]
}

bundled() {                                             # the scenes of this folder: names tell which of them fall
    for b in "$here"/../scenes/*.obj; do
        case $b in *-falling.obj) want=1 ;; *) want=0 ;; esac
        "$cli" check "$b" > "$tmp/said"
        got=$?
        if [ $got -ne $want ]; then echo "exit status $got, want $want: $b"; return 1; fi
        if ! grep -q verified "$tmp/said"; then echo "not verified: $b"; return 1; fi
        if [ "$(wc -c < "$b")" -gt 20000 ]; then echo "larger than 20 kB: $b"; return 1; fi
    done
}
named() {                                               # a scene by hand: names are kept, contacts found, both ways
    hand=$here/../scenes/trilithon.obj
    says '"a": *"right-post", *"b": *"lintel"' "$cli" check --json "$hand" &&
    says '^left-post  *lintel  *0.36 ' "$cli" contacts "$hand" &&
    says '^5 contacts between 5 blocks, 0 overlaps' "$cli" contacts "$hand" &&
    "$cli" convert "$hand" > "$tmp/hand.obj" && says '^o gable' cat "$tmp/hand.obj" && exits 0 "$cli" check "$tmp/hand.obj"
}

part "version"                      exits 0 "$cli" --version
part "help names the commands"      says check "$cli" --help
part "no command is a usage error"  exits 64 "$cli"
part "unknown command"              exits 64 "$cli" stand
part "unknown option"               exits 64 "$cli" check --no-such-option x
part "missing file"                 exits 66 "$cli" check "$tmp/none.obj"
part "two cubes stand: 0"           scene_exits 0 two-cubes
part "two cubes fall: 1"            scene_exits 1 two-cubes offset=0.6
part "an empty scene is bad: 65"    exits 65 "$cli" check /dev/null
part "gen: unknown scene"           exits 64 "$cli" gen no-such-scene
part "gen: unknown number"          exits 64 "$cli" gen arch no-such-number=1
for s in arch wall dome rubble vault; do
    part "contacts found or given: $s"  found_or_given $s
done
part "bundled scenes"               bundled
part "a scene by hand"              named
gen arch
part "json"                         says '"verdict": *"stable"' "$cli" check --json "$tmp/scene.obj"
part "svg"                          exits 0 "$cli" check --svg "$tmp/scene.svg" "$tmp/scene.obj"
part "svg has an end"               grep -q '</svg>' "$tmp/scene.svg"
part "standard input"               sh -c "'$cli' check - < '$tmp/scene.obj'"
part "write, read: same result"     round_trip
total
