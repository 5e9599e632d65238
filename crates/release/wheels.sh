#!/usr/bin/env bash
# Builds wheels that the registry accepts, from the source distribution: wheels.sh [manylinux] [musllinux] [here]
#
# `manylinux` and `musllinux` serve every Linux with glibc 2.17 or musl 1.2 and later: zig links, so that the libraries of this
# machine do not matter. `here` serves the system of this machine: macOS, Windows.
set -euo pipefail
cd "$(dirname "$0")/../.."

folder=$PWD/target/artefacts/python
sources=$(mktemp -d)
trap 'rm -rf "$sources"' EXIT
tar -xzf "$folder"/*.tar.gz -C "$sources" --strip-components 1
python3 -m venv "$sources/environment"
"$sources/environment/bin/pip" install --quiet "maturin[zig]>=1.9,<2" twine
host=$(rustc -vV | sed -n 's/^host: //p')

wheel() {
    (cd "$sources" && PATH="$sources/environment/bin:$PATH" maturin build --release --locked --out "$folder" "$@")
}
for platform in "${@:-here}"; do
    case $platform in
    manylinux) wheel --zig --compatibility manylinux2014 --target "${host/musl/gnu}" ;;
    musllinux) wheel --zig --compatibility musllinux_1_2 --target "${host/gnu/musl}" ;;
    here) wheel ;;
    *) printf 'unknown platform %s\n' "$platform" >&2 && exit 2 ;;
    esac
done
"$sources/environment/bin/twine" check --strict "$folder"/*
