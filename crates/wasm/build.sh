#!/usr/bin/env bash
# Builds the WebAssembly module: build.sh OUTPUT PROFILE simd|scalar FEATURES
#
# The standard library for the target comes from `rustup target add wasm32-unknown-unknown` where that works. Elsewhere Debian's toolchain builds it from
# source.
set -euo pipefail
output=$1 profile=$2 lanes=$3 features=$4
cd "$(dirname "$0")/../.."

target=wasm32-unknown-unknown
flags='-C link-arg=--export=__stack_pointer -C link-arg=-zstack-size=1048576 -C link-arg=--compress-relocations'
# Kernels say themselves what is inlined. Elsewhere a call is smaller, and as fast.
flags+=" -C llvm-args=-inline-threshold=50"
[ "$lanes" = simd ] && flags+=' -C target-feature=+simd128'
folder=${CARGO_TARGET_DIR:-target}/wasm-$lanes
arguments=(build -p rapier-wasm --lib --profile "$profile" --target "$target" --target-dir "$folder"
    --no-default-features --features "$features")

if command -v rustup >/dev/null && { rustup target list --installed | grep -qx "$target" || rustup target add "$target" >/dev/null 2>&1; }; then
    # One dependency uses an unstable feature: see Cargo.toml.
    RUSTC_BOOTSTRAP=libm RUSTFLAGS=$flags cargo "${arguments[@]}"
elif [ -x /usr/bin/cargo ] && [ -d /usr/lib/rustlib/src ]; then
    linker=$(crates/wasm/linker.sh)
    PATH=/usr/bin:$PATH RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 RUSTFLAGS=$flags CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker \
        /usr/bin/cargo -Z build-std=std,panic_abort "${arguments[@]}"
else
    cat >&2 <<'TEXT'
No toolchain here builds for wasm32-unknown-unknown. Install one of these:
  * with rustup:  rustup target add wasm32-unknown-unknown
  * on Debian:    apt-get install rustc-web cargo-web rust-web-src lld
TEXT
    exit 1
fi
mkdir -p "$(dirname "$output")"
cp "$folder/$target/$profile/rapier_wasm.wasm" "$output"
