# Functions for scripts that build packages of the registry; sourced, with the working folder in `folder`.

# Prints the folder with the source of a package: name, version.
package_source() {
    local probe="$folder/probe-$1-$2"
    mkdir -p "$probe/src"
    : >"$probe/src/lib.rs"
    printf '[package]\nname = "probe"\nversion = "0.0.0"\nedition = "2024"\n[dependencies]\n%s = { version = "=%s", default-features = false }\n[workspace]\n' \
        "$1" "$2" >"$probe/Cargo.toml"
    (cd "$probe" && cargo fetch --quiet) || return 1
    (cd "$probe" && cargo metadata --format-version 1) | python3 -c 'import json, os, sys
name, version = sys.argv[1:]
for package in json.load(sys.stdin)["packages"]:
    if (package["name"], package["version"]) == (name, version): print(os.path.dirname(package["manifest_path"]))' "$1" "$2"
}
