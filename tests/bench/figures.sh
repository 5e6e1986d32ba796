#!/bin/sh
# figures: every picture of the pages, from the program itself and from the bench's CSV.
#
#     tests/bench/figures/*.svg           scenes, drawn by build/stonepack; concept.svg by concept.py
#     tests/bench/figures/accuracy.svg    of the cost.csv beside it
#     tests/bench/results/MACHINE/*.svg   curves, of the bench.csv beside them; need python3-matplotlib
#     tests/bench/figures/cost-*.svg      what accuracy costs on nine scenes, measured anew; cost.csv beside them
#     tests/bench/figures/near.csv        how near to a limit both sides are told
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
"$cli" check --strong --svg $out/cross-stool.svg $out/cross-stool.obj > build/figures/cross-stool.txt
echo "$out/cross-stool.svg"
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

python3 tests/bench/concept.py > $out/concept.svg && echo "$out/concept.svg"
accuracy() { python3 tests/bench/accuracy.py $out/cost.csv > $out/accuracy.svg && echo "$out/accuracy.svg"; }
accuracy

python=/usr/bin/python3                                 # Debian's own, the one its python3-matplotlib belongs to
if ! $python -c 'import matplotlib' 2> /dev/null; then
    echo "figures: no curves without python3-matplotlib" >&2
    exit 0
fi
# What accuracy costs: every cone, stage and tol, in double, mixed and float. COSTS=0: leave them as they are.
cost() {                                                # cost NAME GEN-ARGUMENTS...
    name=$1
    shift
    "$cli" gen "$@" > "build/figures/$name.obj"
    for real in '' _mixed _float; do
        "$cli$real" cost --json --budget "$most" "build/figures/$name.obj" >> build/figures/cost.jsonl || [ $? -le 2 ]
    done
    echo "$name: measured"
}
if [ "${COSTS:-1}" != 0 ]; then
    : > build/figures/cost.jsonl
    most=3e8
    cost wall-54 wall size=54 jitter=0.35
    cost wall-147 wall size=147 jitter=0.35
    cost wall-500 wall size=500 jitter=0.35
    cost arch-near-its-limit arch n=11 t=0.1051
    cost arch-just-too-thin arch n=11 t=0.1041
    cost dome dome rings=6 segments=12
    cost keystone-near-sliding keystone angle=20 mu=0.3713
    cost rubble rubble rows=7 bricks=6
    most=6e8
    cost wall-2000 wall size=2000 jitter=0.35
    compiler=$(${CC:-gcc} --version | head -n 1)
    $python tests/bench/cost.py build/figures/cost.jsonl $out "$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1), \
$(date +%Y-%m-%d), $compiler -O2"
fi
if [ "${COSTS:-1}" != 0 ]; then
    sh tests/bench/near.sh > build/figures/near.csv && mv build/figures/near.csv $out/near.csv
    echo "$out/near.csv"
    accuracy
fi
for csv in tests/bench/results/*/bench.csv; do
    if [ -f "$csv" ]; then $python tests/bench/plot.py "$csv" "${csv%/bench.csv}"; fi
done
