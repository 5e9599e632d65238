#!/usr/bin/env bash
# Builds an npm package: build_all.sh DIMENSION [--fast] [--f64]. The packages' own build_all.sh call it.
set -euo pipefail
dimension=$1
shift
profile=wasm features=dim$dimension bits=32
for option in "$@"; do
    case $option in
    --fast) profile=wasm-fast ;;
    --f64) features+=,f64 bits=64 ;;
    *) printf 'unknown option %s\n' "$option" >&2 && exit 2 ;;
    esac
done
javascript=$(cd "$(dirname "$0")" && pwd)
"$javascript/need_node.sh"
home=$javascript/../rapier${dimension}d
pkg=$home/pkg
rm -rf "$pkg"
mkdir -p "$pkg"

for lanes in simd scalar; do
    name=rapier.wasm
    [ $lanes = simd ] && name=rapier_simd.wasm
    "$javascript/../crates/wasm/build.sh" "$pkg/$name" "$profile" $lanes "$features"
done
node "$javascript/build.mjs" "$dimension" "$pkg" $bits
if [ "$profile" = wasm ]; then
    (cd "$home" && npx typedoc --options "$javascript/typedoc.json" --tsconfig "$javascript/tsconfig.dim$dimension.json" \
        --entryPoints "$javascript/src/rapier$dimension.ts" --out "$pkg/docs")
fi
ls -l "$pkg"
