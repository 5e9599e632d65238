#!/usr/bin/env bash
# Builds an npm package: build_all.sh DIMENSION [--fast] [--threads] [--f64]. The packages' own build_all.sh call it.
set -euo pipefail
dimension=$1
shift
profile=wasm features=dim$dimension bits=32 threads=
for option in "$@"; do
    case $option in
    --fast) profile=wasm-fast ;;
    --threads) threads=required ;;
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

module() {
    "$javascript/../crates/wasm/build.sh" "$pkg/$1" "$profile" "$2" "$features"
}
module rapier_simd.wasm simd
module rapier.wasm scalar
if [ "$threads" = required ]; then
    module rapier_threads.wasm threads
elif [ "$profile" = wasm ]; then
    # Threads need more of the toolchain than the other modules. A package without them is complete otherwise.
    module rapier_threads.wasm threads || { status=$? && [ $status = 3 ]; } || exit $status
fi
node "$javascript/build.mjs" "$dimension" "$pkg" $bits
if [ "$profile" = wasm ]; then
    (cd "$home" && npx typedoc --options "$javascript/typedoc.json" --tsconfig "$javascript/tsconfig.dim$dimension.json" \
        --entryPoints "$javascript/src/rapier$dimension.ts" --out "$pkg/docs")
fi
ls -l "$pkg"
