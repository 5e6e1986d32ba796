# program: what the scripts that run the program share; sourced as `. program.sh [build/stonepack]`, not run.
#
#     $here $cli $tmp                 this folder, the program, a folder that goes when the script ends
#     exits STATUS COMMAND...         does it end with this exit status?
here=$(dirname "$0")
. "$here/tally.sh"
cli=${1:-build/stonepack}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp" "$tally_log"' EXIT

exits() {
    want=$1
    shift
    "$@"
    got=$?
    [ $got -eq "$want" ] || { echo "exit status $got, want $want: $*"; return 1; }
}
