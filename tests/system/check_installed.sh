#!/usr/bin/env bash
# Installs the built tree, builds docs/examples/play-bundle against it as a stranger would, and plays a bundle that the
# installed program has exported: check_installed.sh SOURCE BUILD
set -euo pipefail
source=$1 build=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cmake --install "$build" --prefix "$place/tactum" >"$place/install.log" || { cat "$place/install.log"; exit 1; }
cmake -S "$source/docs/examples/play-bundle" -B "$place/build" -G Ninja -DCMAKE_PREFIX_PATH="$place/tactum" \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)" >"$place/configure.log" || { cat "$place/configure.log"; exit 1; }
cmake --build "$place/build"
"$place/tactum/bin/tactum" convert "$place/tactum/share/tactum/scenes/teapot.obj" "$place/teapot.zip"
"$place/build/play-bundle" "$place/teapot.zip"
# The client library by itself: its three programs against the installed server.
cmake -S "$source/docs/examples/hl" -B "$place/hl" -G Ninja -DCMAKE_PREFIX_PATH="$place/tactum" \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)" >"$place/configure.log" || { cat "$place/configure.log"; exit 1; }
cmake --build "$place/hl"
"$source/tests/app/hl/with_server.sh" "$place/tactum/libexec/tactum/tactum-serve" "$place/hl/teapot" @ \
    "$place/tactum/share/tactum/scenes/teapot.obj"
# A driver of one's own, compiled with the installed header alone.
mkdir "$place/drivers"
cc -O2 -shared -fPIC "-I$place/tactum/include/tactum" "$source/docs/examples/driver/haply_2diy.c" -lm -o "$place/drivers/haply_2diy.so"
TACTUM_DRIVERS="$place/drivers" HAPLY_2DIY=/dev/null "$place/tactum/bin/tactum" devices | grep -q 'driver:haply_2diy:/dev/null'
# A bundle that was touched by another hand is refused.
printf 'x' | dd of="$place/teapot.zip" bs=1 seek=2000 conv=notrunc status=none
if "$place/build/play-bundle" "$place/teapot.zip"; then
    echo "a changed bundle was played"
    exit 1
fi
