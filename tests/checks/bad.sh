#!/bin/sh
# bad: malformed scene files, each to be refused with one clear line.      bad.sh [build/stonepack]
#
# A bad file gives exit status 65, one line `file:line: message` on standard error and nothing on standard output; a good odd
# one gives a verdict and no message. Files are made in a temporary folder. The last line is `N passed, N failed`.
cli=${1:-build/stonepack}
case $cli in /*) ;; *) cli=$PWD/$cli ;; esac
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
cd "$tmp" || exit 1
passed=0
failed=0

fails() {                                               # fails NAME WHAT
    failed=$((failed + 1))
    echo "FAILED $1: $2"
    head -c 300 err
}

# refused NAME [TEXT]: NAME.obj must be refused, with TEXT in the message.
refused() {
    "$cli" check --json "$1.obj" > out 2> err
    status=$?
    if [ $status -ne 65 ]; then fails "$1" "exit status $status, want 65"
    elif [ -s out ]; then fails "$1" "something on standard output"
    elif [ "$(wc -l < err)" -ne 1 ]; then fails "$1" "$(wc -l < err) lines of message, want 1"
    elif ! grep -q "^$1.obj:[1-9][0-9]*: ." err; then fails "$1" "the message has no file:line:"
    elif ! grep -q -e "${2:-.}" err; then fails "$1" "no '$2' in the message"
    else passed=$((passed + 1)); fi
}

# accepted NAME [STATUS]: NAME.obj must be read.
accepted() {
    "$cli" check --json "$1.obj" > out 2> err
    status=$?
    if [ $status -ne "${2:-0}" ]; then fails "$1" "exit status $status, want ${2:-0}"
    elif [ -s err ]; then fails "$1" "a message"
    elif [ "$(wc -l < out)" -ne 1 ]; then fails "$1" "no result on standard output"
    else passed=$((passed + 1)); fi
}

# cube NAME Z [FIRST]: a block of side 1 standing at height Z; FIRST: number of its first vertex.
cube() {
    n=${3:-1}
    echo "o $1"
    for z in "$2" $(($2 + 1)); do printf 'v 0 0 %d\nv 1 0 %d\nv 1 1 %d\nv 0 1 %d\n' "$z" "$z" "$z" "$z"; done
    printf 'f %d %d %d %d\n' $((n+3)) $((n+2)) $((n+1)) "$n"  $((n+4)) $((n+5)) $((n+6)) $((n+7))  "$n" $((n+1)) $((n+5)) $((n+4)) \
        $((n+1)) $((n+2)) $((n+6)) $((n+5))  $((n+2)) $((n+3)) $((n+7)) $((n+6))  $((n+3)) "$n" $((n+4)) $((n+7))
}
ground() { cube ground -1 "${1:-1}"; echo '#@ fixed'; }
scene() { ground; cube stone 0 9; }                     # two blocks, contacts to be found
joint() { echo '#@ interface ground stone 0 0 0 1 0 0 1 1 0 0 1 0'; }

# bad NAME TEXT LINES...: the scene with a joint, then the lines.
bad() {
    name=$1 text=$2
    shift 2
    { scene; joint; printf '%s\n' "$@"; } > "$name.obj"
    refused "$name" "$text"
}
# only NAME TEXT LINES...: the lines alone.
only() {
    name=$1 text=$2
    shift 2
    printf '%s\n' "$@" > "$name.obj"
    refused "$name" "$text"
}
# edited NAME TEXT SED: the scene with a joint, edited.
edited() {
    { scene; joint; } | sed "$3" > "$1.obj"
    refused "$1" "$2"
}

# ------------------------------------------------------------------------------------------------------ nothing, or no text
: > empty.obj;                                          refused empty 'no block'
only comments 'no block'                '# a' '# b'
only blank 'no block'                   '' '' ''
only settings_only 'no block'           '#@ mu 0.5' '#@ gravity 0 0 -1'
only vertices_only 'no block'           'v 0 0 0' 'v 1 0 0' 'v 0 1 0'
printf 'o a\000b\n' > nul.obj;                          refused nul 'no text'
printf '\177ELF\002\001\001\000\000' > elf.obj;         refused elf 'no text'
printf '\037\213\010\000\000\000' > gzip.obj;           refused gzip 'unpack it'
printf 'o a\nv 0 0 0\nv 1 \007 0\n' > bell.obj;         refused bell 'no text'
head -c 20000 /dev/urandom > random.obj;                refused random
printf '\211PNG\r\n\032\n\000' > png.obj;               refused png
only json 'without an assembly'         '{"dtype": "compas_assembly.datastructures/Assembly"}'
only stl 'unknown line'                 'solid cube' 'facet normal 0 0 1'
only html 'unknown line'                '<!DOCTYPE html>' '<html>'

# ------------------------------------------------------------------------------------------------------------------ numbers
edited nan 'not a number' 's/^v 0 0 0$/v 0 nan 0/'
edited nan_upper 'not a number' 's/^v 0 0 0$/v 0 0 NaN/'
edited inf 'not a number' 's/^v 0 0 0$/v inf 0 0/'
edited minus_inf 'not a number' 's/^v 0 0 0$/v -Infinity 0 0/'
edited overflow 'out of range' 's/^v 0 0 0$/v 0 0 1e999/'
edited huge_square '' 's/^v 0 0 0$/v 0 0 -1e300/'
edited hex 'not a number' 's/^v 0 0 0$/v 0x0 0 0/'
edited trailing_junk 'not a number' 's/^v 0 0 0$/v 0 0 0m/'
edited comma 'not a number' 's/^v 0 0 0$/v 0,0 0 0/'
edited two_points 'not a number' 's/^v 0 0 0$/v 0 0 0.0.0/'
edited bare_exponent 'not a number' 's/^v 0 0 0$/v 0 0 1e/'
edited bare_sign 'not a number' 's/^v 0 0 0$/v 0 - 0/'
edited bare_point 'not a number' 's/^v 0 0 0$/v 0 . 0/'
edited fortran 'not a number' 's/^v 0 0 0$/v 0 0 1.0d0/'
edited two_numbers 'three numbers' 's/^v 0 0 0$/v 0 0/'
edited no_numbers 'three numbers' 's/^v 0 0 0$/v/'
edited weight_junk 'not a number' 's/^v 0 0 0$/v 0 0 0 red/'
{ scene; printf 'v 0 0 '; head -c 100000 /dev/zero | tr '\0' 1; echo; } > long_number.obj;  refused long_number

# -------------------------------------------------------------------------------------------------------------------- faces
edited zero_index 'from 1' 's/^f 1 2 6 5$/f 0 2 6 5/'
edited minus_zero 'from 1' 's/^f 1 2 6 5$/f -0 2 6 5/'
edited index_too_large 'no such vertex' 's/^f 1 2 6 5$/f 1 2 6 500/'
edited index_huge 'no such vertex' 's/^f 1 2 6 5$/f 1 2 6 99999999999999999999/'
edited index_2_31 'no such vertex' 's/^f 1 2 6 5$/f 1 2 6 2147483648/'
edited index_int_max 'no such vertex' 's/^f 1 2 6 5$/f 1 2 6 2147483647/'
edited index_too_low 'no such vertex' 's/^f 1 2 6 5$/f 1 2 6 -50/'
edited index_int_min 'no such vertex' 's/^f 1 2 6 5$/f 1 2 6 -2147483648/'
edited index_real 'bad face corner' 's/^f 1 2 6 5$/f 1 2 6 5.0/'
edited index_word 'bad face corner' 's/^f 1 2 6 5$/f one two three/'
edited slash_word 'bad face corner' 's/^f 1 2 6 5$/f 1\/a 2 6 5/'
edited slash_end 'bad face corner' 's/^f 1 2 6 5$/f 1\/ 2 6 5/'
edited slash_four 'bad face corner' 's/^f 1 2 6 5$/f 1\/1\/1\/1 2 6 5/'
edited slash_first 'bad face corner' 's/^f 1 2 6 5$/f \/1 2 6 5/'
edited two_corners 'three corners' 's/^f 1 2 6 5$/f 1 2/'
edited one_corner 'three corners' 's/^f 1 2 6 5$/f 1/'
edited no_corner 'three corners' 's/^f 1 2 6 5$/f/'
only face_before_block 'before the first block' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'f 1 2 3' 'o a'

# ------------------------------------------------------------------------------------------------------------------- blocks
edited open_mesh "'stone'.*open" '/^f 13 14 15 16$/d'
edited inward_face "'stone'" 's/^f 13 14 15 16$/f 16 15 14 13/'
scene | sed '/^o stone/,$s/^f \([0-9]*\) \([0-9]*\) \([0-9]*\) \([0-9]*\)$/f \4 \3 \2 \1/' > inside_out.obj
refused inside_out "'stone'.*inward"
{ scene; joint; echo '#@ pressure stone 2 10'; } | sed 's/^v 1 1 1$/v 1 1 1.5/' > warped_face.obj
refused warped_face "'stone'.*plane"                                                     # else it is cut into triangles
{ scene; echo 'o flat'; printf 'v %s\n' '5 0 0' '6 0 0' '6 1 0'; echo 'f 17 18 19'; echo 'f 19 18 17'; } > flat_block.obj
refused flat_block "'flat'.*no volume"
{ scene; echo 'o dot'; printf 'v %s\n' '5 5 5' '5 5 5' '5 5 5'; echo 'f 17 18 19'; } > point_block.obj
refused point_block "'dot'"
{ scene; scene | tail -6; echo '#@ pressure stone 2 10'; } > twice_pressed.obj;         refused twice_pressed "'stone': faces are there twice in this file"
{ scene; printf 'v %s\n' '0 0 .2' '1 0 .2' '1 1 .2' '0 1 .2'; printf 'f %s\n' '12 11 10 9' '17 18 19 20' '9 10 18 17' '10 11 19 18' \
    '11 12 20 19' '12 9 17 20'; } > twice_needed.obj;                                   refused twice_needed "'stone': faces are there twice, and"
bad no_faces "'nothing' has no faces" 'o nothing' '#@ load nothing 0 0 1 0 0 0'
bad no_faces_half_fixed "'nothing' has no faces" 'o nothing' '#@ fixed x'
bad no_faces_of_vertices "'nothing' has no faces" 'o nothing' 'v 0 0 0'
{ ground; echo 'o stone'; } > cut_after_name.obj;                                       refused cut_after_name "'stone' has no faces"
only no_faces_at_all "'nothing' has no faces" 'o nothing' 'v 0 0 0'
bad no_name 'without a name' 'o'
bad name_with_space "'two_words' has no faces" 'o two words' '#@ fixed x'
bad name_twice_by_space "'two_words' has the name" 'o two words' 'o two_words'
only group_without_faces 'no block' 'g a' 'v 0 0 0'
only group_again "'a' has the name" 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'g a' 'f 1 2 3' 'g b' 'f 1 2 3' 'g a' 'f 3 2 1'
bad duplicate_name 'name' 'o stone' '#@ fixed'
{ scene; head -c 3000 /dev/zero | tr '\0' 'x' | sed 's/^/o /'; echo; echo '#@ fixed x'; } > long_name.obj
refused long_name 'has no faces'
bad unknown_statement 'unknown line' 'vertex 1 2 3'
bad free_form_surface 'free-form surface: export meshes' 'surf 0 1 0 1 1 2 3 4'
bad lonely_word 'unknown line' 'stone'

# --------------------------------------------------------------------------------------------------------------- `#@` words
bad unknown_word "unknown word 'colour'" '#@ colour red'
bad missing_word 'missing' '#@'
bad glued_word "unknown word 'fixe'" '#@fixe'
bad mu_missing 'needs a number' '#@ mu'
bad mu_negative 'negative' '#@ mu -0.1'
bad mu_nan 'not a number' '#@ mu nan'
bad mu_extra 'unexpected' '#@ mu 0.5 0.6'
bad gravity_two 'three numbers' '#@ gravity 0 -9.81'
bad gravity_four 'unexpected' '#@ gravity 0 0 0 -9.81'
bad gravity_inf 'not a number' '#@ gravity 0 0 -inf'
bad density_zero 'positive' '#@ density 0'
bad density_negative 'positive' '#@ density -2400'
bad density_missing 'needs a number' '#@ density'
bad density_overflow 'out of range' '#@ density 1e400'
only fixed_too_early 'before the first block' '#@ fixed' 'o a'
bad fixed_unknown 'knows x y z' '#@ fixed 3'
bad load_nobody 'does not exist' '#@ load nobody 0 0 -100 0 0 1'
bad load_short 'three numbers' '#@ load stone 0 0'
bad live_pointless 'point' '#@ live stone 10 0 0 0 0'
bad load_nan 'not a number' '#@ load stone 0 0 nan 0 0 0'
bad load_word 'unexpected' '#@ load stone 0 0 1 0 0 0 couples'
bad load_blank "written _, or it stands in quotes; not a number: 'one'" '#@ load stone one 0 0 -100 0 0 1'
bad load_open_quotes 'does not exist' '#@ load "stone 0 0 -100 0 0 1'
bad mass_nobody 'does not exist' '#@ mass nobody 1 0 0 1'
bad pressure_face 'no face 99' '#@ pressure stone 99 1'

# ----------------------------------------------------------------------------------------------------------------- contacts
bad interface_bare 'two blocks' '#@ interface'
bad interface_one_name 'two blocks' '#@ interface stone'
bad interface_unknown "'nobody', which does not exist" '#@ interface stone nobody 0 0 1 1 0 1 1 1 1'
bad interface_no_points 'three points' '#@ interface ground stone'
bad interface_two_points 'three points' '#@ interface ground stone 0 0 0 1 0 0'
bad interface_odd 'threes' '#@ interface ground stone 0 0 0 1 0 0 1 1 0 0 1'
bad interface_word 'not a number' '#@ interface ground stone 0 0 0 1 0 0 1 1 zero'
bad interface_inf 'out of range' '#@ interface ground stone 0 0 0 1 0 0 1 1 1e999'
bad interface_self 'itself' '#@ interface stone stone 0 0 1 1 0 1 1 1 1'
bad interface_no_area 'area' '#@ interface ground stone 0 0 0 1 0 0 2 0 0'
bad interface_one_place 'area' '#@ interface ground stone 1 1 0 1 1 0 1 1 0'
bad interface_warped 'plane' '#@ interface ground stone 0 0 0 1 0 0 1 1 0.01 0 1 0'
bad interface_comma "'ground,stone', which does not exist" '#@ interface ground,stone 0 0 0 1 0 0 1 1 0 0'
bad points_bare 'two blocks' '#@ points'
bad points_no_normal 'normal' '#@ points ground stone 0 0'
bad points_no_point 'one point' '#@ points ground stone 0 0 1'
bad points_zero_normal 'length' '#@ points ground stone 0 0 0 0 0 0'
bad points_odd 'threes' '#@ points ground stone 0 0 1 0 0'
bad points_self 'itself' '#@ points stone stone 0 0 1 0 0 0'

# -------------------------------------------------------------------------------- line ends, cut files, sizes out of nothing
{ scene; joint; echo 'v 1 2'; } | sed 's/$/\r/' > crlf_broken.obj;                     refused crlf_broken '^crlf_broken.obj:33:'
{ scene; joint; printf 'v 1 2'; } > no_newline_broken.obj;                              refused no_newline_broken '^[^:]*:33:'
{ scene; joint; echo 'v 1 2'; } | tr '\n' '\r' > cr_broken.obj;                         refused cr_broken '^cr_broken.obj:33:'
for at in 40 150; do scene | head -c $at > "cut_$at.obj";                               refused "cut_$at"; done
scene | sed '$d' > cut_block.obj;                                                       refused cut_block "'stone'.*open"
printf '%s' "$(scene; joint)" | sed '$s/ 0$//' > cut_joint.obj;                         refused cut_joint 'threes.*ground.*stone'
{ echo 'o a'; printf 'f'; head -c 1000000 /dev/zero | sed 's/./ 1/g' | tr '\0' ' '; echo ' 1 1 1'; } > endless_face.obj
refused endless_face
head -c 100000000 /dev/zero > zeros.obj;                                                refused zeros 'no text'
rm -f zeros.obj
head -c 100000000 /dev/zero | tr '\0' '\n' > newlines.obj;                              refused newlines 'no block'
rm -f newlines.obj
head -c 100000000 /dev/zero | tr '\0' ' ' > spaces.obj;                                 refused spaces 'no block'
rm -f spaces.obj
head -c 100000000 /dev/zero | tr '\0' 'v' > one_word.obj;                               refused one_word 'unknown line'
rm -f one_word.obj

# ----------------------------------------------------------------------------------------------------------- odd, but legal
{ scene; joint; } > plain.obj;                                                          accepted plain
{ scene; joint; } | sed 's/$/\r/' > crlf.obj;                                           accepted crlf
{ scene; joint; } | tr '\n' '\r' > cr.obj;                                              accepted cr
{ scene; joint; } | tr ' ' '\t' | sed 's/^/\t /; s/^\t #@\t/#@\t\t/' > tabs.obj;        accepted tabs
printf '%s' "$(scene; joint)" > no_newline.obj;                                         accepted no_newline
{ printf '\357\273\277'; scene; joint; } > byte_order_mark.obj;                         accepted byte_order_mark
{ scene; joint; } | sed 's/^f 1 2 6 5$/f 1\/7\/9 2\/\/3 6\/4 5/; s/^v 0 0 0$/v 0 0 0 1.0 0.5 .5 +1E-3/' > slashes.obj
accepted slashes
{ scene | awk '/^o stone/ { on = 1 } on && /^f/ { for (k = 2; k <= 5; k++) $k -= 17 } { print }'; joint; } > negative.obj
accepted negative
{ joint; scene; } > joint_first.obj;                                                    accepted joint_first
{ scene; joint; } | sed 's/^f 1 2 6 5$/f 1 2 \\\n6 5 # a face on two lines/' > continued.obj;   accepted continued
{ echo '# by hand'; echo 'mtllib none.mtl'; scene; joint; echo '#@ mu 0.5'; printf '%s\n' 'vn 0 0 1' 'vt 0 0' 'g a b' 's off' 'usemtl x'
  echo '#@mu 0.6'; echo '#@ points ground stone 0 0 2 0.5 0.5 0'; } > ignored.obj;      accepted ignored
{ scene; joint; joint; } > repeated_joint.obj;                                          accepted repeated_joint
{ scene; joint; printf '%s\n' '#@ load "stone" 0 0 0 0 0 0'; } | sed 's/^o stone/o "stone"/; s/ground stone/ground "stone"/' > quotes.obj
accepted quotes
{ scene; joint; printf '%s\n' '#@ supports "low ground"' '#@ load "stone	one" 0 0 -1 .5 .5 1' '#@ mass stone_one 1 .5 .5 1'; } |
    sed 's/^o stone/o stone one/; s/^o ground/o low  ground/; s/ground stone/"low  ground" "stone one"/' > blanks.obj
sed 's/supports "low ground"/supports "low  ground"/' blanks.obj > more_blanks.obj;     accepted more_blanks
{ printf 'o Camera\no Curve\nv 8 8 8\nv 9 9 9\nl 1 2\np 1\n'; ground 3; cube stone 0 11; joint; echo 'o Last';
  printf '%s\n' 'cstype bspline' 'deg 3' 'curv 0 1 1 2' 'parm u 0 0 1 1' 'end'; } > curves.obj;   accepted curves
{ scene; echo '#@ interface ground stone 0 0 0 .5 0 0 1 0 0 1 1 0 0 1 0'; } > collinear.obj;   accepted collinear
{ ground | sed '/^f 1 2 6 5$/d'; cube stone 0 9; joint; } > open_support.obj;           accepted open_support
{ printf 'o ground\n#@ fixed\n'; cube stone 0 1; joint; } > support_by_name.obj;        accepted support_by_name
{ printf 'o gr\303\274n\n#@ fixed\no a"\\\377\n#@ fixed\n'; ground; cube stone 0 9; joint; } > names.obj;   accepted names
{ scene; joint; echo '#@ gravity 0 0 0'; } > weightless.obj;                            accepted weightless

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
