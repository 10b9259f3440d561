#!/usr/bin/env bash
# Installs what `evaluate -- peers` compares with, into the folder given, TREE_PEERS, or target/peers. Needs npm and
# python3 (3.11 or newer); what is not to be had is left out, and evaluate says so.
set -uo pipefail
root=$(cd "$(dirname "$0")/../../.." && pwd)
folder=${1:-${TREE_PEERS:-$root/target/peers}}
mkdir -p "$folder" && cd "$folder" || exit 1
failed=0

echo "== node: ez-tree"
[ -f package.json ] || echo '{ "private": true }' >package.json
npm install --no-audit --no-fund @dgreenheck/ez-tree@1.1.0 three@0.187.0 || failed=1

echo "== python: modular-tree, pymatting"
[ -x python/bin/python ] || python3 -m venv python || failed=1
for package in "modular-tree==5.6.0 numpy" "pymatting==1.1.16 pillow"; do
    # shellcheck disable=SC2086 # Two packages.
    python/bin/python -m pip install --quiet --disable-pip-version-check $package || failed=1
done
# The first import compiles for half a minute, and keeps what it has compiled.
python/bin/python -c "import pymatting" || failed=1
exit $failed
