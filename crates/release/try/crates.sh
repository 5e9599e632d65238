#!/usr/bin/env bash
# Uses the packed crates as a user would: crates.sh [--all]
#
# A folder outside the repository gets the unpacked `.crate` files and one program per crate, the first of the crate's own README.
# The programs of rapier2d and rapier3d run with default features. `--all` adds the other engines, the facades, the Bevy plugins, all
# features, the flags of docs.rs, and the oldest Rust that the manifest states, where its toolchain can be had.
set -euo pipefail
cd "$(dirname "$0")/../../.."
. crates/release/try/lib.sh

artefacts=$PWD/target/artefacts/crates
user=$(mktemp -d)
trap 'rm -rf "$user"' EXIT
# Outside the repository no configuration of it acts, but the compiled dependencies may be shared by the programs.
export CARGO_TARGET_DIR=$user/target

for crate in "$artefacts"/*.crate; do
    tar -xzf "$crate" -C "$user"
done
cd "$user"

# package_of NAME: the unpacked folder of a published crate.
package_of() { printf '%s\n' "$user/$1"-[0-9]*; }

# unpublished: entries that point to the unpacked crates in place of the registry, for all crates that others depend on.
unpublished() {
    printf '[patch.crates-io]\n'
    for package in "$user"/*-engine*-[0-9]*/; do
        local name
        name=$(basename "$package")
        printf '"%s" = { path = "%s" }\n' "${name%-*}" "${package%/}"
    done
}

# program NAME: a program with one dependency, whose source is the first program of the crate's README.
program() {
    local package library folder
    package=$(package_of "$1")
    library=$(sed -n '/^\[lib\]/,/^\[/s/^name = "\(.*\)"/\1/p' "$package/Cargo.toml")
    folder=$user/program-$1
    mkdir -p "$folder/src"
    {
        printf '[package]\nname = "program-%s"\nversion = "0.1.0"\nedition = "2024"\n' "$1"
        printf '[features]\n'
        printf '[dependencies]\n%s = { package = "%s", path = "%s" }\n' "$library" "$1" "$package"
        grep -q 'use bevy::' "$package/README.md" && printf 'bevy = { version = "0.19", default-features = false, features = ["std", "bevy_log"] }\n'
        printf '[workspace]\n'
        unpublished
    } >"$folder/Cargo.toml"
    {
        printf 'fn main() {\n'
        awk '/^```rust/ { inside = 1; next } /^```/ { if (inside) exit } inside' "$package/README.md"
        printf '}\n'
    } >"$folder/src/main.rs"
    cargo run --quiet --manifest-path "$folder/Cargo.toml"
}

# documented NAME: the documentation as docs.rs builds it, with the features that the manifest names for it.
documented() {
    local package features
    package=$(package_of "$1")
    features=$(sed -n '/^\[package.metadata.docs.rs\]/,/^\[/p' "$package/Cargo.toml" | tr -d '\n' | grep -o '"[a-z-]*"' | tr -d '"' | paste -sd,)
    RUSTDOCFLAGS="--cfg docsrs --deny warnings" cargo doc --quiet --no-deps --features "$features" --manifest-path "$package/Cargo.toml"
}

# with_all_features NAME: compiles the library with every feature that can be combined.
with_all_features() {
    cargo check --quiet --all-features --manifest-path "$(package_of "$1")/Cargo.toml"
}

# with_oldest_rust NAME: compiles the library with the Rust that the manifest states.
with_oldest_rust() {
    local package oldest
    package=$(package_of "$1")
    oldest=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' "$package/Cargo.toml")
    rustup toolchain install --profile minimal "$oldest" && cargo "+$oldest" check --quiet --manifest-path "$package/Cargo.toml"
}

programs=(rapier2d-engine rapier3d-engine)
engines=("${programs[@]}" rapier2d-engine-f64 rapier3d-engine-f64)
if [ "${1:-}" = --all ]; then
    programs=("${engines[@]}" rapier{2d,3d}-facade{,-f64,-v036,-f64-v036} rapier{2d,3d}-engine-bevy)
fi
heading
for crate in "${programs[@]}"; do
    row "program of the README with \`$crate\`" program "$crate"
done
if [ "${1:-}" = --all ]; then
    for crate in "${engines[@]}"; do
        row "all features of \`$crate\`" with_all_features "$crate"
        row "documentation of \`$crate\` with the flags of docs.rs" documented "$crate"
    done
    if rustup toolchain install --profile minimal 1.89 >/dev/null 2>&1; then
        row "\`rapier3d-engine\` with the oldest Rust" with_oldest_rust rapier3d-engine
    else
        printf '| `rapier3d-engine` with the oldest Rust | not run: its toolchain cannot be installed here | |\n'
    fi
fi
exit "$failures"
