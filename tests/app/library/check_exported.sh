#!/usr/bin/env bash
# What programs see of the library is what exported.txt says, and nothing else: check_exported.sh LIBRARY EXPORTED
# A line that is new there is a promise; one that is gone breaks programs, and the library needs another number
# (docs/library.md). To write it anew: check_exported.sh LIBRARY - >exported.txt
set -euo pipefail
exported() {
    nm -D --defined-only --without-symbol-versions "$1" | cut -d ' ' -f 3 | c++filt | grep -v '^TACTUM_' | LC_ALL=C sort -u
}
if [ "$2" = - ]; then exported "$1"; exit; fi
diff -u "$2" <(exported "$1") || { echo "libtactum exports something else than $2 says"; exit 1; }
