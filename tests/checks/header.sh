#!/bin/sh
# header: the first 150 lines of stonepack.h are enough for a newcomer. The program in its opening comment compiles, links and says
# what it says; one rule tells where to stop; the calls are few; every call is declared once; three languages take it.
. tests/checks/tally.sh
tmp=$(mktemp -d)
trap 'rm -rf "$tmp" "$tally_log"' EXIT

program() {
    { cat << 'END'
#include "stonepack.h"
#include <stdio.h>
int main(void)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
    static const sp_real low[24] = { 0,0,-1, 1,0,-1, 1,1,-1, 0,1,-1, 0,0,0, 1,0,0, 1,1,0, 0,1,0 };
    static const sp_real high[24] = { 0,0,0, 1,0,0, 1,1,0, 0,1,0, 0,0,1, 1,0,1, 1,1,1, 0,1,1 };
    const sp_mesh ground = { 8, 6, low, size, corner }, stone = { 8, 6, high, size, corner };
END
      sed -n '/^ \* A program/,/^ \*\//p' stonepack.h | sed -n 's/^ \*     //p'
      printf '%s\n' '    printf("%.6g %d\n", (double)force.force[2], (int)evidence.verdict); return 0; }'
    } > "$tmp/program.c"
    "${CC:-gcc}" -std=c99 -Wall -Wextra -Werror -O0 -I. "$tmp/program.c" stonepack.c -lm -o "$tmp/program" &&
        "$tmp/program" > "$tmp/said" && cat "$tmp/said" && printf 'stable\n23536 1\n' | diff - "$tmp/said"
}
stop() { awk '/You can stop here/ { n++; at = FNR } END { print "the rule stands at line " at; exit !(n == 1 && at <= 150) }' stonepack.h; }
few() { [ "$(grep -c '^SP_API' stonepack.h)" -le 60 ]; }
language() { echo '#include "stonepack.h"' > "$tmp/l.c" && "$@" -Wall -Wextra -Werror -fsyntax-only -I. "$tmp/l.c"; }

part "the program of the header's first lines" program
part "the rule stands within 150 lines" stop
part "at most 60 calls" few
part "stonepack.h, C99 pedantic" language "${CC:-gcc}" -std=c99 -pedantic
if command -v "${CXX:-g++}" > /dev/null 2>&1; then
    for std in c++98 c++11 c++17; do part "stonepack.h, $std" language "${CXX:-g++}" -x c++ -std=$std -Wno-long-long; done
fi
if command -v clang++ > /dev/null 2>&1; then part "stonepack.h, c++17 by clang, which warns of a type returned before it is known" \
    language clang++ -x c++ -std=c++17; fi
total
