#!/usr/bin/env bash
# Sets up, builds, and runs the program.
#   bash sandbox/run.sh             renders the scenes of the house to out/, a table of times a node
#   bash sandbox/run.sh ARGS…       build/release/sandbox/lampyris ARGS…
set -u
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# Standard output belongs to the program.
{ installMissing && build release lampyris; } >&2
program=$root/build/release/sandbox/lampyris

if [[ $# -gt 0 ]]; then
    exec "$program" "$@"
fi

mkdir -p "$root/out"
for scene in cornell "$root"/sandbox/scenes/*.gltf; do
    name=$(basename "$scene" .gltf)
    echo
    echo "$name → out/$name.png, out/$name.json"
    "$program" render "$scene" -o "$root/out/$name.png" --report "$root/out/$name.json" \
        --size 640x360 --retrace all --warmup 2 --frames 5 --table || exit 1
done
