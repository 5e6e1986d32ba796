#!/bin/sh
# demo: checks a handful of generated scenes, prints a table, draws pictures into build/demo/.
set -eu
cli=build/stonepack
out=build/demo
mkdir -p $out

field() { sed -n 's/.*"'"$1"'": *"\{0,1\}\([^",}]*\).*/\1/p' "$out/$name.json" | head -n 1; }

printf '%-20s %7s %7s  %-10s %-10s %10s %9s\n' scene blocks joints verdict stage omega ms
while read -r name args; do
    [ -n "$name" ] || continue
    # shellcheck disable=SC2086
    "$cli" gen $args > "$out/$name.obj"
    status=0
    "$cli" check --json --svg "$out/$name.svg" "$out/$name.obj" > "$out/$name.json" || status=$?
    if [ $status -gt 2 ]; then echo "demo: $name: exit status $status" >&2; exit 1; fi
    printf '%-20s %7s %7s  %-10s %-10s %10.1e %9.2f\n' "$name" "$(field blocks)" "$(field interfaces)" "$(field verdict)" \
        "$(field stage)" "$(field omega)" "$(field seconds | awk '{ print 1e3 * $1 }')"
done <<'END'
two-cubes two-cubes
two-cubes-falling two-cubes offset=0.6
incline incline angle=30
overhang overhang n=8 factor=0.99
arch arch n=15 t=0.14
arch-thin arch n=15 t=0.09
flat-arch flat-arch
h-model h-model
diamond diamond rows=4
wall wall rows=8 bricks=8 jitter=0.35
wall-tilted wall rows=8 bricks=8 jitter=0.35 tilt=12 azimuth=90
rubble rubble
vault vault
dome dome
END
echo "pictures: $out/*.svg"
