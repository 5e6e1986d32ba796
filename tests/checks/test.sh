#!/bin/sh
# test: what `make test` runs: the tests in double, in float and with SP_SMALL, malformed scenes, the program, README.
# All of it starts at once, what takes longest first; answers come in the order below.
#
#     test.sh RUN...        these runners alone, as `make test ONLY=...` built them
. tests/checks/tally.sh
out=$(mktemp -d)
trap 'rm -rf "$out" "$tally_log"' EXIT

begin() {                                               # begin NAME COMMAND...
    begin_name=$1
    shift
    "$@" > "$out/$begin_name" 2>&1 &
    eval "pid_$begin_name=$!"
}
end() {                                                 # end NAME > what it printed; its status
    eval "wait \$pid_$1"
    end_status=$?
    cat "$out/$1"
    return $end_status
}

if [ $# -gt 0 ]; then
    SHOW=1
    for run; do begin "$(basename "$run")" "$run"; done
    for run; do count "tests, $(basename "$run")" end "$(basename "$run")"; done
    total
    exit
fi

begin float build/run_float
begin double build/run
begin small build/run_small
begin program sh tests/checks/smoke.sh build/stonepack
if [ -f build/bullet.o ]; then begin settle sh tests/checks/settle.sh build/stonepack; fi
begin floors sh tests/checks/floors.sh
begin windows sh tests/checks/windows.sh
begin header sh tests/checks/header.sh
begin bad sh tests/checks/bad.sh build/stonepack
begin models sh tests/checks/models.sh build/stonepack
begin compas sh tests/checks/compas.sh build/stonepack
if command -v python3 > /dev/null; then
    begin formats python3 -B tests/checks/formats.py build/stonepack
    begin bad_formats python3 -B tests/checks/bad_formats.py build/stonepack
    begin newcomer python3 -B tests/checks/newcomer.py build/stonepack
fi
begin readme sh tests/checks/readme.sh build/stonepack

count "tests, double" end double
count "tests, float" end float
count "tests, SP_SMALL" end small
count "floors" end floors
count "after windows.h" end windows
count "header" end header
count "bad scenes" end bad
count "program" end program
count "models of others" end models
count "models of COMPAS" end compas
if command -v python3 > /dev/null; then
    count "models in other forms" end formats
    count "bad models in other forms" end bad_formats
    count "a newcomer's export" end newcomer
else
    skip "models in other forms" python3
fi
if ! grep -q WITH_ASSIMP build/plugins; then skip "STL, PLY, glTF and others" "pkg-config libassimp-dev"; fi
if [ -f build/bullet.o ]; then count "settle, as a program" end settle; else skip "settle" "g++ libbullet-dev"; fi
count "README" end readme
part "floors of the program" sh tests/checks/host_floors.sh
total
