#!/usr/bin/env bash
# Runs the golden scenes on every platform that this machine can build for and execute: natively, as WebAssembly with and without SIMD (in Node), and for
# aarch64 (under qemu). Arguments choose platforms: native wasm-simd wasm-scalar aarch64.
#
# A target comes from `rustup target add` where that works. Elsewhere the standard library is built from source with Debian's toolchain:
#   apt-get install rustc-web cargo-web rust-web-src             # WebAssembly and aarch64
#   apt-get install qemu-user gcc-aarch64-linux-gnu              # aarch64
set -euo pipefail
cd "$(dirname "$0")/../.."

export CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 CARGO_PROFILE_RELEASE_DEBUG=false

# Prints why a platform is left out.
missing() {
    printf '%s: not run, %s\n' "$1" "$2"
    left_out=1
}

# build TARGET FLAGS ARGUMENTS…: builds with the first toolchain that has the target.
build() {
    local target=$1 flags=$2
    shift 2
    local folder=target/golden/$target${flags:+-flags}
    if rustup target list --installed 2>/dev/null | grep -qx "$target" || rustup target add "$target" >/dev/null 2>&1; then
        RUSTFLAGS=$flags cargo build --release -p golden "$@" --target "$target" --target-dir "$folder"
    elif [ -x /usr/bin/cargo ] && [ -d /usr/lib/rustlib/src ]; then
        PATH=/usr/bin:$PATH RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 RUSTFLAGS=$flags \
            /usr/bin/cargo build -Z build-std=std,panic_abort --release -p golden "$@" --target "$target" --target-dir "$folder"
    else
        return 1
    fi
}

native() {
    cargo run --release -p golden --features parallel -- --threads 1,2,3,8
}

wasm() {
    local name=$1 flags=$2 linker
    command -v node >/dev/null || { missing "$name" 'there is no Node.js'; return; }
    linker=$(find "$(rustc --print sysroot)" -name rust-lld -type f | head -n 1)
    CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker build wasm32-unknown-unknown "$flags" --lib ||
        { missing "$name" 'no toolchain builds for wasm32-unknown-unknown'; return; }
    node crates/golden/run.mjs "target/golden/wasm32-unknown-unknown${flags:+-flags}/wasm32-unknown-unknown/release/golden.wasm"
}

aarch64() {
    command -v qemu-aarch64 >/dev/null || { missing aarch64 'there is no qemu-aarch64'; return; }
    command -v aarch64-linux-gnu-gcc >/dev/null || { missing aarch64 'there is no linker aarch64-linux-gnu-gcc'; return; }
    CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc build aarch64-unknown-linux-gnu '' --bin golden ||
        { missing aarch64 'no toolchain builds for aarch64-unknown-linux-gnu'; return; }
    qemu-aarch64 -L /usr/aarch64-linux-gnu target/golden/aarch64-unknown-linux-gnu/aarch64-unknown-linux-gnu/release/golden
}

left_out=0
for platform in "${@:-native wasm-simd wasm-scalar aarch64}"; do
    for name in $platform; do
        printf '=== %s\n' "$name"
        case $name in
        native) native ;;
        wasm-simd) wasm wasm-simd '-C target-feature=+simd128' ;;
        wasm-scalar) wasm wasm-scalar '' ;;
        aarch64) aarch64 ;;
        *) printf 'unknown platform %s\n' "$name" >&2 && exit 2 ;;
        esac
    done
done
exit "$left_out"
