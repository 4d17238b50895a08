#!/usr/bin/env bash
# Starts a server of its own, runs a program with its address in the place of @, and ends it: with_server.sh SERVER PROGRAM...
set -euo pipefail
server=$1
shift
folder=$(mktemp -d)
: >"$folder/says"
"$server" --listen 127.0.0.1:0 >"$folder/says" &
pid=$!
trap 'kill $pid 2>/dev/null || true; wait $pid 2>/dev/null || true; rm -rf "$folder"' EXIT
until grep -q "^listening on " "$folder/says"; do
    kill -0 $pid || exit 1
    sleep 0.05
done
address=$(sed -n 's/^listening on //p' "$folder/says")
"${@/#@/$address}"
