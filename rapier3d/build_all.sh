#!/usr/bin/env bash
# Builds the npm package into pkg: build_all.sh [--fast]
#
# --fast leaves out what only a release needs: full optimisation for size, and the documentation.
exec "$(dirname "$0")/../javascript/build_all.sh" 3 "$@"
