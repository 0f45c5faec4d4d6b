# Sourced by sandbox/run.sh and tests/run.sh: packages that are missing, and the build.
# Functions print one line and end the script where they cannot go on.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages() {
    sed -e 's/#.*//' "$root/sandbox/packages.txt" | awk 'NF { print $1 }'
}

missingPackages() {
    local name
    for name in $(packages); do
        [[ $(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null) == installed ]] || echo "$name"
    done
}

installMissing() {
    if ! command -v dpkg-query >/dev/null; then
        echo "no dpkg here: what sandbox/packages.txt lists must be installed already" >&2
        return
    fi
    local missing asRoot=()
    missing=$(missingPackages | tr '\n' ' ')
    [[ -z $missing ]] && return
    if [[ $(id -u) -ne 0 ]]; then
        if ! command -v sudo >/dev/null || ! sudo -n true 2>/dev/null; then
            echo "Packages are missing. Install them as root, then run this again:" >&2
            echo "apt-get update && apt-get install --yes --no-install-recommends $missing" >&2
            exit 1
        fi
        asRoot=(sudo -n)
    fi
    local apt=("${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q)
    "${apt[@]}" update || { echo "apt-get update failed" >&2; exit 1; }
    # shellcheck disable=SC2086  # a list of words
    "${apt[@]}" install --yes --no-install-recommends $missing || { echo "apt-get install failed" >&2; exit 1; }
}

# build PRESET [TARGET…]; what was said is shown where it fails.
build() {
    local preset=$1
    shift
    (cd "$root" && cmake --preset "$preset" && cmake --build --preset "$preset" ${1:+--target "$@"}) || exit 1
}
