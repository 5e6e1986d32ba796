#!/bin/sh
# figures: every picture of the README, from the program itself and from the bench's CSV.
#
#     tests/bench/figures/*.svg           scenes, drawn by build/stonepack
#     tests/bench/results/MACHINE/*.svg   curves, of the bench.csv beside them; need python3-matplotlib
set -eu
cli=build/stonepack
out=tests/bench/figures
mkdir -p $out build/figures
draw() {                                                # draw NAME GEN-ARGUMENTS...
    name=$1
    shift
    "$cli" gen "$@" > "build/figures/$name.obj"
    "$cli" check --svg "$out/$name.svg" "build/figures/$name.obj" > "build/figures/$name.txt" || [ $? -le 2 ]
    echo "$out/$name.svg"
}
draw arch arch n=15 t=0.14
draw arch-falling arch n=15 t=0.09
"$cli" gen arch n=20 t=0.15 > build/figures/arch-limit.obj
"$cli" limit --body 1,0,0 --svg $out/arch-limit.svg build/figures/arch-limit.obj > build/figures/arch-limit.txt
echo "$out/arch-limit.svg"
draw overhang-falling overhang n=6 factor=1.05
draw wall rubble rows=7 bricks=6
"$cli" gen arch n=7 t=0.2 > build/figures/steps.obj
"$cli" sequence --order b1,b7,b2,b6,b3,b5,b4 --svg $out/steps.svg build/figures/steps.obj > build/figures/steps.txt || [ $? -le 2 ]
echo "$out/steps.svg"
settle() {                                              # settle COUNT --frames SVG | -o SCENE
    "$cli" gen rubble count="$1" > build/figures/loose.obj
    "$cli" settle build/figures/loose.obj "$2" "$3" --set rest_steps=3000,energy=1e-6 > build/figures/settle.txt
    echo "$3"
}
if [ -f build/bullet.o ]; then
    settle 24 --frames $out/falling.svg
    settle 100 -o build/figures/heap.obj
    "$cli" check --svg $out/heap.svg build/figures/heap.obj > build/figures/heap.txt || [ $? -le 2 ]
else
    echo "figures: no heap without g++ and libbullet-dev" >&2
fi

python=/usr/bin/python3                                 # Debian's own, the one its python3-matplotlib belongs to
if ! $python -c 'import matplotlib' 2> /dev/null; then
    echo "figures: no curves without python3-matplotlib" >&2
    exit 0
fi
for csv in tests/bench/results/*/bench.csv; do
    if [ -f "$csv" ]; then $python tests/bench/plot.py "$csv" "${csv%/bench.csv}"; fi
done
