#!/usr/bin/env bash
# Instructions of a step of a robot (examples/robots.rs), counted by valgrind, with four substeps and with one.
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v valgrind >/dev/null || { echo 'valgrind is not installed' >&2; exit 1; }
cargo build --release -p bench --example robots
program=${CARGO_TARGET_DIR:-target}/release/examples/robots

# count NAME STEPS SUBSTEPS: the instructions of the whole run.
count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$@" 2>&1 | sed -n 's/.*Collected : //p'
}

for robot in ant humanoid arm; do
    for substeps in 4 1; do
        first=$(count $robot 20 $substeps)
        both=$(count $robot 120 $substeps)
        printf '%-9s %s substeps %9d\n' $robot $substeps $(((both - first) / 100))
    done
done
