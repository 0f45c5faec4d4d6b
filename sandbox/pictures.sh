#!/usr/bin/env bash
# Renders the pictures of the root README.md, measures them, and writes the table they stand in.
#   bash sandbox/pictures.sh [WxH [SPP]]     640x360, 256 samples a pixel of the reference
# Everything is made beside and moved at the end: where a step fails, what is there stays as it is.
# References are kept in out/pictures until the program, the size or SPP is another.
set -u
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"  # gives $root

size=${1:-640x360}
spp=${2:-256}
begin='<!-- sandbox/pictures.sh writes from here -->'
end='<!-- to here -->'
readme=$root/README.md
pictures=$root/sandbox/pictures
cache=$root/out/pictures
program=$root/build/release/sandbox/lampyris

fail() {
    echo "sandbox/pictures.sh: $1" >&2
    exit 1
}

# value FILE NAME [GROUP]: a number or a text of a report, the first of that name (behind the group's).
value() {
    awk -v name="\"$2\":" -v group="\"${3:-$2}\":" '
        $1 == group { inside = 1 }
        inside && $1 == name { sub(/^[^:]*: "?/, ""); sub(/"?,?$/, ""); print; exit }' "$1"
}

# reference SCENE EV: $cache/SCENE with final.exr, shown.png and report.json.
reference() {
    local folder=$cache/$1 key
    key="$size $spp $2 $(sha256sum <"$program")" || exit 1
    [[ $(cat "$folder/key" 2>/dev/null) == "$key" ]] && return
    echo "$1: reference, $spp samples a pixel"
    "$program" reference "$1" -o "$made/shown.png" --all "$made/reference" --report "$made/report.json" \
        --size "$size" --spp "$spp" --smooth-indirect --exposure "$2" || exit 1
    if ! { rm -rf "$folder" && mkdir -p "$folder" \
        && mv "$made/shown.png" "$made/report.json" "$made/reference/final.exr" "$folder" \
        && echo "$key" >"$folder/key"; }; then
        fail "$folder cannot be written"
    fi
}

# frame SCENE EV NAME ARGS…: $made/SCENE_NAME.png, and its report and errors beside.
frame() {
    local scene=$1 exposure=$2 file=$made/$1_$3
    echo "$scene: $3"
    "$program" render "$scene" -o "$file.png" --report "$file.json" --size "$size" --quality fast --retrace all \
        --exposure "$exposure" "${@:4}" || exit 1
    "$program" compare "$file.png" "$cache/$scene/final.exr" --exposure "$exposure" >"$file.txt" || exit 1
}

# errors NAME: "12.3 / 0.987"
errors() {
    awk '{ figure[$1] = $2 }
        END { printf (figure["MSE"] < 100 ? "%.1f" : "%.0f") " / %.3f", figure["MSE"], figure["MSSIM"] }' "$made/$1.txt"
}

milliseconds() {
    printf '%.0f ms' "$(value "$made/$1.json" median frame_ms)"
}

# rows SCENE EV: the pictures, and below them their figures.
rows() {
    local name
    printf '| `%s` |' "$1"
    for name in reference thesis full; do
        printf ' ![%s, %s](sandbox/pictures/%s_%s.png) |' "$1" "$name" "$1" "$name"
    done
    printf '\n| `--exposure %s` | %.0f s | %s, MSE / MSSIM %s | %s, %s; over 32 still frames %s |\n' "$2" \
        "$(value "$cache/$1/report.json" seconds)" "$(milliseconds "$1_thesis")" "$(errors "$1_thesis")" \
        "$(milliseconds "$1_full")" "$(errors "$1_full")" "$(errors "$1_still")"
}

draw() {
    reference "$1" "$2"
    cp "$cache/$1/shown.png" "$made/$1_reference.png" || fail "$cache/$1 cannot be read"
    local timed=(--history 0 --light-cutoff 0 --warmup 3 --frames 15)
    frame "$1" "$2" thesis --pipeline thesis "${timed[@]}"
    frame "$1" "$2" full "${timed[@]}"
    frame "$1" "$2" still --history 32 --light-cutoff 0 --warmup 31
}

table() {
    echo '| | reference | `thesis` | `full`, one frame |'
    echo '| --- | --- | --- | --- |'
    rows cornell -1
    rows two_rooms -1.75
    echo
    echo "$size. Reference: path tracing on $(nproc) CPU cores, $spp samples a pixel, indirect light smoothed along"
    echo "surfaces. Frames: median GPU time on $(value "$made/cornell_full.json" device); one frame of \`full\` is no mean over"
    echo "frames, but its photons go where earlier ones looked them up. Made by \`bash sandbox/pictures.sh\`."
}

for mark in "$begin" "$end"; do
    [[ $(grep -cxF -- "$mark" "$readme") == 1 ]] || fail "README.md must hold the line '$mark' once"
done
{ installMissing && build release lampyris; } >&2
[[ -w $pictures && -w $root ]] || fail "$pictures and $root must be writable"
mkdir -p "$cache" || exit 1
made=$(mktemp -d "$cache/made.XXXXXX") || exit 1
trap 'rm -rf "$made"' EXIT

draw cornell -1
draw two_rooms -1.75
table >"$made/table.md"
awk -v begin="$begin" -v end="$end" -v table="$made/table.md" '
    $0 == end { inside = 0 }
    !inside { print }
    $0 == begin { inside = 1; while ((getline line < table) > 0) print line }' "$readme" >"$made/README.md" \
    || fail "the new README.md cannot be written"
rm "$made"/*_still.png
mv "$made"/*.png "$pictures" || exit 1
mv "$made/README.md" "$readme" || exit 1
cat "$made/table.md"
