#!/bin/sh
# package: one folder that is a CMake project, a Meson subproject, an Arduino and a PlatformIO library, an ESP-IDF component and a
# Zephyr module at once, made of the pair.
#
#     package.sh [FOLDER]                       default build/package/stonepack
#     package.sh --fill FILE PREFIX             the file with version and prefix put in
set -eu
here=$(dirname "$0")
version=$(awk '$2 ~ /^SP_VERSION_(MAJOR|MINOR|PATCH)$/ { v = v (v == "" ? "" : ".") $3 } END { print v }' stonepack.h)
fill() { sed -e "s|@VERSION@|$version|g" -e "s|@PREFIX@|$2|g" "$1"; }
if [ "${1:-}" = --fill ]; then
    fill "$2" "$3"
    exit
fi
out=${1:-build/package/stonepack}
mkdir -p "$out/src" "$out/zephyr" "$out/examples/verdict"
sh port/pair/pair.sh stonepack.c "$out/src"
cp LICENSE "$out/"
for file in CMakeLists.txt meson.build meson_options.txt stonepack.wrap library.properties library.json idf_component.yml \
    zephyr/module.yml zephyr/CMakeLists.txt zephyr/Kconfig examples/verdict/verdict.ino; do
    fill "$here/$file" '' > "$out/$file"
done
