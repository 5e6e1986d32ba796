#!/bin/sh
# deb: Debian packages of the tarball, in build/deb: it is unpacked there, port/debian/ put in place, its changelog and copyright filled in.
set -eu
export LC_ALL=C TZ=UTC
version=$(sh port/package/dist.sh --version)
tarball=build/dist/stonepack-$version.tar.gz
tree=build/deb/stonepack-$version
rm -rf build/deb
mkdir -p build/deb
tar -xzf "$tarball" -C build/deb
cp "$tarball" "build/deb/stonepack_$version.orig.tar.gz"
cp -r port/debian "$tree/debian"
(cd "$tree" && sh port/package/package.sh --fill port/debian/control /usr > debian/control)
date=$(date -R -d "@$(stat -c %Y "$tree/SHA256SUMS")")
cat > "$tree/debian/changelog" <<EOT
stonepack ($version-1) unstable; urgency=medium

  * Version $version; port/CHANGELOG.md tells what is new.

 -- $(sed -n 's/^Maintainer: //p' port/debian/control)  $date
EOT
awk -v by="$(sed -n 's/^Copyright (c) //p' LICENSE)" '
    /@COPYRIGHT@/ { sub(/@COPYRIGHT@/, by) }
    /@LICENCE@/ { while ((getline line < "LICENSE") > 0) if (n++ > 3) print line == "" ? " ." : " " line; next }
    { print }' port/debian/copyright > "$tree/debian/copyright"
cd "$tree"
unset MAKEFLAGS MFLAGS MAKELEVEL
dpkg-buildpackage -us -uc > ../build.log 2>&1 || { tail -n 40 ../build.log; exit 1; }
cd ..
ls ./*.deb
