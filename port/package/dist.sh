#!/bin/sh
# dist: a release as one tarball, build/dist/stonepack-VERSION.tar.gz: this tree, in package/ the folder of `make package` (the pair,
# its header, files for CMake, Meson and others), in doc/ the manual page, and SHA256SUMS of all of it. The same files make the same
# bytes, whoever makes them wherever and whenever. HOMEPAGE=ADDRESS goes into the packages, and into port/package/homepage there.
#
#     dist.sh [FOLDER]          default build/dist
#     dist.sh --version         of port/CHANGELOG.md, which is the header's too, or it ends here
#
# A release is a commit whose tag is vVERSION, and whose heading in port/CHANGELOG.md has a date: `## 0.2.0, 1 May 2026`. A commit that
# is tagged otherwise, or before that, makes none.
set -eu
export LC_ALL=C TZ=UTC
version=$(sed -n 's/^## \([0-9][0-9.]*\).*/\1/p' port/CHANGELOG.md | head -n 1)
header=$(awk '$2 ~ /^SP_VERSION_(MAJOR|MINOR|PATCH)$/ { v = v (v == "" ? "" : ".") $3 } END { print v }' stonepack.h)
[ "$version" = "$header" ] || { echo "dist: port/CHANGELOG.md is of $version, stonepack.h of $header" >&2; exit 1; }
for tag in $(git tag --points-at HEAD 2> /dev/null | grep '^v[0-9]'); do
    [ "$tag" = "v$version" ] || { echo "dist: this commit is tagged $tag, port/CHANGELOG.md is of $version" >&2; exit 1; }
    grep -qE "^## $version, [0-9]+ [A-Z][a-z]+ [0-9]{4}$" port/CHANGELOG.md ||
        { echo "dist: this commit is tagged $tag, port/CHANGELOG.md has no day for it" >&2; exit 1; }
done
if [ "${1:-}" = --version ]; then echo "$version"; exit; fi
out=${1:-build/dist}
to=$out/stonepack-$version

# What is kept under version control; where nothing is, as in an unpacked tarball, all that was not built.
files() {
    { git ls-files 2> /dev/null | grep . ||
        find . -type f ! -path './build/*' ! -path './package/*' ! -path './doc/*' ! -path './debian/*' ! -path './.pc/*' \
            ! -path './.git/*' ! -path '*/__pycache__/*' ! -name SHA256SUMS | sed 's|^\./||'
    } | grep -v '^\.ci/'
}
moment() {                                              # of the last commit
    if [ "${SOURCE_DATE_EPOCH:-}" ]; then echo "$SOURCE_DATE_EPOCH"
    else git log -1 --format=%ct 2> /dev/null || stat -c %Y port/CHANGELOG.md; fi
}

rm -rf "$to"
mkdir -p "$to/doc"
files | while read -r file; do
    mkdir -p "$to/$(dirname "$file")"
    cp "$file" "$to/$file"
done
homepage=$(sh port/package/package.sh --homepage)
if [ "${HOMEPAGE:-}" ]; then echo "$homepage" > "$to/port/package/homepage"; fi
sh port/package/package.sh "$to/package"
cp build/doc/stonepack.1 "$to/doc/"
(cd "$to" && find . -type f ! -name SHA256SUMS | sort | xargs sha256sum > SHA256SUMS)
tar --format=ustar --sort=name --owner=0 --group=0 --numeric-owner --mode=u+rwX,go+rX,go-w --mtime="@$(moment)" -C "$out" \
    -cf "$to.tar" "stonepack-$version"
gzip -9 -n -f "$to.tar"
rm -rf "$to"
(cd "$out" && sha256sum "stonepack-$version.tar.gz" > "stonepack-$version.tar.gz.sha256")
echo "$to.tar.gz"
