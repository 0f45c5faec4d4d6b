#!/usr/bin/env bash
# Sets up, builds, and runs the program.
#   bash sandbox/run.sh             renders the scenes of the house and the courtyard as it moves to out/, and tables
#                                   of times a node
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

# Each time after eight frames of motion; the last with four more, measured.
for time in 4 8 12; do
    echo
    echo "courtyard, $time s on → out/courtyard_$time.png"
    frames=(--frames 1)
    [[ $time -eq 12 ]] && frames=(--frames 4 --table)
    "$program" render courtyard -o "$root/out/courtyard_$time.png" --report "$root/out/courtyard_$time.json" \
        --size 640x360 --time "$time" --timestep 0.0166667 --warmup 8 --shadow-rays 4 "${frames[@]}" || exit 1
done
