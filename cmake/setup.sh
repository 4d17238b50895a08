# shellcheck shell=bash disable=SC2154,SC2016
# What ./run and ./check share: install the packages that are missing, configure, build. Sourced.
# `root` is set by whoever sources this file; nobody changes the working directory, so that the paths on
# the command line stay right.

say() { printf '%s\n' "$*"; }

# One line: what, where and what to do.
die() {
    printf '%s\n' "$*" >&2
    exit 3
}

wanted_packages() { sed 's/#.*//; /^[[:space:]]*$/d; s/[[:space:]]*$//' "$root/cmake/debian-packages.txt" | sort; }

installed_packages() {
    wanted_packages | xargs dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2>/dev/null |
        sed -n 's/^installed //p' | sort -u
}

# A few lines of apt's hundreds: how much, how far, and every error.
condense_apt() {
    awk '/newly installed|^Need to get|^After this|^[EW]: |^Err:|^dpkg: error|^sudo: / { print "  " $0; fflush() }
         /^Unpacking / && ++unpacked % 100 == 0 { print "  " unpacked " packages unpacked"; fflush() }'
}

# Empty for root, sudo where there is one; else says what root has to do.
administrator() {
    if [ "$(id -u)" -eq 0 ]; then return; fi
    command -v sudo >/dev/null || die "This needs root, and there is no sudo here: run the line above as root, then start again."
    # Without a terminal nobody can type a password.
    if [ -t 0 ]; then echo sudo; else echo sudo -n; fi
}

install_missing() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "This is not Debian: what Debian calls $(wanted_packages | xargs) must be here already."
        return
    fi
    local missing sudo log="$root/build/packages.log"
    missing=$(comm -23 <(wanted_packages) <(installed_packages) | xargs)
    if [ -z "$missing" ]; then return; fi

    say "Installing what is missing:"
    say "  apt-get install --no-install-recommends $missing"
    sudo=$(administrator)
    mkdir -p "$root/build"
    # shellcheck disable=SC2086 # words on purpose
    { $sudo apt-get -q update &&
        $sudo env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 \
            install --no-install-recommends $missing; } </dev/null 2>&1 | tee "$log" | condense_apt ||
        die "apt-get could not install them: see $log, mend it, and start again."
}

configure() {
    local preset=$1 folder="$root/build/$1" log="$root/build/$1-configure.log" fresh=()
    # ninja itself configures again when a CMake file changed; not so when the presets did.
    if [ "$folder/build.ninja" -nt "$root/CMakePresets.json" ] &&
        grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then return; fi
    # A cache of another place, a copied tree for one, cannot be reused.
    if [ -e "$folder/CMakeCache.txt" ]; then fresh=(--fresh); fi
    say "Configuring ($preset)"
    mkdir -p "$root/build"
    cmake "${fresh[@]}" -S "$root" --preset "$preset" >"$log" 2>&1 || {
        grep -A 6 'CMake Error' "$log" >&2 || tail -n 20 "$log" >&2
        die "CMake could not configure: see $log."
    }
}

# As many compilers as there are processors, and no more than fit into the memory that is free.
jobs() {
    awk -v processors="$(nproc)" '/^MemAvailable/ { fit = int($2 / 1.5e6) }
        END { if (fit < 1) fit = 1; print fit < processors ? fit : processors }' /proc/meminfo
}

# On a terminal ninja's own line; else a line for every tenth of the way, and every complaint.
condense_ninja() {
    awk '/^\[[0-9]+\/[0-9]+\] / {
             split(substr($1, 2), step, /[\/\]]/)
             if (int(10 * step[1] / step[2]) > tenth) {
                 tenth = int(10 * step[1] / step[2]); print "  " $1; fflush()
             }
             next
         }
         /^ninja: no work to do/ { next }
         { print; fflush() }'
}

# build PRESET TARGET...
build() {
    local preset=$1 command
    configure "$preset"
    shift
    command=(ninja -C "$root/build/$preset" -j "$(jobs)" "$@")
    say "Building ($preset)"
    if [ -t 1 ]; then "${command[@]}"; else "${command[@]}" | condense_ninja; fi ||
        die "The build failed: the first error above says where."
}
