#!/bin/sh
# smoke: the program's commands, exit codes and pipes.      smoke.sh [build/stonepack]
. "$(dirname "$0")/program.sh"

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
margin_is_tilt() {          # "x y z" ORDER MU: of this gravity, axes in this order, at the worst azimuth, 35 and 205 degrees
    "$cli" gen two-cubes offset=0.2 mu="$3" | awk -v g="$1" -v order="$2" '
        /^#@ interface/ { next } /^#@ gravity/ { print "#@ gravity " g; next }
        { x["x"] = $2; x["y"] = $3; x["z"] = $4 }
        $1 == "v" { print "v", x[substr(order, 1, 1)], x[substr(order, 2, 1)], x[substr(order, 3, 1)]; next } { print }' > "$tmp/turned.obj"
    "$cli" limit --tilt-margin --json "$tmp/turned.obj" | tr -d ' ' | awk -F '[][,:]' '{
        for (k = 1; k <= NF; k++) {
            if ($k == "\"tilt_margin\"") m = $(k + 1)
            if ($k == "\"azimuth\"") print $(k + 1), m
            if ($k == "\"angles\"") print 35, $(k + 9) "\n" 205, $(k + 43)
        } }' > "$tmp/margins"
    [ "$(wc -l < "$tmp/margins")" -eq 3 ] || { cat "$tmp/margins"; return 1; }
    while read -r azimuth margin; do
        exits 0 "$cli" check --tilt "$(awk "BEGIN { printf \"%.12f\", $margin * (1 - 1e-6) }"),$azimuth" "$tmp/turned.obj" > "$tmp/said" &&
        exits 1 "$cli" check --tilt "$(awk "BEGIN { printf \"%.12f\", $margin * (1 + 1e-6) }"),$azimuth" "$tmp/turned.obj" > "$tmp/said" ||
        return 1
    done < "$tmp/margins"
}
short_help() {
    "$cli" --help > "$tmp/a" && "$cli" -h | cmp - "$tmp/a" && for c in $(commands); do
        "$cli" "$c" --help > "$tmp/a" && "$cli" help "$c" | cmp - "$tmp/a" && "$cli" "$c" no-such-file -h | cmp - "$tmp/a" || return 1
    done
}
commands() { "$cli" --help | awk 'NF == 0 { if (n++) exit; next } n { print $1 }'; }
told() { "$cli" help bash | sed -n "s/^ *$1) list=' *\(.*\) --help' ;;/\1/p"; }
options_told() {                                        # the lists in the sources, and the help
    for c in $(commands); do
        for o in $(told "$c"); do
            "$cli" "$c" "$o=1" 2>&1 | grep 'unknown option' && return 1
        done
    done
    for c in check limit verify plan sequence contacts convert cost qp settle; do
        tr '\n' ' ' < "$here/../../port/host/command/$c.c" | sed 's/" *"//g' | grep -o 'options_read(argc, argv, [^;]*;' > "$tmp/a"
        grep -q SCENE_OPTIONS "$tmp/a" && sed -n 's/^#define SCENE_OPTIONS//p' "$here/../../port/host/command/options.h" >> "$tmp/a"
        for o in $(grep -oe ' --*[a-z][a-z-]*' "$tmp/a"); do
            case " $(told "$c") " in *" $o "*) ;; *) echo "$c: $o is not told"; return 1;; esac
        done
    done
}
manual() {
    "$cli" help man > "$tmp/man" && for c in $(commands); do grep -q "^.SS $c:" "$tmp/man" || { echo "no $c"; return 1; }; done
    ! command -v groff > /dev/null || [ -z "$(groff -man -Tascii -ww "$tmp/man" 2>&1 > "$tmp/page")" ]
}
completes() {
    command -v bash > /dev/null || return 0
    "$cli" help bash > "$tmp/completion" && bash -c '. "$1"; COMP_WORDS=(stonepack check --fa); COMP_CWORD=2; _stonepack; echo "${COMPREPLY[@]}"
        COMP_WORDS=(stonepack se); COMP_CWORD=1; _stonepack; echo "${COMPREPLY[@]}"
        COMP_WORDS=(stonepack limit --unit ""); COMP_CWORD=3; _stonepack; echo "${COMPREPLY[@]}"' - "$tmp/completion" > "$tmp/said" &&
    printf -- '--fallback\nsequence settle\nmm cm m in\n' | cmp - "$tmp/said"
}
# A shell at a terminal of its own is asked with the Tab key.
completes_zsh() {
    command -v zsh > /dev/null || return 0
    mkdir -p "$tmp/zsh" && "$cli" help zsh > "$tmp/zsh/_stonepack" && cat > "$tmp/tab.zsh" <<'END' || return 1
zmodload zsh/zpty
zpty z TERM=dumb zsh -f -i
zpty -w z "PS1=; fpath=($1 \$fpath); autoload -Uz compinit; compinit -u -D; print REA''DY"
zpty -r -m z said '*READY*'
for typed in 'se' 'check --fallb'; do
    zpty -w -n z "stonepack $typed"$'\t\x01: \n'
    zpty -w z "print EN''D"
    zpty -r -m z said '*END*'
    print -r -- "$said"
done
END
    timeout 60 zsh -f "$tmp/tab.zsh" "$tmp/zsh" < /dev/null > "$tmp/said"
    for cz in 'sequence *-- does' 'settle *-- where' '^: stonepack check --fallback\|stonepack check --fallback'; do
        grep -q -- "$cz" "$tmp/said" || { cat "$tmp/said"; return 1; }
    done
}
quiet() {
    gen arch && for c in check 'limit --body 1,0,0' sequence contacts plan 'limit --tilt-margin' "check --coupled --tol 1e-4"; do
        # shellcheck disable=SC2086
        "$cli" $c --quiet "$tmp/scene.obj" > "$tmp/said"
        [ "$(wc -l < "$tmp/said")" -eq 1 ] || { echo "$c:"; cat "$tmp/said"; return 1; }
    done
}
interrupted() {                     # interrupted TEXT COMMAND...: Ctrl-C after a half second, or after longer until it has said TEXT
    text=$1
    shift
    for wait in 0.5 2 8 32; do
        timeout -s INT $wait "$@" > "$tmp/said" 2> "$tmp/err"
        [ $? -eq 124 ] || { echo "not interrupted after $wait s"; return 1; }
        if grep -q -- "$text" "$tmp/said"; then return 0; fi
    done
    echo "no '$text'"
    return 1
}
stops_cost() {                                          # the table ends with what was made
    gen wall size=600 && interrupted '"verdict": *"stable"' "$cli" cost --json --svg "$tmp/part.svg" "$tmp/scene.obj" && [ "$(wc -l < "$tmp/said")" -eq 1 ] &&
    grep -q '; stopped after [0-9]* of 216 checks<' "$tmp/part.svg" &&
    [ "$(grep -o '"cone"' "$tmp/said" | wc -l)" -lt 216 ] && grep -q 'Ctrl-C once more' "$tmp/err"
}
stops_batch() {
    gen wall size=600 || return 1
    # shellcheck disable=SC2046
    interrupted '}' "$cli" check --json $(awk -v f="$tmp/scene.obj" 'BEGIN { while (n++ < 5000) print f }') &&
    [ "$(tail -c 2 "$tmp/said")" = "}" ] && grep -qx "stonepack: stopped after $(wc -l < "$tmp/said") of 5000 scenes" "$tmp/err"
}
no_half() {                                             # it was left out, untold
    exits 64 "$cli" gen arch n=2.5 > "$tmp/out" 2> "$tmp/err" && [ ! -s "$tmp/out" ] && grep -q "not a whole number: 'n'" "$tmp/err"
}
tells() {                                               # on a terminal alone; the clock is looked at between 12 factorisations
    command -v script > /dev/null || return 0
    gen wall rows=120 bricks=120 tilt=20 && script -qec "'$cli' check '$tmp/scene.obj'" /dev/null < /dev/null > "$tmp/said" &&
    tr '\r' '\n' < "$tmp/said" > "$tmp/lines" && { ! slow || grep -q 'exact, [0-9]* factorisations, [0-9.]* s \.\.\.' "$tmp/lines"; } &&
    "$cli" check "$tmp/scene.obj" 2> "$tmp/err" > "$tmp/said" && [ ! -s "$tmp/err" ]
}
slow() { sed -n 's/^  cost .*KiB, \([0-9.]*\) s,.*/\1/p' "$tmp/lines" | awk '{ exit !($1 > 2) }'; }     # a quick machine tells nothing
round_trip() {                                          # scene -> convert -> the same verdict and numbers
    gen arch && "$cli" convert "$tmp/scene.obj" > "$tmp/again.obj" &&
    "$cli" check --json - < "$tmp/scene.obj" | sed 's/"seconds":[^,}]*//g' > "$tmp/a" &&
    "$cli" check --json - < "$tmp/again.obj" | sed 's/"seconds":[^,}]*//g' > "$tmp/b" && cmp "$tmp/a" "$tmp/b"
}
refuted() {                                             # a proof told in full is checked again; damaged it proves nothing
    gen h-model && "$cli" check --json --forces --coupled "$tmp/scene.obj" > "$tmp/result.json"
    grep -q '"stage": *"coupled".*"bytes"' "$tmp/result.json" || return 1
    says 'refuted, margin' "$cli" verify "$tmp/scene.obj" "$tmp/result.json" || return 1
    sed 's/"node": *\[[0-9]*, *[-0-9]*,/"node":[3,3,/' "$tmp/result.json" > "$tmp/damaged.json"
    says 'undecided by .* not refuted: the proof in it fails' "$cli" verify "$tmp/scene.obj" "$tmp/damaged.json"
}
strong() {                                              # what friction holds or not is told in full and judged again; damaged it proves less
    gen wall rows=3 && "$cli" check --json --forces --strong "$tmp/scene.obj" > "$tmp/result.json" &&
    says '"level": *"strong"' cat "$tmp/result.json" && says 'whatever friction does: strong' "$cli" verify "$tmp/scene.obj" "$tmp/result.json" &&
    gen h-model && "$cli" check --json --forces --strong "$tmp/scene.obj" > "$tmp/result.json" &&
    says '"level": *"ambiguous"' cat "$tmp/result.json" && says 'does: ambiguous' "$cli" verify "$tmp/scene.obj" "$tmp/result.json" ||
    return 1
    sed 's/-9.80665, 0, 0, 0\]\]}}/-5, 0, 0, 0]]}}/' "$tmp/result.json" > "$tmp/damaged.json"
    says 'whatever friction does: admissible' "$cli" verify "$tmp/scene.obj" "$tmp/damaged.json"
}
sliding() {                                             # a limit without dilatancy is told in full and judged again; damaged it proves nothing
    gen wall rows=3 && "$cli" limit --body 1,0,0 --sliding real --json --forces "$tmp/scene.obj" > "$tmp/result.json" &&
    says '"kind": *"state"' cat "$tmp/result.json" &&
    says 'a sliding state at' "$cli" verify --body 1,0,0 "$tmp/scene.obj" "$tmp/result.json" &&
    says 'for safety' "$cli" limit --body 1,0,0 --sliding real "$tmp/scene.obj" || return 1
    says 'no sliding state by' "$cli" verify --body 0.9,0,0 "$tmp/scene.obj" "$tmp/result.json" &&
    sed 's/"motion": *\[\[/"motion": [[1, /;s/"upper": *0\./"upper": 1./' "$tmp/result.json" > "$tmp/damaged.json"
    exits 65 "$cli" verify --body 1,0,0 "$tmp/scene.obj" "$tmp/damaged.json"
}
another() {                                             # a result says what it was asked; that is not what verify is asked
    gen wall && "$cli" check --json --forces --tilt 5 --tol 1e-3 "$tmp/scene.obj" > "$tmp/result.json"
    says 'undecided by .* the result.s tol is 0.001, the result.s gravity is' "$cli" verify "$tmp/scene.obj" "$tmp/result.json" &&
    says 'stable by .* tol 0.001, tilted by 5 degrees: ' "$cli" verify --tol 1e-3 --tilt 5 "$tmp/scene.obj" "$tmp/result.json" &&
    says 'undecided by .* tol 0.001, tilted by -5 degrees, ' "$cli" verify --tol 1e-3 --tilt -5 "$tmp/scene.obj" "$tmp/result.json" ||
    return 1
    says 'undecided by' "$cli" verify --mu 0.01 --tilt 5 "$tmp/scene.obj" "$tmp/result.json" || return 1
    gen two-cubes && "$cli" check --json --forces "$tmp/scene.obj" > "$tmp/result.json"
    sed 's/"verdict": *"stable"/"verdict":"unstable"/; s/"force_bound": *[^,]*,/"force_bound":0.001,/
         s/"mechanism": *\[\]/"mechanism":[{"block":"b1","dq":[0,0,-1,0,0,0]}]/
         s/"forces": *\[/&[0,0,0],[0,0,0],[0,0,0],[0,0,0]],"was":[/' "$tmp/result.json" > "$tmp/forged.json"
    says 'undecided by' "$cli" verify "$tmp/scene.obj" "$tmp/forged.json"
}
bound_told() {                                          # what a result says of the bound on forces is not believed, and told
    gen two-cubes && "$cli" check --json --forces "$tmp/scene.obj" > "$tmp/result.json" &&
    says 'stable by .* tol 1e-09: imbalance' "$cli" verify "$tmp/scene.obj" "$tmp/result.json" || return 1
    for bt in 0.001 3 1e+300; do
        sed "s/\"force_bound\": *[^,]*,/\"force_bound\": $bt,/" "$tmp/result.json" > "$tmp/forged.json"
        says "stable by .*, the result's bound on forces is $bt: " "$cli" verify "$tmp/scene.obj" "$tmp/forged.json" || return 1
    done
}
# A flat beam between two posts, whose motion must go farther than 100 eps: refuted with that, with more a triple is found.
reach_believed() {
    "$cli" gen h-model mu=0.04 | sed 's/ 0\.9/ 0.608/g' > "$tmp/flat.obj" && exits 1 "$cli" check --coupled "$tmp/flat.obj" > "$tmp/line" &&
    exits 0 "$cli" check --coupled --cra-eta 10 --json --forces "$tmp/flat.obj" > "$tmp/result.json" &&
    exits 2 "$cli" verify "$tmp/flat.obj" "$tmp/result.json" > "$tmp/line" &&
    says "undecided by .*, the result's eta/eps is 4.9e+05: .*, not coupled, residual" cat "$tmp/line" &&
    exits 0 "$cli" verify --cra-eta 10 "$tmp/flat.obj" "$tmp/result.json" > "$tmp/line" &&
    says 'stable by .* tol 1e-09: .*, coupled, residual .* eta 10 m' cat "$tmp/line" || return 1
    exits 1 "$cli" check --coupled --cra-eta 1e-4 --json --forces "$tmp/flat.obj" > "$tmp/result.json" &&
    exits 2 "$cli" verify "$tmp/flat.obj" "$tmp/result.json" > "$tmp/line" &&
    says "undecided by .*, the result's eta/eps is 4.9: .*, not refuted" cat "$tmp/line" &&
    exits 1 "$cli" verify --cra-eta 1e-4 "$tmp/flat.obj" "$tmp/result.json" > "$tmp/line" || return 1
    exits 1 "$cli" check --coupled --cra-eps 1e-3 --json --forces "$tmp/flat.obj" > "$tmp/result.json" &&      # the same eta/eps
    exits 1 "$cli" verify "$tmp/flat.obj" "$tmp/result.json" > "$tmp/line" && says 'unstable by .* tol 1e-09: .*, refuted' cat "$tmp/line" &&
    says "unstable by .*, the result's eta bounds the slip as a whole: " "$cli" verify --cra-box "$tmp/flat.obj" "$tmp/result.json"
}
costs() {                                               # the table, its picture, its JSON: 9 cones, 4 stages, 6 tolerances
    gen "$@" && says 'pyramids against the true cone' "$cli" cost --svg "$tmp/cost.svg" "$tmp/scene.obj" &&
    grep -q 'What accuracy costs' "$tmp/cost.svg" && grep -q 'class="square"' "$tmp/cost.svg" &&
    grep -q 'class="triangle"' "$tmp/cost.svg" &&
    "$cli" cost --json "$tmp/scene.obj" > "$tmp/cost.json" && [ "$(grep -o '"omega"' "$tmp/cost.json" | wc -l)" -eq 216 ]
}
on_a_budget() {                                         # undecided by name, and decided with more
    gen arch && says 'UNDECIDED' "$cli" check --budget 1e4 "$tmp/scene.obj"
    exits 0 "$cli" check --budget 1e7 "$tmp/scene.obj" > "$tmp/said"
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
each_way() {                                            # each_way EFFECT PLAN STATUS TEXT: forced on; left out: plan, status, words
    says "\"$1\": *{\"on\": *true, *\"why\": *\"the caller" "$cli" check --json --effects "+$1" "$tmp/scene.obj" &&
    says "^$1 *on .* the caller" "$cli" plan --effects "+$1" "$tmp/scene.obj" &&
    says "^$1 *$2" "$cli" plan --effects "-$1" "$tmp/scene.obj" &&
    says "$4" "$cli" check --effects "-$1" "$tmp/scene.obj" &&
    exits "$3" "$cli" check --json --effects "-$1" "$tmp/scene.obj" > "$tmp/said"
}
named() {                                               # a scene by hand: names are kept, contacts found, both ways
    hand=$here/../scenes/trilithon.obj
    says '"a": *"right-post", *"b": *"lintel"' "$cli" check --json "$hand" &&
    says '^left-post  *lintel  *0.36 ' "$cli" contacts "$hand" &&
    says '^5 contacts between 5 blocks, 0 overlaps' "$cli" contacts "$hand" &&
    "$cli" convert "$hand" > "$tmp/hand.obj" && says '^o gable' cat "$tmp/hand.obj" && exits 0 "$cli" check "$tmp/hand.obj"
}

qps() {                                                 # the least of 4 x^2 + 2 x y + 5 y^2 + 1.5 x - 2 y + 4, its rows and bounds
    cat > "$tmp/small.qps" <<'END'
* a comment
NAME          SMALL
ROWS
 N  obj
 G  c1
 L  c2
COLUMNS
    x         obj       1.5            c1        2.0
    x         c2        -1.0
    y         obj       -2.0           c1        1.0
    y         c2        2.0
RHS
    rhs       obj       -4.0           c1        2.0
    rhs       c2        6.0
BOUNDS
 UP bnd       x         20.0
QUADOBJ
    x         x         8.0
    x         y         2.0
    y         y         10.0
ENDATA
END
}
worked() {                                              # a worker for each scene: the same results, times apart
    "$cli" check --json --forces --coupled --worker 60 "$here"/../scenes/[a-f]*.obj > "$tmp/a"
    "$cli" check --json --forces --coupled "$here"/../scenes/[a-f]*.obj > "$tmp/b"
    same_but_seconds "$tmp/a" "$tmp/b"
}
resumed() {                                             # a run that was stopped goes on: every scene once, the worst counts
    "$cli" check --json "$here"/../scenes/*.obj > "$tmp/all"
    head -c "$(($(head -n 3 "$tmp/all" | wc -c) + 100))" "$tmp/all" > "$tmp/results.jsonl"
    exits 1 "$cli" check --json --skip-done "$tmp/results.jsonl" "$here"/../scenes/*.obj > "$tmp/more" || return 1
    cat "$tmp/more" >> "$tmp/results.jsonl"
    [ "$(wc -l < "$tmp/more")" -eq "$(($(wc -l < "$tmp/all") - 2))" ] || { echo "not all but three of them"; return 1; }
    exits 65 "$cli" check --json --skip-done "$tmp/results.jsonl" "$here"/../scenes/*.obj /dev/null > "$tmp/more" || return 1
    test ! -s "$tmp/more" || return 1
    printf %s "$(cat "$tmp/all")" > "$tmp/results.jsonl"                       # whole, but for its last newline
    exits 1 "$cli" check --json --skip-done "$tmp/results.jsonl" "$here"/../scenes/*.obj > "$tmp/more" && test -z "$(cat "$tmp/more")"
}
same_but_seconds() {                                    # same_but_seconds A B: files
    for w in "$1" "$2"; do sed 's/"seconds":[^,}]*//g' "$w" > "$w.bits"; done
    test -s "$1" && cmp "$1.bits" "$2.bits"
}
beside() {
    for b_how in '--json --forces' --quiet; do
        # shellcheck disable=SC2086
        for b_jobs in 1 3; do
            "$cli" check $b_how --jobs $b_jobs "$here"/../scenes/[a-f]*.obj /dev/null no-such-file "$here"/../scenes/[g-z]*.obj \
                > "$tmp/told$b_jobs" 2> "$tmp/failed$b_jobs"
            echo $? >> "$tmp/failed$b_jobs"
        done
        same_but_seconds "$tmp/told1" "$tmp/told3" && cmp "$tmp/failed1" "$tmp/failed3" || return 1
    done
    grep -q 'no-such-file' "$tmp/failed3" && tail -n 1 "$tmp/failed3" | grep -qx 65 || return 1
    "$cli" check --quiet "$here"/../scenes/*.obj > "$tmp/a"
    for b_files in 6 7 8 9 10 11 12 13 14 15 16; do             # fewer files than it would have open, even and odd
        ( ulimit -n $b_files; "$cli" check --quiet --jobs 4 "$here"/../scenes/*.obj ) > "$tmp/b" 2> "$tmp/failed1"
        cmp "$tmp/a" "$tmp/b" && test ! -s "$tmp/failed1" || { echo "with $b_files files"; cat "$tmp/failed1"; return 1; }
    done
    ( trap '' CHLD; exec "$cli" check --quiet --jobs 4 "$here"/../scenes/*.obj ) > "$tmp/b" 2> "$tmp/failed1"   # ends untold
    cmp "$tmp/a" "$tmp/b" && test ! -s "$tmp/failed1"
}
torn() {                                                # nowhere to write what a scene's process prints: said, status 70
    "$cli" gen wall size=40 > "$tmp/one.obj"
    ( ulimit -f 10; "$cli" check --json --forces --jobs 2 "$tmp/one.obj" "$tmp/one.obj" 2> "$tmp/failed1"
        echo $? > "$tmp/torn" ) | cat > "$tmp/a"
    grep -qx 70 "$tmp/torn" && test "$(grep -c "can't write" "$tmp/failed1")" -eq 2
}
by_threads() {
    "$cli" gen dome rings=8 > "$tmp/one.obj" && "$cli" check --json --forces "$tmp/one.obj" > "$tmp/a" &&
    "$cli" check --json --forces --jobs 3 "$tmp/one.obj" > "$tmp/b" && same_but_seconds "$tmp/a" "$tmp/b" || return 1
    "$cli" gen two-cubes offset=0.2 > "$tmp/one.obj" && "$cli" limit --tilt-margin --json "$tmp/one.obj" > "$tmp/a" &&
    "$cli" limit --tilt-margin --json --jobs 3 "$tmp/one.obj" > "$tmp/b" && same_but_seconds "$tmp/a" "$tmp/b"
}
# tables COMMAND SCENE [OPTIONS] TABLE LINES ...: each table of --csv has so many lines, all with as many values as its first.
tables() {
    command=$1; scene=$2; shift 2
    set -- "$@" end
    options=
    while case $1 in -*) ;; *) false ;; esac; do options="$options $1 $2"; shift 2; done
    "$cli" "$command" --csv "$tmp/t" $options "$scene" > "$tmp/out" 2> "$tmp/err" || [ $? -le 2 ] || return 1
    while [ "$1" != end ]; do
        awk -F, -v lines="$2" 'NR == 1 { n = NF } NF != n { bad = 1 } END { exit bad || n < 10 || NR != lines }' "$tmp/t-$1.csv" ||
            return 1
        shift 2
    done
}

half() {                                                # half COMMAND...: no room for what it writes, nothing of it stays
    (ulimit -f 1; exits 70 "$@") && test ! -e "$tmp/half" || return 1
    echo before > "$tmp/half"                           # and what was there stays as it was
    (ulimit -f 1; exits 70 "$@") && [ "$(cat "$tmp/half")" = before ] && [ "$(echo "$tmp"/half*)" = "$tmp/half" ]
    status=$?
    rm -f "$tmp"/half*
    return $status
}
replaces() {                                            # permissions and links stay; devices, pipes, where output goes: written as they are
    o=$tmp/whole
    gen arch && rm -rf "$o" && mkdir "$o" && echo before > "$o/new" && chmod 640 "$o/new" && ln -s new "$o/link" && ln -s later "$o/none" || return 1
    for out in "$o/link" "$o/none" /dev/null; do "$cli" check --quiet --svg "$out" "$tmp/scene.obj" > "$tmp/said" || return 1; done
    [ "$(stat -c %a "$o/new")" = 640 ] && [ -L "$o/link" ] && [ -L "$o/none" ] && grep -q '</svg>' "$o/new" && cmp "$o/new" "$o/later" || return 1
    "$cli" check --quiet --svg /dev/stdout "$tmp/scene.obj" > "$o/both" && grep -q '</svg>' "$o/both" && grep -q STABLE "$o/both" || return 1
    mkfifo "$o/pipe" && { cat "$o/pipe" > "$o/got" & } && "$cli" check --quiet --svg "$o/pipe" "$tmp/scene.obj" > "$tmp/said" && wait &&
    cmp "$o/got" "$o/new" || return 1
    [ "$(cd "$o" && echo *)" = "both got later link new none pipe" ] || { ls "$o"; return 1; }
    [ ! -e /dev/full ] || exits 70 "$cli" check --svg /dev/full "$tmp/scene.obj" > "$tmp/said"
}
writes_over() {                                         # writes_over TEXT COMMAND...: refused, and what is read stays
    text=$1
    shift
    gen arch && cp "$tmp/scene.obj" "$tmp/before.obj" && ln -sf scene.obj "$tmp/other.obj" && echo b1 > "$tmp/t-steps.csv" || return 1
    exits 64 "$cli" "$@" 2> "$tmp/err" && grep -q -e "$text" "$tmp/err" && [ "$(wc -l < "$tmp/err")" -eq 1 ] && cmp "$tmp/scene.obj" "$tmp/before.obj" ||
        { cat "$tmp/err"; return 1; }
}
spaced() {                                              # with _, with a blank, in a file in quotes: the same
    "$cli" gen arch n=3 | sed 's/\<b2\>/stone one/; /^#@ interface/d' > "$tmp/spaced.obj"
    printf 'b1 "stone one" # or b3, b2\nb3\n' > "$tmp/order"
    "$cli" sequence --quiet --order b1,stone_one,b3 "$tmp/spaced.obj" > "$tmp/a"; [ $? -le 2 ] || return 1
    "$cli" sequence --quiet --order 'b1, stone one,b3' "$tmp/spaced.obj" | cmp - "$tmp/a" &&
    "$cli" sequence --quiet --order-file "$tmp/order" "$tmp/spaced.obj" | cmp - "$tmp/a"
}
spaced_cut() {
    printf 'b1 stone one b3\n' > "$tmp/order"
    exits 65 "$cli" sequence --order-file "$tmp/order" "$tmp/spaced.obj" 2> "$tmp/err" &&
    grep -q "order:1: the scene has no block 'stone': blanks of a name are written _, or it stands in quotes" "$tmp/err"
}
in_place() {                                            # convert IN IN
    gen arch && "$cli" convert "$tmp/scene.obj" > "$tmp/want.obj" && "$cli" convert "$tmp/scene.obj" "$tmp/scene.obj" && cmp "$tmp/scene.obj" "$tmp/want.obj"
}
beside_in_place() {                                     # what stands beside would count twice: refused; beside another file: told
    gen arch && echo '#@ unit cm' > "$tmp/scene.obj.stonepack" && cp "$tmp/scene.obj" "$tmp/before.obj" || return 1
    for out in "$tmp/scene.obj" "$tmp/./scene.obj"; do
        exits 64 "$cli" convert "$tmp/scene.obj" "$out" 2> "$tmp/err" && grep -q 'would count once more' "$tmp/err" && cmp "$tmp/scene.obj" "$tmp/before.obj" || return 1
    done
    exits 0 "$cli" convert "$tmp/scene.obj" "$tmp/new.obj" 2> "$tmp/err" && ! grep 'is beside it' "$tmp/err" || return 1
    echo '#@ unit cm' > "$tmp/new.obj.stonepack"
    exits 0 "$cli" convert "$tmp/scene.obj" "$tmp/new.obj" 2> "$tmp/err" && grep -q 'remark .*new.obj.stonepack, which is beside it' "$tmp/err"
    status=$?
    rm "$tmp/scene.obj.stonepack" "$tmp/new.obj" "$tmp/new.obj.stonepack"
    return $status
}
no_name() {                                             # no_name NAME: nothing is written that begins with -
    gen arch && exits 64 "$cli" check --csv "$1" "$tmp/scene.obj" 2> "$tmp/err" && grep -q 'how the names of its tables begin' "$tmp/err" &&
    [ ! -e "$tmp/-joints.csv" ] && [ ! -e -joints.csv ]
}
answers() {                                             # answers STATUS TEXT COMMAND...: of what can't be written; the answer comes first
    want=$1 text=$2
    shift 2
    "$cli" "$@" > "$tmp/said" 2>&1
    status=$?
    [ $status -eq "$want" ] && sed -n 1p "$tmp/said" | grep -q -e "$text" && [ "$(grep -c "can't write" "$tmp/said")" -eq 1 ] && tail -n 1 "$tmp/said" |
        grep -q "can't write" || { echo "exit status $status"; head -c 600 "$tmp/said"; return 1; }
}
one_of_each() {                                         # no "1 steps"
    for command in check 'limit --body 1,0,0' sequence plan 'plan --ram' contacts 'contacts --sweep' cost 'check --strong'; do
        # shellcheck disable=SC2086
        "$cli" $command "$tmp/two.obj" > "$tmp/said" || [ $? -le 2 ] || return 1
        ! grep -E '(^|[^0-9.,])1 (blocks|joints|steps|pairs|factorisations|iterations|contact points|contacts|overlaps|islands|cases|starts)\b' "$tmp/said" || return 1
    done
    grep -q . "$tmp/said" && "$cli" sequence "$tmp/two.obj" | sed -n 1p | grep -q ': 1 step, ' &&
    "$cli" sequence "$tmp/two.obj" | grep -q ' cost  *[01] factorisations\{0,1\}, '
}
dropped() {                                             # more moves than page and model hold: told; fewer: not
    for n in 330 60; do
        gen tower n=$n lean=0 && awk '/^o / { name[++n] = $2 } END { for (k = n; k > 1; k--) print name[k] }' "$tmp/scene.obj" > "$tmp/order"
        "$cli" sequence --order-file "$tmp/order" --out-obj "$tmp/m.obj" "$tmp/scene.obj" > "$tmp/said.$n"; [ $? -eq 1 ] || return 1
    done
    grep -q 'remark .*what moves of the first steps that fall only: [1-9][0-9]* more have no motion' "$tmp/said.330" && ! grep 'remark' "$tmp/said.60"
}
goes_on() {                                             # a bad scene between two others: they are told, it is on stderr
    gen arch && "$cli" check --json "$tmp/scene.obj" /dev/null "$tmp/scene.obj" > "$tmp/said"
    [ $? -eq 65 ] && [ "$(grep -c '"verdict": *"stable"' "$tmp/said")" -eq 2 ]
}
plugged() {                                             # plugged FILE: same objective, or a line that says what is missing
    for pl in osqp ipopt; do
        if "$cli" qp --solver $pl "$1" > "$tmp/said" 2>&1; then grep -q 'objective 8.37[12]' "$tmp/said" || return 1
        else [ $? -eq 69 ] && grep -q "^stonepack: --solver $pl is not in this build: .*install" "$tmp/said" || return 1; fi
    done
}
first() {                                               # first FILE: auto is osqp where that is built in, else admm; told by name
    fi=admm; "$cli" qp --solver osqp "$1" > "$tmp/osqp" 2>&1 && fi=osqp
    "$cli" qp --json --solver auto "$1" > "$tmp/auto" && grep -q "\"solver\": *\"$fi\"" "$tmp/auto" || return 1
    for fi_o in '' "--solver auto" "--solver $fi"; do
        # shellcheck disable=SC2086
        "$cli" check --json --preset seed --stages gates,admm $fi_o "$tmp/scene.obj" | sed 's/"seconds": *[^,]*//g' > "$tmp/by" || return 1
        [ "$fi_o" ] || cp "$tmp/by" "$tmp/by-preset"
        cmp -s "$tmp/by" "$tmp/by-preset" || return 1
    done
    exits 0 "$cli" check --worker 20 --preset seed --stages gates,admm "$tmp/scene.obj"
}
zero='\(0\|-\{0,1\}[0-9.]*e-1[0-9]\)'                    # an objective of 0, or of its rounding
form() {                                                # form OBJECTIVE HEAD ROW RHS-AND-RANGES BOUNDS: of (x - 3)^2, or HEAD
    printf '%b' "NAME form\n$2ROWS\n N o\n $3 c\nCOLUMNS\n x o -6 c 1\nRHS\n r o -9\n$4BOUNDS\n$5QUADOBJ\n x x 2\nENDATA\n" > "$tmp/form.qps"
    says "objective $1\$" "$cli" qp --eps 1e-7 "$tmp/form.qps" 2> "$tmp/warned"
}
forms() {
    free=' FR b x\n'
    form 1 '' L ' r c 2\n' "$free" && form 1 '' G ' r c 4\n' "$free" && form 4 '' E ' r c 5\n' "$free" &&
    form "$zero" '' L ' r c 4\nRANGES\n r c 2\n' "$free" && form 1 '' L ' r c 5\nRANGES\n r c -1\n' "$free" &&
    form 1 '' G ' r c 1\nRANGES\n r c -1\n' "$free" && form 1 '' E ' r c 5\nRANGES\n r c -1\n' "$free" &&
    form 0.25 '' E ' r c 3.5\nRANGES\n r c 1\n' "$free" &&
    form 25 '' G ' r c -9\n' ' UP b x -2\n' && form 25 '' G ' r c -9\n' ' LO b x -7\n UP b x -2\n' &&
    form 9 '' L ' r c 9\n' ' UP b x 0\n' && form 16 '' G ' r c -9\n' ' FX b x 7\n' && form "$zero" '' G ' r c -9\n' ' MI b x\n' &&
    form 4 '' L ' r c 9\n' ' BV b x\n' && form "$zero" '' N '' '' || return 1
    sed -i "s/ x o -6 c 1/ M 'MARKER' 'INTORG'\n x o -6 c 1\n M 'MARKER' 'INTEND'/" "$tmp/form.qps"
    says "objective $zero\$" "$cli" qp --eps 1e-7 "$tmp/form.qps" 2> "$tmp/warned" && grep -q integer "$tmp/warned" || return 1
    sed -i 's/^ROWS/OBJSENSE\n    MAX\nROWS/; s/ o -6 / o 6 /; s/ x x 2/ x x -2/; s/ o -9/ o 9/' "$tmp/form.qps"
    says "objective $zero\$" "$cli" qp --eps 1e-7 "$tmp/form.qps" 2> "$tmp/warned" || return 1
    sed -i 's/MAX/MIN/' "$tmp/form.qps"
    exits 65 "$cli" qp "$tmp/form.qps" 2> "$tmp/warned"                        # its curvature is the other way
}
edited() { sed "$1" "$tmp/small.qps" > "$tmp/edited.qps"; }
unread() {                                             # unread EDIT MESSAGE: of the small program
    edited "$1"
    "$cli" qp "$tmp/edited.qps" > "$tmp/said" 2>&1
    [ $? -eq 65 ] && grep -q "$2" "$tmp/said" || { echo "$1:"; cat "$tmp/said"; return 1; }
}
ambiguous() {                                           # what programs read in different ways
    unread '/x         c2/p' 'qps:10: a second entry of the column in row .c2' && unread '/x         obj/s/c1 /obj/' 'a second entry' &&
    unread '/rhs       c2/p' 'a second value for .c2' && unread 's/rhs       c2/r2        c2/' 'a second set: .r2' &&
    unread '/ UP bnd/{p;s/bnd/b2 /;s/ x / y /}' 'a second set: .b2' &&
    unread 's/^BOUNDS/RANGES\n r c1 1\n r c1 2\n&/' 'a second value' && unread 's/^BOUNDS/RANGES\n r obj 1\n&/' 'range of the obj' &&
    unread '/ UP bnd/{p;s/UP/LO/;s/20/21/}' 'bounds of column .x. leave nothing' &&
    unread '/x         y /{p;s/x         y/y         x/}' 'given twice' && unread '/y         y /p' 'given twice' &&
    unread 's/QUADOBJ/QMATRIX/' 'not symmetric' && unread 's/^ROWS/OBJSENSE UPWARD\nROWS/' 'neither MIN nor MAX' &&
    unread '/^    y         y/s/10.0/1e25/' 'too large' && unread '/^    y         y/s/10.0/nan/' 'not a number' &&
    unread '/^ROWS/,/^ L/d' 'no such row' && unread '/ENDATA/d' 'without ENDATA' && unread 's/^BOUNDS/SOS/' 'unknown section' &&
    edited 's/^ROWS/OBJSENSE MINIMUM\nROWS/' && says 'objective 8.371' "$cli" qp "$tmp/edited.qps"
}

part "version"                      exits 0 "$cli" --version
part "-h as --help, everywhere"     short_help
part "every option that is told is known, and every one known is told" options_told
part "manual page"                  manual
part "completion of bash"           completes
part "completion of zsh"            completes_zsh
part "quiet: one line"              quiet
part "Ctrl-C: cost keeps its checks"  stops_cost
part "Ctrl-C: a batch keeps its scenes" stops_batch
part "a long check tells how far it is" tells
part "help names the commands"      says check "$cli" --help
part "no command is a usage error"  exits 64 "$cli"
part "unknown command"              exits 64 "$cli" stand
part "gen: half a stone is refused" no_half
# An order file that is refused with this message.
refuses() { "$cli" sequence --order-file "$tmp/order.txt" "$tmp/scene.obj" 2>&1 | grep -q "$1"; }

part "unknown option"               exits 64 "$cli" check --no-such-option x
part "missing file"                 exits 66 "$cli" check "$tmp/none.obj"
part "two cubes stand: 0"           scene_exits 0 two-cubes
part "two cubes fall: 1"            scene_exits 1 two-cubes offset=0.6
part "an empty scene is bad: 65"    exits 65 "$cli" check /dev/null
part "--cra- without --coupled: 64"   exits 64 "$cli" check --cra-eps 0 x
part "--cra-eps beyond lengths: 64"   exits 64 "$cli" check --coupled --cra-eps 1e30 x
part "--cra-eta beyond lengths: 64"   exits 64 "$cli" check --coupled --cra-eta 1e300 x
part "--cra-nodes: half a case: 64"   exits 64 "$cli" check --coupled --cra-nodes 1.5 x
part "gen: unknown scene"           exits 64 "$cli" gen no-such-scene
part "gen: unknown number"          exits 64 "$cli" gen arch no-such-number=1
for s in arch wall dome rubble vault; do
    part "contacts found or given: $s"  found_or_given $s
done
part "bundled scenes"               bundled
part "a scene by hand"              named
gen arch
part "json"                         says '"verdict": *"stable"' "$cli" check --json "$tmp/scene.obj"
part "preset: decided its way"      says ', by polish$' "$cli" check "$tmp/scene.obj" --preset seed
part "preset: others change it"     says 'tol 1e-05' "$cli" check --tol 1e-5 "$tmp/scene.obj" --preset=seed
part "preset: unknown: 64"          exits 64 "$cli" check --preset none "$tmp/scene.obj"
part "admm on the net normal"       says '"tension_ratio": *[0-9]' "$cli" check --json --net --cone 8i --stages gates,admm "$tmp/scene.obj"
part "no admm, no ratio"            says '"tension_ratio": *null' "$cli" check --json "$tmp/scene.obj"
part "admm by ours, named"          says ", by ADMM$" "$cli" check --net --cone 8i --stages gates,admm --solver admm "$tmp/scene.obj"
part "svg"                          exits 0 "$cli" check --svg "$tmp/scene.svg" "$tmp/scene.obj"
part "corners belong to strong: 64" exits 64 "$cli" check --corners x
part "strong: a worker can't: 64"   exits 64 "$cli" check --strong --worker 5 x
part "strong: verify judges it"     strong
part "sliding: verify judges it"    sliding
part "sliding: real alone: 64"      exits 64 "$cli" limit --body 1,0,0 --sliding dry x
part "sliding: no pyramid: 64"      exits 64 "$cli" limit --body 1,0,0 --sliding real --cone 8i x
gen arch
part "svg of a virtual motion"      exits 0 "$cli" check --coupled --svg "$tmp/coupled.svg" "$tmp/scene.obj"
part "a page of a tilted scene tells how far" sh -c "'$cli' gen arch | '$cli' check --tilt 12 --html '$tmp/p.html' - > '$tmp/out'; \
    grep -q 'Gravity leans by 12 degrees from straight down' '$tmp/p.html' && '$cli' gen arch | '$cli' check --html '$tmp/p.html' - > '$tmp/out' && \
    ! grep -q 'Gravity leans' '$tmp/p.html'"
part "svg names it"                 grep -q 'virtual motion' "$tmp/coupled.svg"
part "svg of what friction may let go" sh -c "'$cli' check --strong --svg '$tmp/strong.svg' '$here/../bench/figures/cross-stool.obj' > '$tmp/out' && \
    grep -q 'by another history of its friction it starts to move' '$tmp/strong.svg' && grep -q '>moves<' '$tmp/strong.svg'"
part "svg of a sliding state"       sh -c "'$cli' gen wall rows=3 bricks=3 | '$cli' limit --body 1,0,0 --sliding real --svg '$tmp/slide.svg' - > '$tmp/out' && \
    grep -q 'How it slides at 0.714286, its joints without dilatancy' '$tmp/slide.svg' && grep -q 'as it slides' '$tmp/slide.svg'"
part "svg has an end"               grep -q '</svg>' "$tmp/scene.svg"
part "svg: seen from the front"       sh -c "'$cli' check --svg '$tmp/front.svg' --view front '$tmp/scene.obj' && '$cli' check --svg '$tmp/zero.svg' \
    --view 0,0 '$tmp/scene.obj' && cmp '$tmp/front.svg' '$tmp/zero.svg' && ! cmp -s '$tmp/front.svg' '$tmp/scene.svg'"
part "svg: no such view: 64"          exits 64 "$cli" check --svg "$tmp/front.svg" --view behind "$tmp/scene.obj"
part "svg: names where asked for"     sh -c "'$cli' check --svg '$tmp/front.svg' --names --view front '$tmp/scene.obj' && \
    test \$(grep -c 'class=\"name\"' '$tmp/front.svg') -gt 10"
part "svg: remarks stand below it"    sh -c "'$cli' gen two-cubes | sed '/fixed/d' | '$cli' check --svg '$tmp/front.svg' - > '$tmp/out'; \
    [ \$? = 1 ] && grep -q '>mind: no block is a support' '$tmp/front.svg'"
part "png: told where there is no rasteriser: 69" sh -c "PATH=/nowhere '$cli' check --png '$tmp/p.png' '$tmp/scene.obj' 2> '$tmp/out'; \
    [ \$? = 69 ] && grep -q 'needs rsvg-convert' '$tmp/out' && test ! -e '$tmp/p.png'"
if command -v rsvg-convert > /dev/null; then
    part "png: a picture"             sh -c "'$cli' check --png '$tmp/p.png' '$tmp/scene.obj' && head -c 4 '$tmp/p.png' | grep -q PNG"
    part "png: nothing half written"  half "$cli" check --png "$tmp/half" "$here/../scenes/vault.obj"
fi
part "fixed: names with spaces, as typed" sh -c "'$cli' gen two-cubes | sed -e '/fixed/d;/interface/d' -e 's/^o b0/o foot L/' | \
    '$cli' check --quiet --fixed 'b9*, foot L' - 2> '$tmp/out'; [ \$? = 64 ] && '$cli' gen two-cubes | sed -e '/fixed/d;/interface/d' -e 's/^o b0/o foot L/' | \
    '$cli' check --quiet --fixed 'b1, foot L' - | grep -q STABLE"
part "html: nothing half written"     half "$cli" check --html "$tmp/half" "$here/../scenes/vault.obj"
part "html: markup in names is text"  sh -c "'$cli' gen two-cubes | sed -e '/interface/d' -e 's/^o b1/o <b>\&/' | '$cli' check --html '$tmp/p.html' - && \
    grep -q '<li>&lt;b&gt;&amp;</li>' '$tmp/p.html' && ! grep -q '<b>' '$tmp/p.html'"
if command -v node > /dev/null; then
    part "html: turns, moves, sorts"  sh -c "'$cli' gen overhang factor=1.1 | '$cli' check --html '$tmp/p.html' - > '$tmp/out'; \
        node '$here/page.js' '$tmp/p.html'"
    part "html: of 3000 joints the longest forces of their places" sh -c "'$cli' gen wall rows=25 bricks=45 tilt=25 azimuth=90 | '$cli' check --html '$tmp/p.html' - \
        > '$tmp/out'; node '$here/page.js' '$tmp/p.html'"
else echo "skipped html: turns, moves, sorts (nodejs)"; fi
part "html: --quiet is not for the page" sh -c "'$cli' check --quiet --html '$tmp/p.html' '$tmp/scene.obj' && grep -q '<dt>why</dt>' '$tmp/p.html'"
part "html: of a limit, its hinges"   sh -c "'$cli' gen arch t=0.15 | '$cli' limit --body 1,0,0 --html '$tmp/p.html' - > '$tmp/out' && \
    [ \$(grep -c '<td>hinge</td>' '$tmp/p.html') = 4 ] && grep -q '^\"h\":\[\[\[' '$tmp/p.html' && grep -q '<h1>-: MULTIPLIER 0.149' '$tmp/p.html'"
tilt_margin_files() {                                   # all forms of it; the model and the page have the worst mechanism
    "$cli" gen topple angle=5 > "$tmp/t.obj" &&
    "$cli" limit --tilt-margin --svg "$tmp/p.svg" --html "$tmp/p.html" --csv "$tmp/t" --out-obj "$tmp/m.obj" "$tmp/t.obj" > "$tmp/out" &&
    grep -q '<h1>.*TILT MARGIN 9.036' "$tmp/p.html" && grep -q '<td>hinge</td>' "$tmp/p.html" && grep -q 'id="view"' "$tmp/p.html" &&
    [ "$(grep -c '^<tr><td>[0-9.]*</td><td>[0-9.]*</td></tr>$' "$tmp/p.html")" -eq 72 ] && grep -q '^g moved' "$tmp/m.obj" &&
    [ "$(wc -l < "$tmp/t-tilt.csv")" -eq 73 ] && grep -q '^0,9.036' "$tmp/t-tilt.csv" && grep -q ',hinge' "$tmp/t-joints.csv" &&
    grep -q 'Stands tilted by up to 9.04' "$tmp/p.svg"
}
tilt_margin_falls() {                                   # a page and an empty table, too, where it falls while level
    "$cli" gen two-cubes offset=0.6 > "$tmp/t.obj"
    "$cli" limit --tilt-margin --svg "$tmp/p.svg" --html "$tmp/p.html" --csv "$tmp/t" --out-obj "$tmp/m.obj" "$tmp/t.obj" > "$tmp/out"
    [ $? -eq 1 ] && grep -q '>Does not stand while level<' "$tmp/p.svg" && grep -q '<h1>.*does not stand while level' "$tmp/p.html" && [ "$(wc -l < "$tmp/t-tilt.csv")" -eq 1 ]
}
"$cli" gen wall rows=25 bricks=45 > "$tmp/many.obj"
part "svg: of 3000 joints the largest forces where they crowd" sh -c "'$cli' check --svg '$tmp/p.svg' '$tmp/many.obj' > '$tmp/out' && \
    grep -q 'holds; where they crowd, the largest<' '$tmp/p.svg' && [ \$(grep -c '^<g opacity' '$tmp/p.svg') -lt 1200 ]"
part "svg: of few joints all forces"   sh -c "'$cli' gen arch | '$cli' check --svg '$tmp/p.svg' - > '$tmp/out' && ! grep -q 'where they crowd' '$tmp/p.svg'"
part "svg: says whether it is coupled" sh -c "'$cli' gen arch | '$cli' check --coupled --svg '$tmp/p.svg' - > '$tmp/out' && grep -q '>stable, coupled<' '$tmp/p.svg'"
part "svg: says whether it is strong"  sh -c "'$cli' gen two-cubes | '$cli' check --strong --svg '$tmp/p.svg' - > '$tmp/out' && grep -q '>stable, strong<' '$tmp/p.svg'"
part "svg: no hinge's line over a disc" sh -c "'$cli' gen arch t=0.15 | '$cli' limit --body 1,0,0 --svg '$tmp/p.svg' - > '$tmp/out' && \
    awk '/<path.*#6a1b9a/ { if (disc) bad++ } /<circle.*#6a1b9a/ && \$0 !~ /path/ { disc = 1 } /<text/ { exit bad > 0 }' '$tmp/p.svg'"
part "tilt margin: the plot names the scene" sh -c "'$cli' gen topple angle=5 > '$tmp/t.obj'; \
    '$cli' limit --tilt-margin --svg '$tmp/p.svg' '$tmp/t.obj' > '$tmp/out' && grep -q '>t.obj</tspan>' '$tmp/p.svg'"
part "tilt margin: page, tables, model" tilt_margin_files
part "tilt margin: of what falls level" tilt_margin_falls
part "out-obj: a picture, no scene"     sh -c "'$cli' check --out-obj '$tmp/m.obj' '$tmp/scene.obj' && ! '$cli' check '$tmp/m.obj' 2> '$tmp/out' && \
    grep -q 'picture that --out-obj wrote' '$tmp/out'"
part "out-obj: nothing half written"  half "$cli" check --out-obj "$tmp/half" "$here/../scenes/vault.obj"
part "csv: every line has all columns" tables check "$tmp/scene.obj" joints 22 blocks 23
part "csv: of a limit"                tables limit "$tmp/scene.obj" --body 1,0,0 joints 22 blocks 23
part "csv: of a sequence"             tables sequence "$tmp/scene.obj" steps 21
part "csv: one scene: 64"             exits 64 "$cli" check --csv "$tmp/t" "$tmp/scene.obj" "$tmp/scene.obj"
for name in '' "$tmp/" "$tmp//"; do
    part "csv: no name in '${name#"$tmp"}': 64" no_name "$name"
done
part "csv: nothing half written"      sh -c "mkdir -p '$tmp/dir/t-blocks.csv'; ! '$cli' check --csv '$tmp/dir/t' '$tmp/scene.obj' 2> '$tmp/out' &&
    test \$(wc -l < '$tmp/out') = 1"
part "convert: nothing half written" half "$cli" convert "$here/../scenes/vault.obj" "$tmp/half"
part "files are replaced when they are whole" replaces
part "svg over the scene: 64"       writes_over "--svg would write over '.*other.obj', which is read" check --svg "$tmp/other.obj" "$tmp/scene.obj"
part "page over the scene: 64"      writes_over "--html would write over" limit --body 1,0,0 --html "$tmp/scene.obj" "$tmp/scene.obj"
part "table over the order: 64"     writes_over "--csv would write over '.*t-steps.csv'" sequence --csv "$tmp/t" --order-file "$tmp/t-steps.csv" "$tmp/scene.obj"
part "convert over what stands beside: 64" writes_over "convert would write over" convert "$tmp/scene.obj" "$tmp/scene.obj.stonepack"
part "two outputs of one name: 64"  writes_over "--svg and --html both write" check --svg "$tmp/x.svg" --html "$tmp/./x.svg" "$tmp/scene.obj"
part "cost: svg over the scene: 64" writes_over "--svg would write over" cost --svg "$tmp/scene.obj" "$tmp/scene.obj"
part "convert in place"             in_place
part "convert in place, a file beside it: 64" beside_in_place
"$cli" gen arch > "$tmp/twenty.obj"
"$cli" gen two-cubes > "$tmp/two.obj"
for written in --svg --html --out-obj; do
    part "the answer, though $written fails: 70" answers 70 ': STABLE$' check $written "$tmp/none/x" "$tmp/twenty.obj"
done
part "the answer, though --csv fails: 70"   answers 70 ': STABLE$' check --csv "$tmp/none/t" "$tmp/twenty.obj"
part "the answer in JSON likewise: 70"      answers 70 '"verdict": *"stable"' check --json --svg "$tmp/none/x" "$tmp/twenty.obj"
part "the multiplier likewise: 70"          answers 70 ': MULTIPLIER' limit --body 1,0,0 --svg "$tmp/none/x" "$tmp/twenty.obj"
part "the tilt margin likewise: 70"         answers 70 'degrees' limit --tilt-margin --svg "$tmp/none/x" "$tmp/twenty.obj"
part "the build order likewise: 70"         answers 70 ': 20 steps, ' sequence --svg "$tmp/none/x" "$tmp/twenty.obj"
part "the costs likewise: 70"               answers 70 ': stable by the exact' cost --svg "$tmp/none/x" "$tmp/two.obj"
part "one thing is not told as many"        one_of_each
part "sequence: motions left out are told"  dropped
for form in ply stl JSON 3dm; do
    part "convert to .$form: 64"    writes_over "writes OBJ" convert "$tmp/scene.obj" "$tmp/x.$form"
done
part "a body of zeros is told"      sh -c "'$cli' limit --body 0,0,0 x 2>&1 | grep -q 'DX,DY,DZ, not all 0'"
part "sequence: names with blanks"  spaced
part "sequence: a name that is cut: told" spaced_cut
part "help --help"                  sh -c "'$cli' help --help > '$tmp/a' && '$cli' --help | cmp - '$tmp/a'"
part "svg: nothing half written"    half "$cli" check --svg "$tmp/half" "$here/../scenes/vault.obj"
part "effects: friction, not needed" sh -c "'$cli' gen two-cubes | '$cli' check --effects -friction - | grep -q ': STABLE'"
part "effects: friction, each way"  each_way friction 'off .* left out by' 2 '^  left out  *friction$'
part "effects: depth, each way"     each_way depth 'off .* mirror' 0 ': STABLE'
part "effects: together, each way"  each_way together 'on .* calls for' 0 ': STABLE'
ram_is_taken() {                                        # scene and check are the memory a check reports; constants for firmware
    gen wall rows=4 bricks=6 && "$cli" plan --ram --json "$tmp/scene.obj" > "$tmp/a" && "$cli" check --json "$tmp/scene.obj" > "$tmp/b" || return 1
    ram=$(($(sed -n 's/.*"scene": \([0-9]*\),.*"check": \([0-9]*\),.*/\1 + \2/p' "$tmp/a")))
    [ "$ram" -gt 0 ] && grep -q "\"memory_bytes\": $ram[,}]" "$tmp/b" || { echo "plan: $ram"; grep -o '"memory_bytes": [0-9]*' "$tmp/b"; return 1; }
    says 'SP_CHECK_BYTES(27, 64, 256, ' "$cli" plan --ram "$tmp/scene.obj"
}
part "plan --ram: bytes and constants" ram_is_taken
part "effects: two at once"         says '^together *on .* the caller' "$cli" plan --effects -depth,+together "$tmp/scene.obj"
part "effects: depth, called for"   sh -c "'$cli' gen dome | '$cli' check --effects -depth - | grep -q '^  left out  *depth$'"
part "effects: no such one: 64"     exits 64 "$cli" check --effects +wind "$tmp/scene.obj"
part "effects: no name: 64"         exits 64 "$cli" check --effects "" "$tmp/scene.obj"
part "effects: the scene's own: 64" exits 64 "$cli" check --effects +loads "$tmp/scene.obj"
part "effects: and which can be forced" sh -c "'$cli' check --effects -strength '$tmp/scene.obj' 2>&1 | grep -q 'forces friction, depth, together, coupled'"
part "effects: + and - of one: 64"  exits 64 "$cli" check --effects +friction,-friction "$tmp/scene.obj"
part "effects: in two lists, too"   exits 64 "$cli" check --effects +depth --effects -depth "$tmp/scene.obj"
part "effects: +coupled asks"       says '^coupled *on' "$cli" plan --effects +coupled "$tmp/scene.obj"
part "effects: -coupled does not"   says '^coupled *off' "$cli" plan --effects -coupled "$tmp/scene.obj"
part "effects: -coupled, --coupled: 64" exits 64 "$cli" check --coupled --effects -coupled "$tmp/scene.obj"
part "sequence: admm is named: 64"  sh -c "'$cli' sequence --stages admm '$tmp/scene.obj' 2>&1 | grep -q 'a sequence has no stage admm'"
part "tol: friction brings it down" sh -c "'$cli' check --mu 8e-11 '$tmp/scene.obj' | grep -q '^  tol .*1e-11 instead of 1e-09: an eighth of the least friction'"
part "tol: a coupled check does"    sh -c "'$cli' check --tol 1e-3 --coupled '$tmp/scene.obj' | grep -q '^  tol .*1e-06 instead of 0.001: a coupled check'"
part "tol: as asked"                says '"tol_by": *"asked"' "$cli" check --json "$tmp/scene.obj"
part "standard input"               sh -c "'$cli' check - < '$tmp/scene.obj'"
part "write, read: same result"     round_trip
part "refuted: the proof, read again"  refuted
part "verify: the question is its own"  another
part "verify: a bound on forces that is not the caller's is told" bound_told
part "verify: a motion that goes farther than the caller's eta is not believed" reach_believed
part "help: words don't ask, and say how" sh -c "'$cli' check tests/scenes/overhang-falling.obj | grep -q '^  help           --localise' && '$cli' check tests/scenes/overhang-falling.obj | grep -q '^  weakest joint  b7 - b8: opens$'"
part "help: --localise asks"           sh -c "'$cli' check --localise tests/scenes/overhang-falling.obj | grep -q '^  weakest joint  b0 - b1: asks for 100 N of tension' && ! '$cli' check --localise tests/scenes/overhang-falling.obj | grep -q '^  help'"
part "help: JSON asks by itself"       says '"tension": 100[.]4' "$cli" check --json tests/scenes/overhang-falling.obj
part "help: so do pictures"            sh -c "'$cli' check --svg '$tmp/help.svg' tests/scenes/overhang-falling.obj > /dev/null; grep -q 'lacks 100 N of tension' '$tmp/help.svg'"
part "help: a stone in the air has none to ask" sh -c "grep -v '^#@ fixed' tests/scenes/two-cubes.obj | '$cli' check - > '$tmp/free'; grep -q UNSTABLE '$tmp/free' && ! grep -q '^  help' '$tmp/free' && grep -q '^  weakest joint  none' '$tmp/free'"
part "what slides is told so"          sh -c "'$cli' gen incline angle=45 | '$cli' check - | grep -q '^  weakest joint  b0 - b1: slides$'"
part "a plain wall: none near its limit" sh -c "'$cli' gen wall rows=4 bricks=6 | '$cli' check - | grep -q '^  weakest joint  none is near its limit'"
part "JSON of a plain wall: no limit is near" sh -c "'$cli' gen wall rows=4 bricks=6 | '$cli' check --json - | grep -q '\"nearest_limit\": *null'"
nearest() {                                             # nearest KIND TEXT GEN-ARGUMENTS...: told in words, JSON and picture
    kind=$1 near=$2
    shift 2
    { "$cli" gen "$@" && echo "$more"; } > "$tmp/near.obj" && says "weakest joint  b0 - b1: near $near 100 %" "$cli" check --svg "$tmp/near.svg" "$tmp/near.obj" &&
    grep -q "near $near 100 %" "$tmp/near.svg" && says "\"nearest_limit\": *{\"interface\": *0, *\"by\": *\"$kind\", *\"share\": *0.9999.*\"known\": *true" "$cli" check --json "$tmp/near.obj"
}
more=''
part "a cube that all but tips is near its limit" nearest tipping 'tipping about an edge, its force' two-cubes offset=0.499999
part "a stack that all but falls is near its limit" nearest tipping 'tipping about an edge, its force' overhang factor=0.999999
part "a slope that all but lets go is near its limit" nearest sliding 'sliding, friction used to' incline angle=40.03
more='#@ load b1 0 0 0 0 0 13979.633 couple'
part "a cube that all but turns is near its limit" nearest turning 'turning, friction of its corners used to' two-cubes offset=0
part "compression of a joint and a corner" sh -c "'$cli' gen two-cubes | '$cli' check - | grep -q 'compression .* of a joint, .* at a corner'"
part "friction of a joint and a corner" sh -c "'$cli' gen arch | '$cli' check - | grep -q 'friction used to .* %, to .* % at a corner'"
part "friction of a corner in JSON"     sh -c "'$cli' gen arch | '$cli' check --json - | grep -q '\"max_corner_utilisation\".*\"corner_utilisation\"'"
part "nothing fixed: told first"        sh -c "'$cli' gen two-cubes | sed '/fixed/d' | '$cli' check - | sed -n 2p | grep -q 'nothing is fixed'"
part "a bad scene among others"     goes_on
part "skip-done: a stopped run goes on" resumed
part "jobs: several at a time, the same answers in the same order" beside
part "jobs: one scene by threads, the same answers" by_threads
part "jobs: a full disk is no answer" torn
part "jobs: what is no number of cores is refused" exits 64 "$cli" check --jobs 0 "$tmp/scene.obj"
part "sequence: an arch without centring falls: 1" exits 1 "$cli" sequence "$tmp/scene.obj"
part "sequence: the step that fails first" says '"first_failing": *4,' "$cli" sequence --json "$tmp/scene.obj"
part "sequence: what must be held"  says '^ *19 + b19 .*hold b19! (minimal)' "$cli" sequence "$tmp/scene.obj"
part "sequence: the last one closes it" says '^ *20 + b20  *stable' "$cli" sequence "$tmp/scene.obj"
part "sequence: taken down by half" says '^ *2 - b19  *UNSTABLE' "$cli" sequence --remove --order b20,b19 "$tmp/scene.obj"
part "sequence: a strip"            exits 1 "$cli" sequence --svg "$tmp/strip.svg" "$tmp/scene.obj"
part "sequence: the strip has an end" sh -c "grep -q 'to be held' '$tmp/strip.svg' && tail -1 '$tmp/strip.svg' | grep -q '</svg>'"
part "sequence: how many steps it shows" sh -c "'$cli' gen arch n=40 | '$cli' sequence --svg '$tmp/long.svg' - > '$tmp/out'; \
    grep -q '40 steps (24 shown), step' '$tmp/long.svg' && ! grep -q ' shown)' '$tmp/strip.svg'"
part "sequence: nothing half written" half "$cli" sequence --svg "$tmp/half" "$tmp/scene.obj"
part "sequence: small blocks have a ring" sh -c "'$cli' gen tower n=200 lean=0 | '$cli' sequence --svg '$tmp/long.svg' - > '$tmp/out' && \
    [ \$(grep -c 'class=\"ring\"' '$tmp/long.svg') = 24 ]"
outside() { awk '/^<svg x=/ { inside = 1 } /^<\/svg>/ { inside = 0 } /class="ring"/ && inside { bad++ } END { exit bad > 0 }' "$1"; }
part "sequence: rings are not cut off" outside "$tmp/long.svg"
part "sequence: a page of it"        sh -c "'$cli' sequence --html '$tmp/p.html' '$tmp/scene.obj' > '$tmp/out'; \
    [ \$(grep -c '<tr><td><button type=\"button\">[0-9]' '$tmp/p.html') = 20 ] && grep -q '<td>b4</td><td>UNSTABLE</td><td>b3</td>' '$tmp/p.html' && grep -q '</svg>' '$tmp/p.html'"
if command -v node > /dev/null; then
    part "sequence: its page turns and shows the steps" sh -c "'$cli' gen arch n=15 | '$cli' sequence --html '$tmp/p.html' - > '$tmp/out'; node '$here/page_steps.js' '$tmp/p.html'"
    part "sequence: a page of what is taken down" sh -c "'$cli' gen arch n=15 | '$cli' sequence --remove --html '$tmp/p.html' - > '$tmp/out'; grep -q '\"remove\":1' '$tmp/p.html'"
else echo "skipped sequence: its page turns (nodejs)"; fi
part "sequence: a model of its steps"  sh -c "'$cli' sequence --out-obj '$tmp/m.obj' '$tmp/scene.obj' > '$tmp/out'; \
    grep -A1 '^o 0004_b4' '$tmp/m.obj' | grep -q '^g falls' && grep -A1 '^o 0020_b20' '$tmp/m.obj' | grep -q '^g stands' && \
    grep -A1 '^o b0' '$tmp/m.obj' | grep -q '^g start'"
moved_of_steps() {                                      # of each step that falls who moves, elsewhere than in `falls`; of others none
    gen arch n=7 t=0.2 && "$cli" sequence --order b1,b7,b2,b6,b3,b5,b4 --out-obj "$tmp/m.obj" "$tmp/scene.obj" > "$tmp/out"
    awk '/^o /{ name = $2 } /^g moved/ { split(name, w, "_"); step[w[1]]++ }
        END { exit !(step["0003"] && step["0006"] && !step["0001"] && !step["0002"] && !step["0007"]) }' "$tmp/m.obj" || return 1
    awk '/^o 0003_b2$/ { k = 1 } /^o 0003_b2_moved$/ { k = 2 } /^o / && !/0003_b2/ { k = 0 } /^v / && k { p[k, ++n[k]] = $0 }
        END { for (i = 1; i <= 8; i++) d += p[1, i] != p[2, i]; exit !(n[1] == 8 && n[2] == 8 && d >= 4) }' "$tmp/m.obj"
}
part "sequence: a model of what moves" moved_of_steps
if command -v rsvg-convert > /dev/null; then
    part "sequence: a strip as PNG"     sh -c "'$cli' sequence --png '$tmp/p.png' '$tmp/scene.obj' > '$tmp/out'; head -c 4 '$tmp/p.png' | grep -q PNG"
    part "tilt margin: a plot as PNG"   sh -c "'$cli' gen two-cubes | '$cli' limit --tilt-margin --png '$tmp/p.png' - > '$tmp/out' && head -c 4 '$tmp/p.png' | grep -q PNG"
fi
part "sequence: unknown name: 64"   exits 64 "$cli" sequence --order b1,none "$tmp/scene.obj"
part "sequence: two orders: 64"     exits 64 "$cli" sequence --order b1 --order-file x "$tmp/scene.obj"
part "sequence: no order file: 66"  exits 66 "$cli" sequence --order-file "$tmp/none.txt" "$tmp/scene.obj"
printf 'b1 b2 # left\n\nb3 b1\n' > "$tmp/order.txt"
part "sequence: twice the same: 65" exits 65 "$cli" sequence --order-file "$tmp/order.txt" "$tmp/scene.obj"
part "sequence: twice: file:line"   refuses "order.txt:3: 'b1' comes twice"
printf 'b1\n# right\nnone\n' > "$tmp/order.txt"
part "sequence: unknown: file:line" refuses "order.txt:3: the scene has no block 'none'"
printf 'b1\nb2 b3\n\n' > "$tmp/order.txt"
part "sequence: missing: file:line" refuses "order.txt:2: the order ends without 'b4'"
printf 'b1\nb0\n' > "$tmp/order.txt"
part "sequence: a support: file:line" refuses "order.txt:2: 'b0' is a support"
"$cli" gen wall size=54 > "$tmp/wall.obj"
part "sequence: a wall stands: 0"   exits 0 "$cli" sequence --suggest "$tmp/wall.obj"
part "sequence: what comes next"    says '^ *1 + b1  *stable  *next b2$' "$cli" sequence --suggest "$tmp/wall.obj"
part "worker: selftest"             exits 0 "$cli" worker --selftest
part "worker: a scene there and back" says 'same bits' "$cli" worker --roundtrip "$here/../scenes/vault.obj"
part "worker: nothing to answer"    exits 0 "$cli" worker < /dev/null
part "worker: input that can't be read: 65" exits 65 "$cli" worker < /
part "worker: no message: 65"       exits 65 sh -c "echo nonsense | '$cli' worker"
part "worker: check by one"         worked
gen wall size=2000
part "worker: no time: 70"          exits 70 "$cli" check --worker 0.000001 "$tmp/scene.obj"
part "worker: no time, fallback"    exits 0 "$cli" check --worker 0.000001 --fallback "$tmp/scene.obj"
gen wall size=10000
part "worker: too little memory: 71" exits 71 "$cli" check --stages gates,dense --worker 60,400 "$tmp/scene.obj"
part "cost: table, picture, JSON"     costs arch n=5
gen arch n=20 t=0.15
part "limit: a number"              says '"multiplier": 0.1' "$cli" limit --json --body 1,0,0 "$tmp/scene.obj"
part "limit: both ends verified"    says 'a mechanism falls at 0.1.*; verified' "$cli" limit --body 1,0,0 "$tmp/scene.obj"
"$cli" gen incline angle=20 mu=0.2 > "$tmp/slips.obj"
part "limit: held by its live load" says 'falls under the dead loads alone.*0.15284' "$cli" limit --body -1,0,0 "$tmp/slips.obj"
part "limit: and so in JSON"       says '"falls_under_dead_loads": true, "lowest": 0.15284' "$cli" limit --json --body -1,0,0 "$tmp/slips.obj"
"$cli" gen two-cubes mu=1e-9 > "$tmp/slick.obj"
part "limit: not nearer than tol"  says 'known to within .* only' "$cli" limit --body 1,0,0 "$tmp/slick.obj"
part "limit: why tol was lowered"  says 'an eighth of the least friction' "$cli" limit --body 1,0,0 "$tmp/slick.obj"
part "tilt margin: nor that"       says 'known to within .* only' "$cli" limit --tilt-margin "$tmp/slick.obj"
part "limit: that in JSON"          says '"tol_by": "least friction"' "$cli" limit --json --body 1,0,0 "$tmp/slick.obj"
part "limit: hinges by name"        says '^  hinges  *b' "$cli" limit --body 1,0,0 "$tmp/scene.obj"
part "limit: says that friction makes it an upper value" says 'upper value' "$cli" limit --body 1,0,0 "$tmp/scene.obj"
part "limit: down has no end, 0"    exits 0 "$cli" limit --body 0,0,-1 "$tmp/scene.obj"
part "limit: no end in JSON"        says '"multiplier": "unbounded"' "$cli" limit --json --body 0,0,-1 "$tmp/scene.obj"
bracket() {                                             # one end known, or both, for one of these budgets
    "$cli" gen wall rows=6 bricks=8 > "$tmp/w.obj"
    for budget in 5e6 6e6 7e6 8e6 9e6 1e7; do
        "$cli" limit --body 1,0,0 --budget $budget --svg "$tmp/p.svg" "$tmp/w.obj" > "$tmp/out"
        if [ $? -eq 2 ] && grep -q 'a mechanism falls at 0.7[0-9]*; the search spent its budget<' "$tmp/p.svg"; then return 0; fi
    done
    return 1
}
part "limit: picture of an undecided tells what it knows, and why" bracket
part "check: picture of an undecided tells why" sh -c "'$cli' gen wall rows=6 bricks=8 | '$cli' check --tilt 25 --budget 2e5 --svg '$tmp/p.svg' - > '$tmp/out'; \
    [ \$? = 2 ] && grep -q '>the search gave up, its work spent .* within tol, 1e-09<' '$tmp/p.svg'"
part "limit: picture"               exits 0 "$cli" limit --svg "$tmp/limit.svg" --body 1,0,0 "$tmp/scene.obj"
part "limit: picture names hinges"  grep -q '4 hinges' "$tmp/limit.svg"
part "limit: nothing live: 64"      exits 64 "$cli" limit "$tmp/scene.obj"
part "limit: no direction: 64"      exits 64 "$cli" limit --body 1,0 "$tmp/scene.obj"
gen topple angle=13
part "limit: tilt margin of a block of 1 : 4 that leans already" says '"tilt_margin": 1.0362434' "$cli" limit --tilt-margin --json "$tmp/scene.obj"
part "limit: just below the tilt margin it stands tilted, just above it falls" margin_is_tilt "0 0 -9.80665" xyz 0.6
part "limit: so it does where gravity leans" margin_is_tilt "1.1 -2.3 -9.2" xyz 0.8
part "limit: or points along x" margin_is_tilt "-9.3 0.8 -1.9" zxy 0.6
part "limit: or along y"        margin_is_tilt "2.1 -9.4 1.3" yzx 0.8
"$cli" gen wall rows=3 bricks=3 > "$tmp/wall.obj"
part "tilt margin: --sliding real: atan of the sliding state of limit" says '"upper": 35.5376777' "$cli" limit --tilt-margin --sliding real --json "$tmp/wall.obj"
part "tilt margin: that in words"   says 'towards azimuth 180 a sliding state at 35.5377 degrees' "$cli" limit --tilt-margin --sliding real "$tmp/wall.obj"
part "limit: --tilt-margin or --body" exits 64 "$cli" limit --tilt-margin --body 1,0,0 "$tmp/scene.obj"
part "limit: polar plot"            exits 0 "$cli" limit --tilt-margin --svg "$tmp/tilt.svg" "$tmp/scene.obj"
part "limit: a decided margin is no lower bound" says '"at_least": false' "$cli" limit --tilt-margin --json "$tmp/scene.obj"
echo '#@ cohesion 2e4' | cat - "$tmp/scene.obj" > "$tmp/glued.obj"
part "limit: no tilt margin of joints with strength" exits 64 "$cli" limit --tilt-margin "$tmp/glued.obj"
gen arch t=0.2
part "limit: what is undecided while level is not told to fall" exits 2 "$cli" limit --tilt-margin --budget 1e5 "$tmp/scene.obj"
gen topple angle=15
part "limit: falls at any: null, 0" says '"multiplier": null' "$cli" limit --json --body 1,0,0 "$tmp/scene.obj"
part "limit: does not stand level: 1" exits 1 "$cli" limit --tilt-margin "$tmp/scene.obj"
arrives() {                                             # every command tells that its output could not be written
    for arrives_of in check 'check --json' plan contacts sequence 'limit --tilt-margin' 'limit --json --body 1,0,0' convert \
        --help --version 'check --help'; do
        $cli $arrives_of "$tmp/scene.obj" > /dev/full 2> "$tmp/err"
        test $? -eq 70 && test "$(wc -l < "$tmp/err")" -eq 1 || { echo "$arrives_of"; return 1; }
    done
}
if [ -e /dev/full ]; then part "a full disc is told: 70" arrives; fi
gen wall size=2000
part "limit: on a budget: 2"        exits 2 "$cli" limit --budget 1e7 --body 1,0,0 "$tmp/scene.obj"
part "check on a budget"               on_a_budget
qps
for b in sparse dense cg; do
    part "qp: $b"                   says 'objective 8.371' "$cli" qp --backend $b "$tmp/small.qps"
done
part "qp: json"                     says '"status": "solved"' "$cli" qp --json --eps 1e-5 "$tmp/small.qps"
edited 's/QUADOBJ/QMATRIX/; s/^    x         y         2.0/&\n    y         x         2.0/'
part "qp: the whole matrix"         says 'objective 8.371' "$cli" qp "$tmp/edited.qps"
edited 's/^    x  /    x a/; s/bnd       x  /bnd       x a/; s/^    x a       y         2.0/    y         x a       2.0/; s/^    x a       x  /    x a       x a/'
part "qp: fixed format, a blank in a name" says 'objective 8.371' "$cli" qp "$tmp/edited.qps"
part "qp: infeasible: 1"            sh -c "sed 's/^ UP bnd       x         20.0/ UP bnd x 0.1\n UP bnd y 0.1/' '$tmp/small.qps' > '$tmp/none.qps'; '$cli' qp '$tmp/none.qps'; test \$? -eq 1"
part "qp: ranges, bounds, largest, integers"  forms
part "qp: what can be read in two ways: 65"    ambiguous
edited 's/10.0$/1o.0/'
part "qp: a bad number: 65"         exits 65 "$cli" qp "$tmp/edited.qps"
part "qp: file:line"                sh -c "'$cli' qp '$tmp/edited.qps' 2>&1 | grep -q 'edited.qps:20: not a number'"
edited 's/10.0$/-10.0/'
part "qp: a saddle: 65"             exits 65 "$cli" qp "$tmp/edited.qps"
part "qp: dykstra, P not diagonal: 2" exits 2 "$cli" qp --solver dykstra "$tmp/small.qps"
part "qp: unknown solver: 64"        exits 64 "$cli" qp --solver simplex "$tmp/small.qps"
part "solver auto: the first there is"  first "$tmp/small.qps"
part "qp: a solver of others, or what to install" plugged "$tmp/small.qps"
part "qp: unknown back end: 64"     exits 64 "$cli" qp --backend gpu "$tmp/small.qps"
total
