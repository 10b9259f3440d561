#!/usr/bin/env bash
# Builds the shim and runs test.gd in a headless Godot 3.
#   examples/godot/godot3/run.sh FOLDER_OF_LIBTREE_FFI [WORK_FOLDER]
# Needs cc, cargo (for Godot's headers, unless GODOT_HEADERS names their folder) and godot3-server, or
# another Godot 3 without a window that GODOT names. Writes to the work folder only. Exit status: 0 passed,
# 1 failed, 2 something is not installed, 3 the headers could not be fetched.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
[ $# -ge 1 ] || { echo "usage: $0 FOLDER_OF_LIBTREE_FFI [WORK_FOLDER]" >&2; exit 2; }
library=$(cd "$1" && pwd)
work=${2:-$root/target/godot3}
godot=${GODOT:-godot3-server}

[ -f "$library/libtree_ffi.so" ] || { echo "no libtree_ffi.so in $library" >&2; exit 2; }
command -v "$godot" >/dev/null || { echo "$godot is not installed (Debian: godot3-server)" >&2; exit 2; }

headers=${GODOT_HEADERS:-}
if [ -z "$headers" ]; then
    manifest=$here/headers/Cargo.toml
    cargo fetch --quiet --locked --manifest-path "$manifest" ||
        { echo "Godot's headers could not be fetched; GODOT_HEADERS may name their folder" >&2; exit 3; }
    headers=$(cargo metadata --format-version 1 --locked --offline --manifest-path "$manifest" |
        tr ',' '\n' | sed -n 's|.*"manifest_path":"\(.*/gdnative-sys-[^/]*\)/Cargo.toml".*|\1|p')/godot_headers
fi
[ -f "$headers/gdnative_api_struct.gen.h" ] || { echo "no Godot 3 headers in '$headers'" >&2; exit 2; }

mkdir -p "$work"/.local/share "$work"/.config "$work"/.cache
work=$(cd "$work" && pwd)
cp "$here"/{project.godot,botanical_tree.gdnlib,botanical_tree.gdns,test.gd} "$work/"
ln -sf "$library/libtree_ffi.so" "$work/libtree_ffi.so"
# Godot's headers are not strict C: -isystem.
cc -std=c11 -Wall -Wextra -Werror -O2 -g -fPIC -shared "$here/botanical_tree.c" "$here/material.c" \
    -isystem "$headers" -I "$root/include" -L "$library" -ltree_ffi -lm "-Wl,-rpath,\$ORIGIN" \
    -o "$work/libbotanical_tree.so"

# A script error leaves Godot running, and its exit status says little: the time limit and the marker.
status=0
HOME=$work LANG=en_US.UTF-8 LD_LIBRARY_PATH=$library timeout "${TREE_TIMEOUT:-120}" \
    "$godot" --path "$work" -s test.gd >"$work/output.txt" 2>&1 </dev/null || status=$?
cat "$work/output.txt"
if [ "$status" -ne 0 ] || ! grep -q '^TREE TEST PASSED' "$work/output.txt" ||
    grep -q 'SCRIPT ERROR' "$work/output.txt"; then
    echo "godot3 test failed (exit status $status)" >&2
    exit 1
fi
