# Functions of the gate's scripts, which source this file.

# Runs a command under a heading, and prints the time.
stage() {
    printf '\n=== %s\n' "$*"
    SECONDS=0
    "$@"
    printf '=== took %d s\n' "$SECONDS"
}

# Installs packages of Debian. Returns 1 where that is impossible.
install() {
    if ! command -v apt-get >/dev/null || [ "$(id -u)" -ne 0 ]; then
        printf 'not installed, and cannot be installed here: %s\n' "$*" >&2
        return 1
    fi
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$@" >/dev/null
}
