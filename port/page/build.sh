#!/bin/sh
# build: the page, one HTML file.
#
#     build.sh --lacks          what is not here that it needs, nothing if all is
#     build.sh --modules        three.js and esbuild from npm into build/page/node_modules, as package.json names them
#     build.sh --core OBJECTS...        links build/page/core.wasm, which may import nothing
#     build.sh                  build/page/stonepack.html of it
set -eu
here=$(dirname "$0")
out=build/page
cc=${WASM_CC:-clang}

lacks() {
    command -v "$cc" > /dev/null && command -v wasm-ld > /dev/null || echo "clang lld"
    [ -f /usr/include/wasm32-wasi/stdio.h ] || echo wasi-libc
    [ -f "$("$cc" --target=wasm32-wasi -print-libgcc-file-name 2> /dev/null)" ] || echo libclang-rt-14-dev-wasm32
    command -v node > /dev/null || echo nodejs
    [ -d $out/node_modules/three ] && [ -d $out/node_modules/esbuild ] ||
        echo "three and esbuild of npm: sh port/page/build.sh --modules"
}

case ${1:-} in
--lacks) lacks; exit ;;
--modules)
    mkdir -p $out
    cp "$here/package.json" $out/
    npm install --prefix $out --no-audit --no-fund --no-package-lock --ignore-scripts --silent
    exit ;;
--core)
    shift
    "$cc" --target=wasm32-wasi -mexec-model=reactor -O2 -Wl,--strip-all -Wl,-z,stack-size=1048576 "$@" -o $out/core.wasm
    exit ;;
esac
node "$here/bundle.mjs" $out $out/core.wasm $out/stonepack.html
