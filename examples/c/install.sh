#!/usr/bin/env bash
# Installs the library for C and C++ under PREFIX:
#
#     examples/c/install.sh PREFIX [FOLDER WITH libtree_ffi.so AND libtree_ffi.a]
#
# Without the folder it builds the library first (cargo build --release -p tree-ffi).
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: install.sh PREFIX [LIBRARY FOLDER]" >&2; exit 2; }
mkdir -p "$1"
prefix=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)

if [ $# -ge 2 ]; then
    built=$2
else
    (cd "$root" && cargo build --release -p tree-ffi)
    built=${CARGO_TARGET_DIR:-$root/target}/release
fi

version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' "$root/Cargo.toml")
install -d "$prefix/include" "$prefix/lib/pkgconfig" "$prefix/lib/cmake/tree"
install -m 644 "$root/include/tree.h" "$root/include/tree.hpp" "$prefix/include"
found=0
for library in libtree_ffi.so libtree_ffi.dylib libtree_ffi.a; do
    if [ -e "$built/$library" ]; then
        install -m 755 "$built/$library" "$prefix/lib"
        found=1
    fi
done
[ $found = 1 ] || { echo "no libtree_ffi in $built" >&2; exit 1; }
sed -e "s|@PREFIX@|$prefix|" -e "s|@VERSION@|$version|" "$here/tree.pc.in" \
    >"$prefix/lib/pkgconfig/tree.pc"
install -m 644 "$here/cmake/tree-config.cmake" "$prefix/lib/cmake/tree"
sed "s|@VERSION@|$version|" "$here/cmake/tree-config-version.cmake.in" \
    >"$prefix/lib/cmake/tree/tree-config-version.cmake"
