#!/usr/bin/env bash
# Draws the root README.md's pictures of the game scene and of the overlay.
#   bash sandbox/game_pictures.sh [WxH]      of the game scene, 640x360
# The overlay is drawn by a replay of sandbox/pictures/overlay.log, on a display of its own (Xvfb).
# Both are made beside and moved at the end: where a step fails, what is there stays as it is.
set -u
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"  # gives $root

size=${1:-640x360}
pictures=$root/sandbox/pictures
program=$root/build/release/sandbox/lampyris

fail() {
    echo "sandbox/game_pictures.sh: $1" >&2
    exit 1
}

{ installMissing && build release lampyris; } >&2
[[ -w $pictures ]] || fail "$pictures must be writable"
made=$(mktemp -d) || exit 1
trap 'rm -rf "$made"' EXIT

echo "courtyard, eight frames into its motion"
"$program" render courtyard -o "$made/courtyard.png" --size "$size" --time 4 --timestep 0.0166667 --warmup 8 || exit 1

echo "the overlay over cornell"
Xvfb -displayfd 1 -screen 0 1280x720x24 -nolisten tcp -noreset >"$made/display" 2>/dev/null &
server=$!
trap 'kill "$server" 2>/dev/null; rm -rf "$made"' EXIT
for ((i = 0; i < 100; ++i)); do
    [[ -s $made/display ]] && break
    sleep 0.1
done
[[ -s $made/display ]] || fail "Xvfb does not start"
DISPLAY=:$(cat "$made/display") "$program" view cornell --replay "$pictures/overlay.log" --screenshots "$made" || exit 1
mv "$made"/lampyris_*.png "$made/overlay.png" || fail "the overlay was not drawn"

mv "$made/courtyard.png" "$made/overlay.png" "$pictures"
