#!/usr/bin/env bash
# Runs the golden scenes on every platform that this machine can build for and execute: natively, as WebAssembly with and without SIMD (in Node), and for
# other processors under qemu. Arguments choose platforms: native wasm-simd wasm-scalar aarch64 i686 armv7 riscv64 s390x (big-endian).
#
# A target comes from `rustup target add` where that works. Elsewhere the standard library is built from source with Debian's toolchain:
#   apt-get install rustc-web cargo-web rust-web-src             # all targets
#   apt-get install qemu-user gcc-aarch64-linux-gnu gcc-i686-linux-gnu gcc-arm-linux-gnueabihf gcc-riscv64-linux-gnu gcc-s390x-linux-gnu
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

# emulated NAME TARGET EMULATOR LINKER SYSROOT: builds for a foreign processor, and runs under its emulator.
emulated() {
    local name=$1 target=$2 emulator=$3 linker=$4 sysroot=$5 variable
    command -v "$emulator" >/dev/null || { missing "$name" "there is no $emulator"; return; }
    command -v "$linker" >/dev/null || { missing "$name" "there is no linker $linker"; return; }
    variable=CARGO_TARGET_$(printf '%s' "$target" | tr a-z- A-Z_)_LINKER
    (export "$variable=$linker" && build "$target" '' --bin golden) ||
        { missing "$name" "no toolchain builds for $target"; return; }
    "$emulator" -L "$sysroot" "target/golden/$target/$target/release/golden"
}

# Emulators before 8.0.4 multiply two singles into a double wrongly (MDEBR): sines and cosines in single precision differ.
s390x() {
    local version
    version=$(qemu-s390x --version 2>/dev/null | sed -n 's/.*version \([0-9.]*\).*/\1/p')
    if [ -n "$version" ] && [ "$(printf '8.0.4\n%s\n' "$version" | sort -V | head -n 1)" != 8.0.4 ]; then
        missing s390x "qemu-s390x $version has an error in MDEBR that 8.0.4 mends"
    else
        emulated s390x s390x-unknown-linux-gnu qemu-s390x s390x-linux-gnu-gcc /usr/s390x-linux-gnu
    fi
}

left_out=0
for platform in "${@:-native wasm-simd wasm-scalar aarch64 i686 armv7 riscv64 s390x}"; do
    for name in $platform; do
        printf '=== %s\n' "$name"
        case $name in
        native) native ;;
        wasm-simd) wasm wasm-simd '-C target-feature=+simd128' ;;
        wasm-scalar) wasm wasm-scalar '' ;;
        aarch64) emulated aarch64 aarch64-unknown-linux-gnu qemu-aarch64 aarch64-linux-gnu-gcc /usr/aarch64-linux-gnu ;;
        i686) emulated i686 i686-unknown-linux-gnu qemu-i386 i686-linux-gnu-gcc /usr/i686-linux-gnu ;;
        armv7) emulated armv7 armv7-unknown-linux-gnueabihf qemu-arm arm-linux-gnueabihf-gcc /usr/arm-linux-gnueabihf ;;
        riscv64) emulated riscv64 riscv64gc-unknown-linux-gnu qemu-riscv64 riscv64-linux-gnu-gcc /usr/riscv64-linux-gnu ;;
        s390x) s390x ;;
        *) printf 'unknown platform %s\n' "$name" >&2 && exit 2 ;;
        esac
    done
done
exit "$left_out"
