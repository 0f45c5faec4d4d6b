#!/usr/bin/env bash
# Sets up, builds, and runs the tests.
#   bash tests/run.sh         every test of the release build
#   bash tests/run.sh asan    address and undefined-behaviour sanitizers; leaks are looked for where no driver runs
#   bash tests/run.sh tsan    thread sanitizer, on the tests that need no device
#   bash tests/run.sh tidy    clang-format and clang-tidy
set -u
source "$(dirname "${BASH_SOURCE[0]}")/../sandbox/setup.sh"

cpuTests='^(unit|graph)$'
sources() { find "$root"/{engine,modules,sandbox,shaders,tests} -name '*.h' -o -name '*.cpp'; }

runTests() { # PRESET, ctest's arguments
    local preset=$1
    shift
    (cd "$root" && ctest --preset "$preset" -j "$(nproc)" "$@")
}

release() { build release && runTests release; }

asan() {
    build asan
    local failed=0
    runTests asan -L "$cpuTests" || failed=1
    ASAN_OPTIONS=detect_leaks=0 runTests asan -LE "$cpuTests" || failed=1
    return $failed
}

tsan() {
    build tsan cpu_tests
    runTests tsan -L "$cpuTests"
}

tidy() {
    build release # what is generated must be there
    local failed=0
    sources | xargs clang-format --dry-run -Werror || failed=1
    sed -n 's/.*"file": "\(.*\)",*/\1/p' "$root/build/release/compile_commands.json" | grep -v "^$root/build/" |
        sort -u | xargs -n 1 -P "$(nproc)" clang-tidy --quiet -p "$root/build/release" || failed=1
    return $failed
}

installMissing
case ${1:-release} in
    release | asan | tsan | tidy) "${1:-release}" ;;
    *)
        echo "tests/run.sh knows asan, tsan, tidy, and without an argument all tests; not '$1'" >&2
        exit 2
        ;;
esac
result=$?
[[ $result -eq 0 ]] && echo "tests/run.sh ${1:-release}: passed" || echo "tests/run.sh ${1:-release}: FAILED"
exit $result
