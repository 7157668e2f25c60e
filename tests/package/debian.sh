#!/bin/bash
# debian.sh BUILD_DIR WORK_DIR: the Debian packages hold all that is installed, each file once, the
# program runs out of its own, and lintian finds no error in them, where it is there.
set -euo pipefail
build=$1 work=$2
if ! command -v dpkg-deb dpkg-shlibdeps > /dev/null; then
  echo "skipped: dpkg-deb and dpkg-shlibdeps (dpkg-dev) are not here"
  exit 77
fi
rm -rf "$work"
mkdir -p "$work"
(cd "$build" && cpack -D CPACK_PACKAGE_CONTACT="A Packager <packager@debian.org>" \
  -B "$work/packages" > "$work/cpack.log" 2>&1) || { cat "$work/cpack.log"; exit 1; }

packages=(roomgraph roomgraph-mrpt libroomgraph-dev)
[ ! -x "$build/bin/roomgraph-view" ] || packages+=(roomgraph-view)
[ ! -d "$build/python" ] || packages+=(python3-roomgraph)
for package in "${packages[@]}"; do
  mkdir "$work/$package"
  dpkg-deb -x "$work"/packages/"${package}"_*.deb "$work/$package"
  test -f "$work/$package/usr/share/doc/$package/copyright"
  (cd "$work/$package/usr" && find . -type f) >> "$work/packed"
done
cmake --install "$build" --prefix "$work/installed" > /dev/null
(cd "$work/installed" && find . -type f) | sort > "$work/all"
sort "$work/packed" | diff - "$work/all"

roomgraph=$work/roomgraph/usr/bin/roomgraph
"$roomgraph" --version
"$roomgraph" extract "$work/roomgraph/usr/share/roomgraph/maps/office.yaml" -o "$work/results" -q
test -s "$work/results/office.json"
if [ -d "$build/python" ]; then
  PYTHONPATH="$work/python3-roomgraph/usr/lib/python3/dist-packages" /usr/bin/python3 -c '
import roomgraph, sys
assert roomgraph.extract(sys.argv[1]).rooms' "$work/roomgraph/usr/share/roomgraph/maps/office.yaml"
fi
dpkg-deb -f "$work"/packages/roomgraph_*.deb Depends | grep -q libmrpt-maps
if command -v lintian > /dev/null; then
  lintian --allow-root --fail-on error "$work"/packages/*.deb
fi
