#!/bin/sh
# check: each way of packaging builds a program that works, as far as its tool is here. Ends with `N passed, N failed`.
. tests/checks/tally.sh
top=$(pwd)
to=$top/build/package
rm -rf "$to"
mkdir -p "$to/user"
cat > "$to/user/main.c" <<'E2'
#include <stonepack.h>
int main(void)
{
    static double memory[64];
    sp_arena arena;
    return sp_arena_init(&arena, memory, sizeof memory) == SP_OK && arena.capacity == sizeof memory ? 0 : 1;
}
E2
cat > "$to/user/CMakeLists.txt" <<'E2'
cmake_minimum_required(VERSION 3.13)
project(user C)
find_package(stonepack 0.2 REQUIRED)
add_executable(user main.c)
target_link_libraries(user stonepack::stonepack)
E2
cat > "$to/user/meson.build" <<'E2'
project('user', 'c')
executable('user', 'main.c', dependencies : dependency('stonepack'))
E2

installed() { make -s install DESTDIR="$to/dest" PREFIX=/opt/stonepack && "$to/dest/opt/stonepack/bin/stonepack" --version; }
# In parentheses, for what it exports would have Meson take the installed library for its subproject.
pkgconfig() (
    export PKG_CONFIG_LIBDIR="$to/dest/opt/stonepack/lib/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$to/dest"
    pkg-config --exists 'stonepack >= 0.2' &&
    # shellcheck disable=SC2046
    ${CC:-gcc} "$to/user/main.c" $(pkg-config --cflags --libs --static stonepack) -o "$to/by_pkgconfig" && "$to/by_pkgconfig"
)
cmake_user() {                                          # cmake_user PREFIX: find_package there, build, run
    cmake -S "$to/user" -B "$1.user" -DCMAKE_PREFIX_PATH="$1" && cmake --build "$1.user" && "$1.user/user"
}
cmake_package() {
    for cp_float in OFF ON; do
        cp_to=$to/cmake_$cp_float
        cmake -S "$to/stonepack" -B "$cp_to.build" -DCMAKE_INSTALL_PREFIX="$cp_to" -DSTONEPACK_FLOAT=$cp_float &&
        cmake --build "$cp_to.build" && cmake --install "$cp_to.build" && cmake_user "$cp_to" || return 1
    done
}
meson_package() {
    mkdir -p "$to/user/subprojects" &&
    cp -r "$to/stonepack" "$to/user/subprojects/" && cp "$to/stonepack/stonepack.wrap" "$to/user/subprojects/" &&
    meson setup "$to/meson" "$to/user" --wrap-mode=nodownload --force-fallback-for=stonepack &&
    meson compile -C "$to/meson" && ls "$to/meson/subprojects/stonepack/libstonepack.a" && "$to/meson/user"
}
# Switches reach the library and whoever uses it.
uses_without_qp() {                                     # uses_without_qp LIBRARY
    ! nm "$1" | grep -q ' T sp_qp_solve$' && nm "$1" | grep -q ' T sp_check$'
}
cmake_switches() {
    cmake -S "$to/stonepack" -B "$to/cmake_qp" -DSTONEPACK_NO_QP=ON -DSTONEPACK_SMALL=ON -DCMAKE_INSTALL_PREFIX="$to/cmake_qp/to" &&
    cmake --build "$to/cmake_qp" && cmake --install "$to/cmake_qp" && uses_without_qp "$to/cmake_qp/libstonepack.a" &&
    grep -q 'SP_NO_QP' "$to/cmake_qp/to/lib/cmake/stonepack/stonepackConfig.cmake"
}
meson_switches() {
    meson setup "$to/meson_qp" "$to/user" --wrap-mode=nodownload --force-fallback-for=stonepack \
        -Dstonepack:no_qp=true -Dstonepack:small=true &&
    meson compile -C "$to/meson_qp" && uses_without_qp "$to/meson_qp/subprojects/stonepack/libstonepack.a"
}
# Every switch of switches.sh is an option of each.
every_switch() {
    for es in $(sed -n "s/^features='\(.*\)'$/\1/p" tests/checks/switches.sh); do
        es_low=$(echo "${es#SP_}" | tr '[:upper:]' '[:lower:]')
        grep -q "option('$es_low'" "$to/stonepack/meson_options.txt" && grep -q "'$es_low'" "$to/stonepack/meson.build" &&
        grep -q "^config STONEPACK_${es#SP_}$" "$to/stonepack/Kconfig" && grep -q "^config STONEPACK_${es#SP_}$" "$to/stonepack/zephyr/Kconfig" &&
        [ "$(grep -cw "${es#SP_}" "$to/stonepack/CMakeLists.txt")" -eq 2 ] && grep -qw "${es#SP_}" "$to/stonepack/zephyr/CMakeLists.txt" ||
            { echo "$es is no option of some"; return 1; }
    done
}
# As the Arduino builder does it: every source below src/, the sketch as C++ with <Arduino.h> before it.
arduino() {
    cat > "$to/Arduino.h" <<'E2'
struct serial { void begin(long); void println(const char *); };
extern serial Serial;
void delay(unsigned long);
void setup();
void loop();
E2
    for ar_cpu in '-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16' '-mcpu=cortex-m3'; do
        # shellcheck disable=SC2086
        arm-none-eabi-gcc $ar_cpu -mthumb -Os -ffp-contract=off -I"$to/stonepack/src" -c "$to/stonepack/src/stonepack.c" -o "$to/arduino.o" &&
        arm-none-eabi-g++ $ar_cpu -mthumb -Os -Wall -Werror -fno-exceptions -fno-rtti -I"$to/stonepack/src" -I"$to" -include Arduino.h \
            -x c++ -c "$to/stonepack/examples/verdict/verdict.ino" -o "$to/sketch.o" || return 1
    done
}
# The rules of https://arduino.github.io/arduino-cli/latest/library-specification: required fields, each once; what is allowed in them.
arduino_rules() {
    ar=$to/stonepack/library.properties
    for ar_field in name version author maintainer sentence paragraph category url architectures; do
        [ "$(grep -c "^$ar_field=." "$ar")" -eq 1 ] || { echo "library.properties: not one $ar_field"; return 1; }
    done
    for ar_rule in 'name=[A-Za-z0-9][A-Za-z0-9 _.-]{0,62}' 'version=[0-9]+\.[0-9]+\.[0-9]+' 'maintainer=[^<]+ <[^@ ]+@[a-z0-9.-]+>' \
        'category=(Display|Communication|Signal Input/Output|Sensors|Device Control|Timing|Data Storage|Data Processing|Other)' \
        'url=https?://[a-z0-9.-]+\.[a-z]+(:[0-9]+)?(/[^ ]*)?' 'architectures=(\*|[a-z0-9_,]+)' 'includes=stonepack\.h'; do
        grep -qxE "$ar_rule" "$ar" || { echo "library.properties: against $ar_rule"; return 1; }
    done
    [ -z "$(grep -vE '^(#|[a-z_]+=)' "$ar")" ] && ls "$to/stonepack/src/stonepack.h" "$to/stonepack/examples/verdict/verdict.ino" &&
    { [ "$(sh port/package/package.sh --homepage)" ] || grep '^#.*stand-in' "$ar"; }
}
platformio() { python3 -m json.tool "$to/stonepack/library.json"; }
# Their tools are not in Debian: what the files name must be there.
sources() {
    (cd "$to/stonepack" && grep -q 'SRCS src/stonepack.c' CMakeLists.txt && grep -q '\.\./src/stonepack\.c' zephyr/CMakeLists.txt &&
        ls src/stonepack.c src/stonepack.h zephyr/Kconfig zephyr/module.yml idf_component.yml && ! grep -rn '@[A-Z]*@' .)
}

# The shared library: every call of the header and nothing else, by its soname.
exports() {
    awk '/^SP_API/ { line = $0; while (line !~ /;/) { if ((getline more) <= 0) break; line = line more }
                     sub(/\(.*/, "", line); n = split(line, w, /[ *]+/); print w[n] }' stonepack.h | sort > "$to/declared"
    nm -D --defined-only "$1" | awk '{ print $3 }' | sort > "$to/exported"
    [ "$(wc -l < "$to/declared")" -gt 50 ] && diff "$to/declared" "$to/exported"
}
shared() {
    lib=$to/dest/opt/stonepack/lib
    make -s install-shared DESTDIR="$to/dest" PREFIX=/opt/stonepack && exports "$lib/libstonepack.so" &&
    ${CC:-gcc} "$to/user/main.c" -I"$to/dest/opt/stonepack/include" -L"$lib" -lstonepack -o "$to/by_soname" &&
    rm "$lib/libstonepack.so" && LD_LIBRARY_PATH=$lib "$to/by_soname" && ! "$to/by_soname" 2> /dev/null
}

# The release: the same bytes made twice, elsewhere and otherwise; checksums; the tarball makes itself.
version=$(sh port/package/dist.sh --version)
twice() {
    make -s dist && (umask 077 && TZ=Asia/Tokyo LC_ALL=C.UTF-8 sh port/package/dist.sh "$to/again") &&
    cmp "build/dist/stonepack-$version.tar.gz" "$to/again/stonepack-$version.tar.gz"
}
unpacked() {
    tar -xzf "build/dist/stonepack-$version.tar.gz" -C "$to" && mv "$to/stonepack-$version/package" "$to/stonepack" &&
    cp -r "$to/stonepack" "$to/stonepack-$version/package" &&
    (cd "$to/stonepack-$version" && sha256sum -c --quiet SHA256SUMS && mkdir build && cp -r doc build/ &&
        export SOURCE_DATE_EPOCH="$(stat -c %Y SHA256SUMS)" && sh port/package/dist.sh) &&
    cmp "build/dist/stonepack-$version.tar.gz" "$to/stonepack-$version/build/dist/stonepack-$version.tar.gz"
}
# What is tagged is what port/CHANGELOG.md says, with its day.
tagged() (
    rm -rf "$to/tagged" && mkdir -p "$to/tagged/port/package" && cp stonepack.h "$to/tagged" && cp port/CHANGELOG.md "$to/tagged/port" &&
    cp port/package/dist.sh "$to/tagged/port/package" && cd "$to/tagged" || return 1
    keep() { git add -A && git -c user.name=a -c user.email=a@example.org -c commit.gpgsign=false commit -q --allow-empty -m "$1"; }
    git init -q . && keep one && [ "$(sh port/package/dist.sh --version)" = "$version" ] && git tag v99.0.0 || return 1
    sh port/package/dist.sh --version && { echo "another version's tag is taken"; return 1; }
    keep two && git tag "v$version" && sed "s/^## $version.*/## $version, not yet released/" port/CHANGELOG.md > new && mv new port/CHANGELOG.md
    sh port/package/dist.sh --version && { echo "what has no day is released"; return 1; }
    sed "s/^## $version.*/## $version, 1 May 2026/" port/CHANGELOG.md > new && mv new port/CHANGELOG.md
    [ "$(sh port/package/dist.sh --version)" = "$version" ]
)
# The project's address stands in every package or in none; a tarball made with it keeps it.
addressed() (
    unset HOMEPAGE
    ad=$to/addressed/stonepack-$version
    ad_is=https://stones.example/pack
    [ "$(sh port/package/package.sh --homepage)" ] || ! grep -rniE '^ *"?(url|homepage)"?[:=]' "$to/stonepack"/*.* |
        grep -v 'library.properties:[0-9]*:url=https://example.org/$' | grep . || return 1
    ! HOMEPAGE='not an address' sh port/package/package.sh --homepage || return 1
    HOMEPAGE=$ad_is sh port/package/dist.sh "$to/addressed" && tar -xzf "$ad.tar.gz" -C "$to/addressed" && cd "$ad" &&
    grep -x "url=$ad_is" package/library.properties && ! grep stand-in package/library.properties &&
    grep -x "url: \"$ad_is\"" package/idf_component.yml &&
    grep "\"homepage\": \"$ad_is\"," package/library.json && sh port/package/package.sh --fill port/debian/control /usr | grep -x "Homepage: $ad_is" &&
    sh port/package/package.sh --fill port/package/stonepack.pc /usr | grep -x "URL: $ad_is"
)
# Of the Debian packages, without installing them.
deb_user() (
    rm -rf "$to/root"
    for du_deb in build/deb/*.deb; do dpkg-deb -x "$du_deb" "$to/root" || return 1; done
    "$to/root/usr/bin/stonepack" check --quiet tests/scenes/arch.obj && ls "$to/root/usr/share/man/man1/stonepack.1.gz" &&
    export PKG_CONFIG_LIBDIR="$to/root/usr/lib/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$to/root" &&
    # shellcheck disable=SC2046
    ${CC:-gcc} "$to/user/main.c" $(pkg-config --cflags --libs stonepack) -o "$to/by_deb" && LD_LIBRARY_PATH="$to/root/usr/lib" "$to/by_deb"
)

part "make install" installed
part "shared library: exports the calls of the header and nothing else" shared
part "shared library: the bits of the other" env DIFFER=1 LIBRARY=build/shared.o sh tests/corpus/corpus.sh double ${CC:-gcc} -O0
if have pkg-config; then part "pkg-config" pkgconfig; else skip "pkg-config" pkg-config; fi
if have cmake; then part "find_package after make install" cmake_user "$to/dest/opt/stonepack"; fi
part "tarball: the same bytes twice" twice
part "tarball: checksums hold, and it makes itself" unpacked
if have cmake; then part "CMake project, double and float" cmake_package; else skip "CMake" cmake; fi
if have meson; then part "Meson subproject" meson_package; else skip "Meson" meson; fi
if have git; then part "release: its tag, its version and its day are those of the changelog" tagged; fi
part "address of the project: in every package or none" addressed
part "switches: each is an option of CMake, Meson, ESP-IDF and Zephyr" every_switch
if have cmake; then part "CMake: switches" cmake_switches; fi
if have meson; then part "Meson: switches" meson_switches; fi
if have arm-none-eabi-g++; then part "Arduino library" arduino; else skip "Arduino library" gcc-arm-none-eabi; fi
part "Arduino library.properties: each field its rules ask for" arduino_rules
if have python3; then part "PlatformIO library.json" platformio; else skip "PlatformIO library.json" python3; fi
part "ESP-IDF and Zephyr: files named are there" sources
if have dpkg-buildpackage && have dh && have lintian; then
    part "Debian packages" make -s deb
    part "Debian packages: lintian finds no error" lintian --allow-root --fail-on error "build/deb/stonepack_$version-1_$(dpkg --print-architecture).changes"
    part "Debian packages: they work" deb_user
else skip "Debian packages" "dpkg-dev debhelper lintian"; fi
total
