#!/usr/bin/env bash
# Builds and tests crates of the registry against a facade instead of the Rapier that they were written for.
#
# Usage: crates/compat/strangers.sh [FOLDER [PATTERN]]
#   FOLDER   working folder (default: target/strangers of the repository)
#   PATTERN  regular expression that selects crates by <name>-<version> (default: all)
#
# Prints one line per crate: name, version, compile errors, passed and failed tests, and "cargo failed" with its exit status.
# The log of each crate is FOLDER/<name>-<version>.log. The exit status is 1 if a crate was not fetched or failed.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=${1:-$root/target/strangers}
pattern=${2:-.}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
export CARGO_TARGET_DIR="$folder/target"
. "$here/registry.sh"

# name, version, facade (folder of this one), arguments of cargo. The crates with `check` need a window or long builds: their
# libraries are checked only. fyrox-impl and bevy_rapier 0.34 need the packages libasound2-dev and libudev-dev of Debian.
# Dependencies of rapier_testbed and bevy_rapier for 0.36 state Rust 1.97.1: RUSTUP_TOOLCHAIN selects a newer compiler.
crates='
rapier3d-meshloader 0.13.0 . test --all-features
rapier3d-urdf 0.13.0 . test --all-features
rapier_testbed3d 0.32.0 . check
rapier_testbed2d 0.32.0 . check
bevy_rapier3d 0.34.0 . check
bevy_rapier2d 0.34.0 . check
fyrox-impl 1.0.1 . check
rapier3d-meshloader 0.36.1 v036 check --all-features
rapier3d-urdf 0.36.1 v036 check --all-features
rapier3d-mjcf 0.36.1 v036 check --all-features
rapier_testbed3d 0.36.1 v036 check --ignore-rust-version
rapier_testbed2d 0.36.1 v036 check --ignore-rust-version
bevy_rapier3d 0.37.0 v036 check --ignore-rust-version
bevy_rapier2d 0.37.0 v036 check --ignore-rust-version
'

# Copies the source of a crate of the registry to FOLDER/<name>-<version>, with the patch in its manifest: name, version, facade.
prepare() {
    local source target="$folder/$1-$2"
    source=$(package_source "$1" "$2") && [[ -n $source ]] || return 1
    rm -rf "$target"
    cp -r "$source" "$target"
    rm -f "$target/Cargo.lock" # A lock file refuses the patched versions.
    printf '\n[workspace]\n[patch.crates-io]\n' >>"$target/Cargo.toml"
    for package in rapier2d rapier2d-f64 rapier3d rapier3d-f64; do
        printf '%s = { path = "%s" }\n' "$package" "$here/$3/$package"
    done >>"$target/Cargo.toml"
}

outcome=0
printf '%-24s %-8s %6s  %s\n' crate version errors tests
while read -r name version facade arguments; do
    [[ -n $name && $name-$version =~ $pattern ]] || continue
    log="$folder/$name-$version.log"
    if ! prepare "$name" "$version" "$facade"; then
        printf '%-24s %-8s %6s  %s\n' "$name" "$version" - 'not fetched'
        outcome=1
        continue
    fi
    # shellcheck disable=SC2086 # The arguments are several words.
    (cd "$folder/$name-$version" && cargo $arguments >"$log" 2>&1)
    status=$?
    result=
    if [[ $status -ne 0 ]]; then
        result=", cargo failed ($status)"
        outcome=1
    fi
    errors=$(grep -cE '^error(\[E[0-9]+\]|: (failed|no matching))' "$log")
    passed=$(grep -oE '[0-9]+ passed' "$log" | awk '{sum += $1} END {print sum + 0}')
    failed=$(grep -oE '[0-9]+ failed' "$log" | awk '{sum += $1} END {print sum + 0}')
    printf '%-24s %-8s %6s  %s passed, %s failed%s\n' "$name" "$version" "$errors" "$passed" "$failed" "$result"
done <<<"$crates"
exit "$outcome"
