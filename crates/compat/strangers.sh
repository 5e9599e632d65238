#!/usr/bin/env bash
# Builds and tests crates of the registry against the facade instead of the Rapier that they were written for.
#
# Usage: crates/compat/strangers.sh [FOLDER [PATTERN]]
#   FOLDER   working folder (default: target/strangers of the repository)
#   PATTERN  regular expression that selects crates by name (default: all)
#
# Prints one line per crate: name, version, compile errors, passed and failed tests, and "cargo failed" with its exit status.
# The log of each crate is FOLDER/<name>.log. The exit status is 1 if a crate was not fetched or failed.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=${1:-$root/target/strangers}
pattern=${2:-.}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
export CARGO_TARGET_DIR="$folder/target"
. "$here/registry.sh"

# name, version, arguments of cargo. The tests of the crates with `check` need a window: their libraries are checked
# only. The last three need the packages libasound2-dev and libudev-dev of Debian.
crates='
rapier3d-meshloader 0.13.0 test --all-features
rapier3d-urdf 0.13.0 test --all-features
bevy_rapier3d 0.34.0 check
bevy_rapier2d 0.34.0 check
fyrox-impl 1.0.1 check
'

# Copies the source of a crate of the registry to FOLDER/<name>, with the patch in its manifest.
prepare() {
    local source target="$folder/$1"
    source=$(package_source "$1" "$2") && [[ -n $source ]] || return 1
    rm -rf "$target"
    cp -r "$source" "$target"
    rm -f "$target/Cargo.lock" # A lock file refuses the patched versions.
    printf '\n[workspace]\n[patch.crates-io]\n' >>"$target/Cargo.toml"
    for package in rapier2d rapier2d-f64 rapier3d rapier3d-f64; do
        printf '%s = { path = "%s" }\n' "$package" "$here/$package"
    done >>"$target/Cargo.toml"
}

outcome=0
printf '%-24s %-8s %6s  %s\n' crate version errors tests
while read -r name version arguments; do
    [[ -n $name && $name =~ $pattern ]] || continue
    log="$folder/$name.log"
    if ! prepare "$name" "$version"; then
        printf '%-24s %-8s %6s  %s\n' "$name" "$version" - 'not fetched'
        outcome=1
        continue
    fi
    # shellcheck disable=SC2086 # The arguments are several words.
    (cd "$folder/$name" && cargo $arguments >"$log" 2>&1)
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
