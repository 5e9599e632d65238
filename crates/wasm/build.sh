#!/usr/bin/env bash
# Builds the WebAssembly module: build.sh OUTPUT PROFILE simd|scalar|threads FEATURES
#
# The standard library for the target comes from `rustup target add wasm32-unknown-unknown` where that works. Elsewhere Debian's toolchain builds it from
# source. Threads need a library that is built from source in any case.
set -euo pipefail
output=$1 profile=$2 kind=$3 features=$4
cd "$(dirname "$0")/../.."

target=wasm32-unknown-unknown
flags='-C link-arg=--export=__stack_pointer -C link-arg=-zstack-size=1048576 -C link-arg=--compress-relocations'
# Kernels say themselves what is inlined. Elsewhere a call is smaller, and as fast.
flags+=" -C llvm-args=-inline-threshold=50"
[ "$kind" = scalar ] || flags+=' -C target-feature=+simd128'
if [ "$kind" = threads ]; then
    features+=,threads
    flags+=' -C target-feature=+atomics,+bulk-memory,+mutable-globals'
    # Shared memory is created by JavaScript (javascript/src/threads.ts): 16 MiB at first, and at most 2 GiB.
    flags+=' -C link-arg=--shared-memory -C link-arg=--import-memory -C link-arg=--export-memory'
    flags+=' -C link-arg=--initial-memory=16777216 -C link-arg=--max-memory=2147483648'
    for name in __wasm_init_tls __tls_size __tls_align; do
        flags+=" -C link-arg=--export=$name"
    done
fi
folder=${CARGO_TARGET_DIR:-target}/wasm-$kind
arguments=(build -p rapier-wasm --lib --profile "$profile" --target "$target" --target-dir "$folder"
    --no-default-features --features "$features")
from_source=(-Z build-std=std,panic_abort)

has_rustup() { command -v rustup >/dev/null; }
has_target() { has_rustup && { rustup target list --installed | grep -qx "$target" || rustup target add "$target" >/dev/null 2>&1; }; }
has_source() { has_rustup && { rustup component list --installed | grep -qx rust-src || rustup component add rust-src >/dev/null 2>&1; }; }

if [ "$kind" != threads ] && has_target; then
    # One dependency uses an unstable feature: see Cargo.toml.
    RUSTC_BOOTSTRAP=libm RUSTFLAGS=$flags cargo "${arguments[@]}"
elif [ "$kind" = threads ] && has_source; then
    RUSTC_BOOTSTRAP=1 RUSTFLAGS=$flags cargo "${from_source[@]}" "${arguments[@]}"
elif [ -x /usr/bin/cargo ] && [ -d /usr/lib/rustlib/src ]; then
    linker=$(crates/wasm/linker.sh)
    PATH=/usr/bin:$PATH RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 RUSTFLAGS=$flags CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker \
        /usr/bin/cargo "${from_source[@]}" "${arguments[@]}"
else
    cat >&2 <<TEXT
No toolchain here builds the module ($kind) for $target. Install one of these:
  * with rustup:  rustup target add $target (for threads: rustup component add rust-src)
  * on Debian:    apt-get install rustc-web cargo-web rust-web-src lld
TEXT
    exit 3
fi
mkdir -p "$(dirname "$output")"
cp "$folder/$target/$profile/rapier_wasm.wasm" "$output"
