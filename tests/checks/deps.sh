#!/bin/sh
# deps: Debian packages that `make check` can use.
set -eu
export DEBIAN_FRONTEND=noninteractive
sudo=''
if [ "$(id -u)" -ne 0 ]; then sudo=sudo; fi
$sudo apt-get update -qq
$sudo apt-get install -y -qq --no-install-recommends \
    gcc make libc6-dev g++ clang llvm libclang-rt-14-dev valgrind cppcheck python3 gcc-arm-none-eabi libnewlib-arm-none-eabi \
    librsvg2-bin binutils python3-matplotlib python3-numpy python3-scipy pkg-config libbullet-dev coinor-libipopt-dev
