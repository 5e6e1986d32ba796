#!/bin/sh
# bench: runs build/bench and tells it where and when: a short name of the machine (MACHINE, else kind and number of cores)
# and the date. CSV on standard output; arguments are the bench's own. To keep a result and draw it:
#
#     mkdir -p tests/bench/results/NAME && make -s bench > tests/bench/results/NAME/bench.csv && make figures
set -eu
name=${MACHINE:-}
if [ -z "$name" ]; then
    kind=$(sed -n 's/^model name[^:]*://p' /proc/cpuinfo 2> /dev/null | head -n 1 | tr '[:upper:]' '[:lower:]' |
        grep -oE 'xeon|epyc|ryzen|core|neoverse|cortex' | head -n 1) || kind=$(uname -m)
    name=$kind-$(getconf _NPROCESSORS_ONLN)core
fi
exec build/bench --machine "$name" --date "$(date +%Y-%m-%d)" "$@"
