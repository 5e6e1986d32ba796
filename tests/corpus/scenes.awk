# scenes: scene files (see port/host/README.md) as C, for machines without files.      awk -f scenes.awk FILE.obj... > build/scenes.h
#
# Each file becomes one compiled_scene of the table `compiled`, which corpus.c declares. Names of blocks are numbers here;
# what the committed scenes do not use (points, texture indices, several frictions) is refused.
function refuse(why) { print FILENAME ":" FNR ": " why > "/dev/stderr"; failed = 1; exit 1 }
function list(kind, name, text) { printf "static const %s %s_%d[] = {%s };\n", kind, name, scenes, text == "" ? " 0" : text }
function finish(   k) {
    if (!open) return
    list("sp_real", "xyz", xyz); list("int32_t", "vertices", vertices); list("int32_t", "faces", faces)
    list("uint32_t", "fixed", fixed); list("sp_real", "density", dense)
    list("int32_t", "size", size); list("int32_t", "corner", corner)
    list("int32_t", "pair", pair); list("int32_t", "points", points); list("sp_real", "point", point); print ""
    arrays = "xyz_@, vertices_@, faces_@, fixed_@, density_@, size_@, corner_@, pair_@, points_@, point_@"
    gsub("@", scenes + 0, arrays)
    table = table sprintf("    { \"%s\", %s, { %s }, %d, %d, %s },\n", title, mu, gravity, blocks, joints, arrays)
    scenes++
}
function close_block() {
    if (!blocks) return
    vertices = vertices " " nv ","; faces = faces " " nf ","
    fixed = fixed " " held ","; dense = dense " " own ","
}
FNR == 1 {
    if (open) close_block()
    finish()
    open = 1
    title = FILENAME; sub(/.*\//, "", title); sub(/\.obj$/, "", title)
    mu = "C(0.84)"; density = "C(2400)"; gravity = "C(0), C(0), C(-9.80665)"; blocks = joints = before = nv = nf = 0
    xyz = vertices = faces = fixed = dense = size = corner = pair = points = point = ""
    split("", number)
}
{ sub(/\r$/, "") }
$1 == "o" { close_block(); before += nv; nv = nf = 0; held = "0"; own = density; number[$2] = blocks++ }
$1 == "v" { nv++; for (k = 2; k <= 4; k++) xyz = xyz " C(" $k ")," }
$1 == "f" {
    nf++; size = size " " NF - 1 ","
    for (k = 2; k <= NF; k++) {
        if ($k !~ /^-?[0-9]+$/) refuse("vertex number " $k)
        corner = corner " " ($k < 0 ? nv + $k : $k - 1 - before) ","
    }
}
$1 == "#@" && $2 == "mu" { if (joints) refuse("friction of one joint"); mu = "C(" $3 ")" }
$1 == "#@" && $2 == "density" { if (blocks) own = "C(" $3 ")"; else density = "C(" $3 ")" }
$1 == "#@" && $2 == "gravity" { gravity = "C(" $3 "), C(" $4 "), C(" $5 ")" }
$1 == "#@" && $2 == "fixed" { held = "SP_FIXED" }
$1 == "#@" && $2 == "interface" {
    joints++
    pair = pair " " number[$3] ", " number[$4] ","
    points = points " " (NF - 4) / 3 ","
    for (k = 5; k <= NF; k++) point = point " C(" $k "),"
}
$1 == "#@" && $2 !~ /^(mu|density|gravity|fixed|interface)$/ { refuse("the word " $2) }
END {
    if (failed) exit 1
    close_block(); finish()
    print "static const compiled_scene compiled[] = {"
    printf "%s", table
    print "};"
}
