#!/usr/bin/env bash
# check_format.sh CLANG_FORMAT: fails when a source is not written as .clang-format says.
# To mend: clang-format-14 -i FILE
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
find app core device resources ui tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 -n 40 -P "$(nproc)" "$1" --dry-run -Werror
