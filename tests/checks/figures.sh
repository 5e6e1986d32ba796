#!/bin/sh
# figures: the pictures of the README, from the program itself, into build/figures/.
set -eu
cli=build/stonepack
out=build/figures
mkdir -p $out
draw() {                                                # draw NAME GEN-ARGUMENTS...
    name=$1
    shift
    "$cli" gen "$@" > "$out/$name.obj"
    "$cli" check --svg "$out/$name.svg" "$out/$name.obj" > "$out/$name.txt" || [ $? -le 2 ]
    echo "$out/$name.svg"
}
draw arch arch n=15 t=0.14
draw arch-falling arch n=15 t=0.09
draw wall rubble
draw dome dome
