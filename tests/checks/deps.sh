#!/bin/sh
# deps: Debian packages that `make check` can use.
set -eu
export DEBIAN_FRONTEND=noninteractive
sudo=''
if [ "$(id -u)" -ne 0 ]; then sudo=sudo; fi
$sudo apt-get update -qq
$sudo apt-get install -y -qq --no-install-recommends \
    gcc make libc6-dev g++ clang llvm libclang-rt-14-dev clang-19 llvm-19 libclang-rt-19-dev zsh cppcheck clang-tidy python3 gcc-arm-none-eabi libnewlib-arm-none-eabi \
    librsvg2-bin binutils python3-matplotlib python3-numpy python3-scipy pkg-config libbullet-dev libassimp-dev \
    coinor-libipopt-dev cmake meson tcc qemu-system-arm qemu-system-misc qemu-user gcc-riscv64-unknown-elf \
    gcc-aarch64-linux-gnu gcc-arm-linux-gnueabihf libc6-dev-armhf-cross gcc-powerpc-linux-gnu \
    libc6-dev-powerpc-cross gcc-mips-linux-gnu libc6-dev-mips-cross gcc-s390x-linux-gnu libc6-dev-s390x-cross \
    gcc-i686-linux-gnu libc6-dev-i386-cross python3-venv python3-pytest python3-hypothesis mypy python3-rosidl python3-empy gcc-mingw-w64-x86-64-win32 wine64 \
    lld wasi-libc libclang-rt-14-dev-wasm32 chromium dpkg-dev debhelper lintian afl++
# Node and npm, where neither is there from elsewhere; then what the page takes from npm.
command -v npm > /dev/null || $sudo apt-get install -y -qq --no-install-recommends nodejs npm
sh port/page/build.sh --modules || echo "npm did not bring three and esbuild: no page"
