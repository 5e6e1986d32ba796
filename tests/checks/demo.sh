#!/bin/sh
# demo: checks the scenes of tests/scenes and some made by formula, prints a table, draws pictures into build/demo/.
# Fails if a verdict is not the one known. build/demo/index.html shows them all.
set -eu
cli=build/stonepack
out=build/demo
wrong=0
scenes=0
mkdir -p $out
rm -f $out/*.svg $out/*.json $out/*.obj

field() { sed -n 's/.*"'"$1"'": *"\{0,1\}\([^",}]*\).*/\1/p' "$out/$name.json" | head -n 1; }

show() {                                                # show NAME SCENE.obj VERDICT
    name=$1
    status=0
    "$cli" check --json --svg "$out/$name.svg" "$2" > "$out/$name.json" || status=$?
    if [ $status -gt 2 ]; then echo "demo: $name: exit status $status" >&2; exit 1; fi
    printf '%-18s %7s %7s  %-10s %-8s %10.1e %10s %9.2f\n' "$name" "$(field blocks)" "$(field interfaces)" "$(field verdict)" \
        "$(field stage)" "$(field omega)" "$(field factorisations)" "$(field seconds | awk '{ print 1e3 * $1 }')"
    scenes=$((scenes + 1))
    if [ "$(field verdict)" != "$3" ]; then echo "demo: $name is known to be $3" >&2; wrong=1; fi
}

printf '%-18s %7s %7s  %-10s %-8s %10s %10s %9s\n' scene blocks joints verdict stage imbalance factorised ms
for scene in tests/scenes/*.obj; do
    name=$(basename "$scene" .obj)
    case $name in *-falling) verdict=unstable ;; *) verdict=stable ;; esac
    show "$name" "$scene" $verdict
done
while read -r name verdict args; do
    # shellcheck disable=SC2086
    "$cli" gen $args > "$out/$name.obj"
    show "$name" "$out/$name.obj" "$verdict"
done <<'END'
two-cubes-falling unstable two-cubes offset=0.6
diamond stable diamond rows=4
wall-large stable wall rows=8 bricks=8 jitter=0.35
wall-tilted unstable wall rows=8 bricks=8 jitter=0.35 tilt=12 azimuth=90
rubble-tilted unstable rubble tilt=40
vault-large stable vault
dome-large stable dome
END
heap() {                                                # a hundred stones fall; statics decides what they come to
    "$cli" gen rubble count=100 > $out/loose.obj
    "$cli" settle $out/loose.obj -o $out/heap.obj --frames $out/falling.svg --set rest_steps=3000,energy=1e-6
    name=heap
    "$cli" check --json --svg $out/heap.svg $out/heap.obj > $out/heap.json || [ $? -le 2 ] || exit 1
    echo "heap of 100 stones: $(field verdict), $(field interfaces) joints, $(field contact_vertices) points"
}
page() {                                                # index.html: every picture with its verdict
    echo '<!DOCTYPE html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>stonepack: demo</title>'
    echo '<style>body{font:16px sans-serif;margin:1em}figure{display:inline-block;width:min(30em,100%);margin:0 1em 1em 0;vertical-align:top}'
    echo 'img{width:100%}figcaption{font-size:90%}</style><h1>Does it stand?</h1>'
    for picture in "$out"/*.svg; do
        name=$(basename "$picture" .svg)
        verdict=
        if [ -f "$out/$name.json" ]; then verdict=": $(field verdict), $(field blocks) blocks, $(field interfaces) joints"; fi
        echo "<figure><a href='$name.svg'><img src='$name.svg' alt='$name'></a><figcaption>$name$verdict</figcaption></figure>"
    done
}
left=
if [ -f build/bullet.o ]; then heap; else left=" Not run: a heap of falling stones, which takes Bullet (apt-get install g++ libbullet-dev)."; fi
page > $out/index.html
if [ $wrong -ne 0 ]; then echo "demo: a verdict is not the one known, see above"; exit 1; fi
echo "All $scenes scenes got the verdict that is known; $out/index.html shows them.$left"
