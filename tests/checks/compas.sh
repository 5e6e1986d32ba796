#!/bin/sh
# compas: files as COMPAS writes them, and bad ones.      compas.sh [build/stonepack]
. "$(dirname "$0")/program.sh"
case $cli in /*) ;; *) cli=$PWD/$cli ;; esac
cd "$tmp" || exit 1

# A scene file as one of the forms that COMPAS has had: assembly (2.x), value (1.x), network (0.x), model (compas_dem 0.2),
# elements (its earlier list), list (of meshes), bare (an assembly without supports and contacts).
json() {                                                # json FORM < SCENE
    awk -v form="$1" '
        function mesh(b,   k, t) {
            t = "{\"vertex\": {"
            for (k = 0; k < verts[b]; k++) t = t (k ? ", " : "") "\"" k "\": {\"x\": " x[b, k] ", \"y\": " y[b, k] ", \"z\": " z[b, k] "}"
            t = t "}, \"face\": {"
            for (k = 0; k < faces[b]; k++) t = t (k ? ", " : "") "\"" k "\": [" face[b, k] "]"
            return t "}, \"default_vertex_attributes\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0}}"
        }
        function wrap(type, what) {
            if (form == "value") return "{\"datatype\": \"" type "\", \"value\": " what "}"
            return form == "network" ? what : "{\"dtype\": \"" type "\", \"data\": " what ", \"guid\": \"0\"}"
        }
        function points(c,   k, n, t, p, q) {
            n = split(joint[c], p, " ")
            t = "["
            for (k = 1; k < n; k += 3) {
                q = "[" p[k] ", " p[k + 1] ", " p[k + 2] "]"
                t = t (k > 1 ? ", " : "") (form == "value" || form == "network" ? q : wrap("compas.geometry/Point", q))
            }
            return t "]"
        }
        function edge(c) {
            if (form == "network") return "{\"interface_points\": " points(c) "}"
            return "{\"" (form == "model" || form == "elements" ? "contacts" : "interfaces") "\": [" \
                wrap("compas_assembly.datastructures/Interface", "{\"points\": " points(c) "}") "]}"
        }
        function edges(   c, t) {
            t = "{"
            for (c = 0; c < joints && form != "bare"; c++) {
                if (form == "value") t = t (c ? ", " : "") "\"(" a[c] ", " b[c] ")\": " edge(c)
                else t = t (c == 0 ? "\"" a[c] "\": {" : a[c] == a[c - 1] ? ", " : "}, \"" a[c] "\": {") "\"" b[c] "\": " edge(c)
            }
            return t (joints && form != "bare" && form != "value" ? "}}" : "}")
        }
        BEGIN { joints = all = n = 0 }
        /^o / { n++; verts[n - 1] = faces[n - 1] = 0; at[$2] = n - 1; before = all }
        /^#@ fixed/ { fixed[n - 1] = 1 }
        /^v / { k = verts[n - 1]++; x[n - 1, k] = $2; y[n - 1, k] = $3; z[n - 1, k] = $4; all++ }
        /^f / { t = $2 - before - 1; for (k = 3; k <= NF; k++) t = t ", " ($k - before - 1); face[n - 1, faces[n - 1]++] = t }
        /^#@ interface/ { a[joints] = at[$3]; b[joints] = at[$4]; $1 = $2 = $3 = $4 = ""; joint[joints++] = $0 }
        END {
            element = form == "model" || form == "elements"
            for (i = n - 1; i >= 0; i--) {              # in no order: old files had none
                s = i in fixed ? "true" : "false"
                m = wrap("compas.datastructures/Mesh", mesh(i))
                if (form == "list") list = list (list ? ", " : "") wrap("compas.datastructures/Mesh", mesh(n - 1 - i))
                nodes = nodes (nodes ? ", " : "") "\"" i "\": " (element ? "{\"element\": \"guid" i "\"}" : \
                    "{\"block\": " m (form == "bare" ? "" : ", \"" (form == "network" ? "is_anchor" : "is_support") "\": " s) "}")
                data = "\"data\": {\"geometry\": " m ", \"is_support\": " s ", \"material\": \"stone\", \"transformation\": null}"
                elements = elements (elements ? ", " : "") (form == "model" ? "\"guid" i "\": " : "") "{\"dtype\": \"Block\", " data \
                    (form == "elements" ? ", \"guid\": \"guid" i "\"}" : "}")
            }
            graph = wrap("compas.datastructures/Graph", "{\"node\": {" nodes "}, \"edge\": " edges() "}")
            if (form == "list") print "[" list "]"
            else if (form == "network") print graph
            else if (element) print wrap("compas_dem.models/BlockModel", "{\"graph\": " graph ", \"elements\": " \
                (form == "model" ? "{" elements "}" : "[" elements "]") \
                ", \"materials\": {\"stone\": {\"dtype\": \"Stone\", \"data\": {\"density\": 2400}}}}")
            else print wrap("compas_assembly.datastructures/Assembly", "{\"graph\": " graph "}")
        }'
}
numbers() { sed -e 's/"scene": *"[^"]*"//' -e 's/"seconds": *[^,}]*//g'; }
same_answer() {                                         # same_answer FORM OPTION...: as the scene file's, every number
    form=$1
    shift
    json "$form" < given.obj > "$form.json"
    "$cli" check --json --mu 0.84 given.obj | numbers > want
    "$cli" check --json --mu 0.84 "$@" "$form.json" | numbers > got
    cmp want got
}
says() {                                                # says TEXT ARGUMENT...
    text=$1
    shift
    "$cli" check "$@" > said
    grep -q -e "$text" said || { cat said; return 1; }
}
refused() {                                             # refused TEXT < JSON: one line with it, 65
    cat > bad.json
    "$cli" check bad.json > out 2> err
    status=$?
    [ $status -eq 65 ] && [ ! -s out ] && [ "$(wc -l < err)" -eq 1 ] && grep -q -e "$1" err && return 0
    echo "exit status $status, want 65 and '$1'"
    cat err
    return 1
}
edited() { sed "$2" < "$3" | refused "$1"; }

"$cli" gen arch n=7 | "$cli" convert - | sed '/^#@ interface/d' > arch.obj
# Contacts as text: of every joint that is found its corners, from `contacts`.
"$cli" contacts --json arch.obj | tr -d ' \n' | sed 's/{"a":"/\n/g' | awk 'NR > 1 {
    a = $0; sub(/".*/, "", a); b = $0; sub(/[^"]*","b":"/, "", b); sub(/".*/, "", b)
    sub(/.*"points":\[\[/, ""); sub(/\]\].*/, ""); gsub(/[],[]+/, " "); print "#@ interface", a, b, $0 }' > joints.txt
cat arch.obj joints.txt > given.obj
awk '/^#@ interface/ { t = $1 " " $2 " " $3 " " $4; for (k = NF - 2; k > 4; k -= 3) t = t " " $k " " $(k + 1) " " $(k + 2); $0 = t }
    { print }' given.obj > turned.obj

part "assembly of 2.x: as the scene file"       same_answer assembly
part "assembly of 1.x"                          same_answer value
part "network of 0.x"                           same_answer network
# compas 0.18 wrote a Frame, whose members had been merged into the network: a wrapper whose tables stand beside its data.
sed '1s/^{/{"dtype": "compas.geometry\/Frame", "data": {"point": [0, 0, 0]}, "vertex": {"0": {"x": 0}}, "face": {}, /' network.json > merged.json
merged() {
    "$cli" check --json --mu 0.84 merged.json | numbers > got
    "$cli" check --json --mu 0.84 network.json | numbers > want
    grep -q '"blocks": *9' got && cmp want got
}
part "network merged into a wrapper, 0.18"      merged
part "model of compas_dem, elements by guid"    same_answer model
part "model with a list of elements"            same_answer elements
json bare < given.obj > bare.json
json list < given.obj > list.json
part "bare: supports told by their nodes"       says STABLE --support 0 --support 8 bare.json
part "bare: that supports are missing is told"  says '--fixed NAME' bare.json
# The interfaces of the first edge are gone.
without_first() { awk '{ if (!done && match($0, /"interfaces": \[/)) { $0 = substr($0, 1, RSTART - 1) "\"was\": [" substr($0, RSTART + RLENGTH); done = 1 } print }'; }
without_first < assembly.json > first-bare.json
part "an edge without polygon: told"         says '1 edge of the model has no contact polygon: all contacts were found anew' first-bare.json
part "list of meshes, joints found"             says '9 blocks, 7 free; 8 joints found' --fixed b0,b8 list.json
part "from a pipe"                              sh -c "'$cli' check --quiet --fixed 0,8 - < bare.json | grep -q '^-: STABLE'"
json assembly < turned.obj > turned.json
turned() {
    "$cli" check --json assembly.json | numbers > want
    "$cli" check --json turned.json | numbers > got
    grep -q '"verdict": *"stable"' got && cmp want got
}
part "polygons the wrong way round are turned"  turned
part "convert writes the scene file"            sh -c "'$cli' convert assembly.json > out.obj && '$cli' check --quiet out.obj | grep -q STABLE"

# A problem of compas_dem around the model: problem MU GRAVITY LOADS HELD
problem() {
    printf '{"dtype": "compas_dem.problem/Problem", "data": {"model": %s, "contact_properties": {"dtype": "ContactProperties", "data": {
        "contact_model": {"dtype": "MohrCoulomb", "data": {%s}}, "joint_model": null}}, "boundary_conditions": {"dtype": "B", "data": {
        "gravity": %s, "g": 5.0, "body_forces": [], "point_loads": [%s], "surface_loads": [], "displacements": [%s]}}}}' \
        "$(cat model.json)" "$1" "$2" "$3" "$4" > problem.json
}
in_scene() { "$cli" convert problem.json | grep -c -e "$1" | grep -qx "$2"; }         # in_scene LINE TIMES
friction() {
    problem '"phi": 26.565051177077994, "c": null, "t_c": null, "mu": 0.25' false '' '' && in_scene '^#@ mu 0.25$' 1 &&
    problem '"phi": 45.0, "c": null, "t_c": null' false '' '' && in_scene '^#@ mu 0.9999999999999' 1 && in_scene '^#@ gravity 0 0 -9.80665' 1 &&
    "$cli" convert --mu 0.6 problem.json | grep -q '^#@ mu 0.6'
}
problem_same() {                                        # friction of a problem: as told by an option
    problem '"mu": 0.31' false '' ''
    "$cli" check --json --mu 0.31 model.json | numbers > want
    "$cli" check --json problem.json | numbers > got
    cmp want got
}
loads() {
    problem '"mu": 0.5' true '{"block_index": 4, "force": [0, 0, -5000], "moment": null, "point": [0, 0.25, 1], "loading_type": "ramp"},
        {"block_index": 3, "force": [1, 2, 3], "moment": [4, 5, 6], "point": null}, {"block_index": 5, "force": [1, 0, 0]}' ''
    in_scene '^#@ gravity 0 0 -5$' 1 && in_scene '^#@ load b4 0 0 -5000 0 0.25 1$' 1 && in_scene '^#@ load b3 0 0 0 4 5 6 couple$' 1 &&
    in_scene '^#@ load b3 1 2 3 ' 1 && in_scene '^#@ load b5 1 0 0 ' 1 && in_scene '^#@ load ' 4
}
held() {                                                # supports are what does not move
    sed 's/"is_support": true/"is_support": false/g' model.json > free.json
    mv free.json model.json
    problem '"mu": 0.84' false '' '{"block_index": 0, "translation": [0.0, 0, 0], "rotation": [0, 0, 0]},
        {"block_index": 8, "translation": [0, null, 0.0], "rotation": null}'
    json model < given.obj > model.json
    in_scene '^#@ fixed$' 1 && in_scene '^#@ fixed x z$' 1
}
unread() {
    problem '"mu": 0.84, "c": 3.0' false '' '{"block_index": 0, "translation": [0.1, 0, 0], "rotation": null}'
    says 'displacements of the problem were not read' problem.json && says "cohesion and tension .* were not read" problem.json
}
boxes() {                                               # courses of boxes, one in a turned frame
    b() { printf '{"dtype": "compas.geometry/Box", "data": {"frame": {"point": [%s], "xaxis": [%s], "yaxis": [%s]}, "xsize": %s, "ysize": %s, "zsize": %s}}' "$@"; }
    printf '{"params": {"N": 2}, "curve": {"points": [[0, 0, 0], [1, 0, 0]]}, "courses": [[%s, %s], [%s]]}' \
        "$(b 0,0,0 1,0,0 0,1,0 1 2 1)" "$(b 2,0,0 0,1,0 -1,0,0 2 1 1)" "$(b 1,0,1 1,0,0 0,1,0 3 2 1)" > courses.json
    says '3 blocks, 1 free; 2 joints found' --fixed b0,b1 courses.json && says STABLE --fixed b0,b1 courses.json
}
part "a problem: its friction"                  friction
part "a problem: as its model with that friction" problem_same
part "a problem: gravity and point loads"       loads
part "a problem: supports of its displacements" held
part "a problem: what is not read is told"      unread
part "boxes in courses"                         boxes
problem '"mu": -1' false '' ''
part "bad: friction below 0"                    refused 'friction of the contact model is below 0' < problem.json
problem '"mu": 1' false '{"block_index": 99, "force": [0, 0, 1]}' ''
part "bad: a load on no block"                  refused 'on a block that is not there' < problem.json
problem '"mu": 1' false '{"block_index": 1, "force": [0, 0]}' ''
part "bad: a load of two numbers"               refused 'not three numbers' < problem.json
printf '[{"frame": {"point": [0, 0, 0], "xaxis": [1, 0, 0]}, "xsize": 1, "ysize": 1, "zsize": 1}]' > box.json
part "bad: a box without axes"                  refused 'its box has no frame' < box.json
axes() { printf '[{"frame": {"point": [0, 0, 0], "xaxis": [%s], "yaxis": [%s]}, "xsize": 1, "ysize": 2, "zsize": 3}]' "$1" "$2" > box.json; }
oblique() {                                             # axes of any length, not quite across each other: those of the same frame
    axes 1,0,0 0,1,0 && "$cli" convert --quiet box.json > want && axes 2,0,0 3,0.5,0 && "$cli" convert --quiet box.json > got && cmp want got
}
part "a box whose axes are no unit vectors"     oblique
axes 2,0,0 -3,0,0
part "bad: a box with parallel axes"            refused 'two axes that are not parallel' < box.json
axes 1,0,0 0,0,0
part "bad: a box with an axis of no length"     refused 'two axes that are not parallel' < box.json
printf '3D Geometry File Format        7\001\000' > m.3dm
part "a model of Rhino: what to export"         sh -c "'$cli' check m.3dm 2>&1 | grep -q '^m.3dm:1: byte 0x01: a model of Rhino: export OBJ'"

# ------------------------------------------------------------------------------------------------------------------- bad
for cut in 1 20 200 2000 9000; do part "cut after $cut bytes" sh -c "head -c $cut assembly.json > cut.json; ! '$cli' check cut.json > out 2> err; \
    [ \$('$cli' check cut.json 2>&1 > /dev/null | wc -l) -eq 1 ] && ! [ -s out ] && '$cli' check cut.json 2> err; [ \$? -eq 65 ]"; done
bad() {                                                 # bad NAME TEXT SED: the bare assembly, edited
    part "bad: $1" edited "$2" "$3" bare.json
}
bad "a vertex that is text"       'x of a vertex is not a number'     's/"x": [^,]*,/"x": "one",/'
bad "not a number"                'a value was expected'              's/"x": [^,]*,/"x": NaN,/'
bad "infinite"                    'a value was expected'              's/"x": [^,]*,/"x": Infinity,/'
bad "out of range"                'out of range'                      's/"x": [^,]*,/"x": 1e999,/'
bad "no vertices"                 'no mesh'                           's/"vertex"/"corner"/'
bad "no faces"                    'no mesh'                           's/"face"/"side"/'
bad "faces in a list of numbers"  'no mesh'                           's/"face": {[^}]*}/"face": 6/'
bad "a face of two corners"       'a face has 2 corners'              's/"face": {"0": \[0, 1, 2, 3\]/"face": {"0": [0, 1]/'
bad "a vertex that is not there"  "the vertex '99', which is not"     's/"0": \[0, 1, 2, 3\]/"0": [0, 1, 2, 99]/'
bad "a vertex of no whole number" "the vertex '1.5', which"           's/"0": \[0, 1, 2, 3\]/"0": [0, 1.5, 2, 3]/'
bad "a face that is an object"    'a face has 0 corners'              's/"0": \[0, 1, 2, 3\]/"0": {}/'
bad "an open mesh"                'open'                              's/"0": \[0, 1, 2, 3\], //'
bad "nodes without blocks"        "has no block"                      's/"block"/"stone"/g'
bad "a block that is null"        "has no block"                      's/"block": {/"block": null, "old": {/'
bad "no nodes"                    'no node table'                     's/"node"/"point"/'
bad "a node table of numbers"     'no node table'                     's/"node": {/"node": 3, "old": {/'
bad "an edge to nowhere"          'an edge of no two nodes'           's/"edge": {}/"edge": {"0": {"77": {}}}/'
bad "an edge of one node"         'an edge of no two nodes'           's/"edge": {}/"edge": {"(0, )": {}}/'
bad "two nodes of one name"       'b0'                                "s/\"1\": {\"block\"/\"'0'\": {\"block\"/"
bad "a point of two numbers"      'not three numbers' 's/"edge": {}/"edge": {"0": {"1": {"interfaces": [{"points": [[0, 0], [1, 0, 0], [1, 1, 0]]}]}}}/'
bad "a polygon of two points"     'at least three'    's/"edge": {}/"edge": {"0": {"1": {"interfaces": [{"points": [[0, 0, 0], [1, 0, 0]]}]}}}/'
bad "twice a value"               'more than one'                     's/$/ {}/'
bad "a comment"                   "key in quotes"                     's/{/{ \/\/ here/'
bad "a comma too many"            'a key in quotes'                   's/"node": {/"node": {, /'
for text in '{' '[' '{}' '[]' '[[]]' '[1, 2]' '{"node": {}}' '{"node": {"0": 1}}' '{"node": []}' '{"data": {"data": {"data": 1}}}' \
    '{"dtype": "x", "data": null}' '{"vertex": {}, "face": {}}' '{"blocks": {}}' '{"elements": [null]}' '{"graph": {"node": {"0": {"element": "x"}}}}'
do part "bad: $text" sh -c "printf '%s' '$text' > t.json; '$cli' check t.json > out 2> err; [ \$? -eq 65 ] && [ ! -s out ] && [ \$(wc -l < err) -eq 1 ] || { cat err; false; }"; done
part "bad: a hundred brackets" sh -c "awk 'BEGIN { while (n++ < 100) printf \"[\" }' > t.json; '$cli' check t.json 2>&1 | grep -q 'nested too deep'"
sed 's/"transformation": null/"transformation": {"matrix": [[1, 0], [0, 1]]}/' model.json > t.json
part "bad: a transformation of 2 x 2"            sh -c "'$cli' check t.json 2>&1 | grep -q 'no matrix of 4 x 4'"
sed 's/"transformation": null/"transformation": {"matrix": [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]}/' model.json |
    sed 's/"contacts"/"old"/g' > t.json
part "elements moved by their transformation"    says STABLE t.json
warped() {                                              # two cubes share a warped face, which their meshes begin at any corner
    low='"vertex": {"0": {}, "1": {"x": 1}, "2": {"x": 1, "y": 1}, "3": {"y": 1}, "4": {"z": 1}, "5": {"x": 1, "z": 1},
        "6": {"x": 1, "y": 1, "z": 1.3}, "7": {"y": 1, "z": 1}}'
    high='"vertex": {"4": {"z": 1}, "5": {"x": 1, "z": 1}, "6": {"x": 1, "y": 1, "z": 1.3}, "7": {"y": 1, "z": 1}, "8": {"z": 2},
        "9": {"x": 1, "z": 2}, "10": {"x": 1, "y": 1, "z": 2}, "11": {"y": 1, "z": 2}}'
    for face in '5, 4, 7, 6' '4, 7, 6, 5' '7, 6, 5, 4' '6, 5, 4, 7'; do
        printf '[{%s, "face": {%s, "5": [4, 5, 6, 7]}}, {%s, "face": {%s, "5": [%s]}}]\n' \
            "$low" '"0": [3, 2, 1, 0], "1": [0, 1, 5, 4], "2": [1, 2, 6, 5], "3": [2, 3, 7, 6], "4": [3, 0, 4, 7]' \
            "$high" '"0": [8, 9, 10, 11], "1": [4, 5, 9, 8], "2": [5, 6, 10, 9], "3": [6, 7, 11, 10], "4": [7, 4, 8, 11]' "$face" > t.json
        "$cli" check --support b0 t.json > out
        grep -q '^t.json: STABLE$' out && grep -q 'remark  *2 warped faces of 2 blocks' out || { echo "$face:"; cat out; return 1; }
    done
}
part "a warped face two meshes share, cut alike" warped

total
