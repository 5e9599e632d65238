#!/usr/bin/env bash
# Stops with a message unless Node.js is as new as the scripts here need: their `import.meta.dirname` exists since 20.11.
set -euo pipefail
version=$(node --version 2>/dev/null || true)
IFS=. read -r major minor _ <<<"${version#v}"
if [ "${major:-0}" -lt 20 ] || { [ "$major" -eq 20 ] && [ "$minor" -lt 11 ]; }; then
    printf 'The JavaScript packages need Node.js 20.11 or later. Here: %s\n' "${version:-none}" >&2
    exit 1
fi
