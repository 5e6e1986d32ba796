#!/bin/sh
# package: one folder that is a CMake project, a Meson subproject, an Arduino and a PlatformIO library, an ESP-IDF component and a
# Zephyr module at once, made of the pair.
#
#     package.sh [FOLDER]                       default build/package/stonepack
#     package.sh --fill FILE PREFIX             the file with version, prefix and address put in
#     package.sh --homepage                     the project's address: of HOMEPAGE, else of the file homepage beside this; or nothing
set -eu
here=$(dirname "$0")
version=$(awk '$2 ~ /^SP_VERSION_(MAJOR|MINOR|PATCH)$/ { v = v (v == "" ? "" : ".") $3 } END { print v }' stonepack.h)
homepage=${HOMEPAGE:-$(sed -n '/^[^#]/p' "$here/homepage")}
if [ "$homepage" ] && ! echo "$homepage" | grep -qxE 'https?://[A-Za-z0-9._~/:@%?=#+-]+'; then
    echo "package: no address of a page: $homepage" >&2
    exit 1
fi
# Switches of the header's table, and what each leaves out: NAME TEXT, without SP_.
switches() {
    awk '/^\/\* Switches: what is lost/ { on = 1 } /Calls left out/ { on = 0 }
         on && $2 ~ /^SP_/ { name = substr($2, 4); $1 = $2 = ""; sub(/ +[0-9]+ +[0-9]+$/, ""); sub(/^ +/, ""); print name, $0 }' stonepack.h
    echo "REAL_MIXED factors in float, refined in double"
}
names=$(switches | awk '{ printf "%s%s", n++ ? " " : "", $1 }')
lower=$(echo "$names" | tr '[:upper:] ' '[:lower:]\n' | sed "s/.*/'&'/" | paste -sd, | sed 's/,/, /g')
# @HOMEPAGE@ goes with its line where there is none; @URL@ is a stand-in then, and what @NO_HOMEPAGE@ begins says so.
fill() { sed -e "s|@VERSION@|$version|g" -e "s|@PREFIX@|$2|g" -e "${homepage:+s|@HOMEPAGE@|$homepage|g}" -e '/@HOMEPAGE@/d' \
    -e "s|@URL@|${homepage:-https://example.org/}|g" -e "${homepage:+/@NO_HOMEPAGE@/d}" -e 's|@NO_HOMEPAGE@||' \
    -e "s|@SWITCHES@|$names|g" -e "s|@switches@|$lower|g" "$1"; }
# Each switch as an option of Meson, of Kconfig.
meson_options() {
    switches | while read -r name text; do
        echo "option('$(echo "$name" | tr '[:upper:]' '[:lower:]')', type : 'boolean', value : false, description : 'SP_$name; lost: $text')"
    done | sed 's/SP_REAL_MIXED; lost:/SP_REAL_MIXED:/'
}
kconfig() {                                             # kconfig [what it depends on]
    switches | while read -r name text; do
        printf '\nconfig STONEPACK_%s\n\tbool "SP_%s; lost: %s"\n' "$name" "$name" "$text"
        [ $# -eq 0 ] || printf '\tdepends on %s\n' "$1"
    done | sed 's/SP_REAL_MIXED; lost:/SP_REAL_MIXED:/'
}
if [ "${1:-}" = --homepage ]; then
    echo "$homepage"
    exit
fi
if [ "${1:-}" = --fill ]; then
    fill "$2" "$3"
    exit
fi
out=${1:-build/package/stonepack}
mkdir -p "$out/src" "$out/zephyr" "$out/examples/verdict"
sh port/pair/pair.sh stonepack.c "$out/src"
cp LICENSE "$out/"
for file in CMakeLists.txt meson.build meson_options.txt stonepack.wrap library.properties library.json idf_component.yml \
    zephyr/module.yml zephyr/CMakeLists.txt zephyr/Kconfig README.md examples/verdict/verdict.ino; do
    fill "$here/$file" '' > "$out/$file"
done
meson_options >> "$out/meson_options.txt"
kconfig STONEPACK >> "$out/zephyr/Kconfig"
{
    printf 'menu "stonepack"\n\nconfig STONEPACK_FLOAT\n\tbool "float instead of double"\n'
    kconfig
    printf '\nendmenu\n'
} > "$out/Kconfig"
