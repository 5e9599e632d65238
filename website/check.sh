#!/usr/bin/env bash
# Checks the website: types, links of doc comments, a build without broken links, every page in headless Chromium. Pictures of sample pages are
# in `shots`. Needs the npm package (`cd ../rapier3d; npm install; ./build_all.sh`), a Rust toolchain, and Chromium or CHROMIUM.
set -euo pipefail
cd "$(dirname "$0")"
yarn --silent build
yarn --silent check
node test/browser.mjs "$@"
