#!/usr/bin/env bash
# Installs the built tree, and builds and runs what a stranger would against it, the library alone: check_installed.sh SOURCE BUILD
set -euo pipefail
source=$1 build=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
fail() {
    printf 'check_installed: %s\n' "$*" >&2
    exit 1
}
quietly() { "$@" >"$place/log" 2>&1 || { cat "$place/log"; fail "\"$*\" failed"; }; }
quietly cmake --install "$build" --prefix "$place/tactum"
configure() { # configure EXAMPLE FOLDER
    quietly cmake -S "$source/docs/examples/$1" -B "$2" -G Ninja -DCMAKE_PREFIX_PATH="$place/tactum" \
        -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)"
    cp "$place/log" "$2/configured"
}
samples="$place/tactum/share/tactum/scenes"
library="$place/tactum/$(cd "$place/tactum" && dirname "$(find lib* -name 'libtactum.so' | head -n 1)")"

# The examples: a bundle that the installed program has exported, a loop of one's own, the whole engine.
configure library "$place/library"
! grep -iE 'eigen|tiff|assimp|png|grpc' "$place/library/configured" || fail "find_package(Tactum) asks for what is above"
cmake --build "$place/library"
for sample in teapot friction-ladder texture-wall moving/windmill; do
    "$place/tactum/bin/tactum" convert "$samples/$sample.glb" "$place/sample.tactum" 2>"$place/log" || { cat "$place/log"; exit 1; }
    "$place/library/play_bundle" "$place/sample.tactum"
done
"$place/library/own_loop" "$samples/teapot.glb"
"$place/library/whole_engine"
# One that was touched by another hand is refused.
printf 'x' | dd of="$place/sample.tactum" bs=1 seek=2000 conv=notrunc status=none
! "$place/library/play_bundle" "$place/sample.tactum" || fail "a changed bundle was played"

# What is installed is the surface and nothing below it, and the library has what it needs beside it.
[ "$(cd "$place/tactum/include/tactum" && find . -name '*.h' | LC_ALL=C sort)" = \
    "$({ cd "$source/app/library/tactum" && find . -name '*.h'; echo ./tactum_driver.h; echo ./app/hl/hl.h; } | LC_ALL=C sort)" ] ||
    fail "other headers than the public ones are installed"
beside=$(echo "$library"/tactum-*)
[ -x "$beside/tactum-import" ] || fail "there is no tactum-import beside the library"
[ "$(find "$beside/presets" -name '*.tactum-preset' | wc -l)" -gt 20 ] || fail "there are no presets beside the library"

# The same bits whatever the program is compiled for, and whatever it has loaded before: libdraco exports a tinygltf of its own.
compile() { # compile PROGRAM FLAGS...
    local program=$1
    shift
    ${CXX:-g++} -std=c++20 -O2 "-I$place/tactum/include" "$@" "$source/tests/system/same_bits.cpp" -o "$place/$program" "-L$library" \
        "-Wl,-rpath,$library" -ltactum
}
compile portable
wanted=$("$place/portable" "$samples/teapot.glb" "$place/copy.glb") || fail "the portable program failed: $wanted"
echo "$wanted"
for flags in -march=x86-64-v3 -march=native -O0 "-Wl,--no-as-needed -ldraco"; do
    # shellcheck disable=SC2086 # words on purpose
    compile other $flags
    if [[ $flags == *v3 ]] && ! /lib64/ld-linux-x86-64.so.2 --help | grep -q 'x86-64-v3 (supported'; then continue; fi
    for sample in teapot moving/windmill; do
        [ "$("$place/other" "$samples/$sample.glb" "$place/copy.glb")" = "$("$place/portable" "$samples/$sample.glb" "$place/copy.glb")" ] ||
            fail "with $flags $sample.glb gives other bits, or nothing"
    done
done

# The client library by itself: its three programs against the installed server.
configure hl "$place/hl"
cmake --build "$place/hl"
"$source/tests/app/hl/with_server.sh" "$place/tactum/libexec/tactum/tactum-serve" "$place/hl/teapot" @ "$samples/teapot.obj"
# A driver of one's own, compiled with the installed header alone.
mkdir "$place/drivers"
cc -O2 -shared -fPIC "-I$place/tactum/include/tactum" "$source/docs/examples/driver/haply_2diy.c" -lm -o "$place/drivers/haply_2diy.so"
cc -O2 -shared -fPIC "-I$place/tactum/include/tactum" "-I$source/docs/examples/driver/hapkit" "$source/docs/examples/driver/hapkit.c" -lm \
    -o "$place/drivers/hapkit.so"
TACTUM_DRIVERS="$place/drivers" HAPKIT=/dev/null "$place/tactum/bin/tactum" devices | grep -q 'driver:hapkit:/dev/null'
TACTUM_DRIVERS="$place/drivers" HAPLY_2DIY=/dev/null "$place/tactum/bin/tactum" devices | grep -q 'driver:haply_2diy:/dev/null'
