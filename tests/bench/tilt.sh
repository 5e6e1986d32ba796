#!/bin/sh
# tilt: what it takes to decide walls near collapse in their own plane, as CSV; counts only, the same on every machine.
#
#     tilt.sh [build/stonepack] > tilt.csv      walls of 180, 474 and 2004 joints, tilted along their length by 24 to 40 degrees
set -eu
cli=${1:-build/stonepack}
scene=$(mktemp)
trap 'rm -f "$scene"' EXIT
echo "joints,degrees,verdict,factorisations,interior,flops"
for size in 180 500 2000; do
    for angle in 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40; do
        "$cli" gen wall size=$size tilt=$angle > "$scene"
        "$cli" check --json "$scene" | tr -d ' ' | awk -v angle=$angle '{
            verdict = joints = ""
            if (match($0, /"verdict":"[a-z]*"/)) verdict = substr($0, RSTART + 11, RLENGTH - 12)
            if (match($0, /"interfaces":[0-9]*/)) joints = substr($0, RSTART + 13, RLENGTH - 13)
            sub(/.*"cost":/, "")
            match($0, /"factorisations":[0-9]*/); f = substr($0, RSTART + 17, RLENGTH - 17)
            match($0, /"interior":[0-9]*/); i = substr($0, RSTART + 11, RLENGTH - 11)
            match($0, /"flops":[0-9]*/); w = substr($0, RSTART + 8, RLENGTH - 8)
            print joints "," angle "," verdict "," f "," i "," w }' || true
    done
done
