#!/bin/sh
# test: what `make test` runs: the tests in double and in float, malformed scenes, the corpus, the program, README.
. tests/checks/tally.sh
count "tests, double" build/run
count "tests, float" build/run_float
if [ -f tests/checks/bad.sh ]; then count "bad scenes" sh tests/checks/bad.sh build/stonepack; fi
for real in double float; do
    part "same bits without optimisation, $real" env DIFFER=1 sh tests/corpus/corpus.sh $real "${CC:-gcc}" -O0
done
count "program" sh tests/checks/smoke.sh build/stonepack
if [ -f build/settle.o ]; then count "settle, as a program" sh tests/checks/settle.sh build/stonepack; else skip "settle" "g++ libbullet-dev"; fi
count "README" sh tests/checks/readme.sh build/stonepack
total
