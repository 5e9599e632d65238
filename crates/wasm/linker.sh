#!/usr/bin/env bash
# Prints the linker that Debian's toolchain uses for WebAssembly, or says what is missing: linker.sh
set -euo pipefail
linker=$(command -v wasm-ld || command -v rust-lld || true)
if [ -z "$linker" ]; then
    sysroot=$(rustc --print sysroot 2>/dev/null || true)
    linker=$(find ${sysroot:+"$sysroot"} /usr/lib/rustlib -name rust-lld -type f 2>/dev/null | sed -n 1p || true)
fi
if [ -z "$linker" ]; then
    cat >&2 <<'TEXT'
No linker for wasm32-unknown-unknown is here. Debian's rustc-web brings none. Install one of these:
  * on Debian:    apt-get install lld
  * with rustup:  any toolchain, which brings rust-lld
TEXT
    exit 1
fi
printf '%s\n' "$linker"
