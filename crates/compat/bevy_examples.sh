#!/usr/bin/env bash
# Runs the examples of bevy_rapier 0.34 without a window, on Rapier 0.32 and on the facade, and prints a table.
#
# Usage: crates/compat/bevy_examples.sh [FOLDER [PATTERN]]
#   FOLDER   working folder (default: target/bevy-examples of the repository)
#   PATTERN  regular expression that selects examples by name (default: all)
# Variables: ROUNDS (runs of each example on each engine, default 3), UPDATES (updates of each run, default 360), FEATURES
# (further features of bevy_rapier, for example simd-stable).
#
# The package 0.34.0 of bevy_rapier contains no examples, so those of the package 0.35.0 are compiled with the library 0.34.0.
# The library loses its renderer: its features enable Bevy's renderer, but its code does not use it.
#
# The time of a step is the time of its thread on the processor, which other programs on the machine influence little. The
# runs of both engines alternate. FOLDER/runs.txt contains the measurements, FOLDER/lines the printed lines, and
# FOLDER/table.md the table. The exit status is 1 if an example was not built, failed, or ended on one engine only.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=${1:-$root/target/bevy-examples}
pattern=${2:-.}
rounds=${ROUNDS:-3}
library=0.34.0
examples=0.35.0
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
export CARGO_TARGET_DIR="$folder/target"
. "$here/registry.sh"

# Examples that are not run, and the reason.
skipped='
custom_system_setup2 panics on both: bevy_rapier lacks its resource TimestepMode without the default systems
custom_system_setup3 panics on both: bevy_rapier lacks its resource TimestepMode without the default systems
debugdump2 prints the schedule and simulates nothing
debugdump3 prints the schedule and simulates nothing
picking3 needs a pointer and a rendered window
rapier_to_bevy_mesh needs materials of the renderer
serialization2 prints the private state of the engine
testbed2 needs egui; the other examples are its scenes
testbed3 needs egui; the other examples are its scenes
'

# Writes standard input to a file. An equal file keeps its time, which saves a compilation.
put() {
    local text
    text=$(cat)
    [[ -e $1 && $text == "$(cat "$1")" ]] || printf '%s\n' "$text" >"$1"
}

# Writes the package FOLDER/<engine>-<dimension>d, whose examples are those of bevy_rapier: dimension, engine.
prepare() {
    local dim=$1 engine=$2 package="$folder/$2-$1d" name file
    mkdir -p "$package/src" "$package/examples"
    put "$package/Cargo.toml" <<MANIFEST
[package]
name = "headless"
version = "0.0.0"
edition = "2021"
[dependencies]
bevy = { version = "=0.18.1", default-features = false, features = ["std", "bevy_camera", "bevy_color", "bevy_gizmos", "bevy_light", "bevy_log", "bevy_scene", "bevy_sprite", "bevy_state", "bevy_window"] }
bevy_rapier${dim}d = { path = "../library-${dim}d", features = [${FEATURES:+\"${FEATURES//,/\",\"}\"}] }
cpu-time = "1"
log = "0.4"
rapier${dim}d = "0.32"
tracing-subscriber = "0.3"
[workspace]
[profile.release]
codegen-units = 1
[profile.release.package.headless] # The physics is in other packages.
opt-level = 1
[patch.crates-io]
$([[ $engine == upstream ]] || echo "rapier${dim}d = { path = \"$here/rapier${dim}d\" }")
MANIFEST
    printf 'use bevy_rapier%sd as physics;\n#[path = "%s/bevy/headless.rs"]\nmod headless;\npub use headless::DefaultPlugins;\n' "$dim" "$here" |
        put "$package/src/lib.rs"
    for file in "$folder/examples-${dim}d"/*.rs; do
        name=$(basename "$file" .rs)
        if selected "$name"; then
            { cat "$file"; printf '\nuse headless::DefaultPlugins;\n'; } | put "$package/examples/$name.rs"
        else
            rm -f "$package/examples/$name.rs"
        fi
    done
}

# Returns whether an example is run.
selected() {
    [[ $1 =~ $pattern ]] && ! grep -q "^$1 " <<<"$skipped"
}

# Builds the examples of a package and copies the programs to FOLDER/bin/<engine>: dimension, engine.
build() {
    local dim=$1 engine=$2 name result=0
    mkdir -p "$folder/bin/$engine"
    (cd "$folder/$engine-${dim}d" && cargo build --release --examples --keep-going >"$folder/build-$engine-${dim}d.log" 2>&1)
    for name in "$folder/$engine-${dim}d"/examples/*.rs; do
        name=$(basename "$name" .rs)
        if ! cp "$CARGO_TARGET_DIR/release/examples/$name" "$folder/bin/$engine/$name"; then
            echo "$name was not built on $engine: see $folder/build-$engine-${dim}d.log" >&2
            result=1
        fi
        # Both engines build to the same path: no program of one may stay for the other.
        rm -f "$CARGO_TARGET_DIR/release/examples/$name"
    done
    return "$result"
}

# Runs an example once, appends its measurements to runs.txt and keeps its lines: engine, name.
run() {
    local output="$folder/lines/$1-$2.txt" status measured
    timeout 1200 "$folder/bin/$1/$2" >"$output" 2>&1
    status=$?
    measured=$(grep '^measured ' "$output")
    echo "$2 $1 status=$status${measured#measured}" >>"$folder/runs.txt"
    sed -i '/^measured /d' "$output"
    return "$status"
}

outcome=0
rm -rf "$folder/bin" "$folder/lines"
mkdir -p "$folder/lines"
: >"$folder/runs.txt"
for dim in 2 3; do
    name=bevy_rapier${dim}d
    source=$(package_source "$name" "$library") && [[ -n $source ]] || exit 1
    rm -rf "$folder/library-${dim}d"
    cp -a "$source" "$folder/library-${dim}d" # The old times of the files save compilations.
    sed -i -E '/^ *"bevy\/bevy_(core_pipeline|pbr|render)",$/d' "$folder/library-${dim}d/Cargo.toml"
    source=$(package_source "$name" "$examples") && [[ -n $source ]] || exit 1
    rm -rf "$folder/examples-${dim}d"
    cp -r "$source/examples" "$folder/examples-${dim}d"
    for engine in upstream facade; do
        prepare "$dim" "$engine"
        build "$dim" "$engine" || outcome=1
    done
done
for ((round = 0; round < rounds; round++)); do
    for program in "$folder"/bin/upstream/*; do
        name=$(basename "$program")
        [[ -e $folder/bin/facade/$name ]] || continue
        for engine in upstream facade; do
            run "$engine" "$name" || outcome=1
        done
    done
done
python3 "$here/bevy/table.py" "$folder" | tee "$folder/table.md"
printf '\nNot run:\n'
sed -nE 's/^([a-z0-9_]+) (.+)$/* \1: \2/p' <<<"$skipped"
exit "$outcome"
