# shellcheck shell=bash disable=SC2154,SC2016
# What ./run and ./check share: install the packages that are missing, configure, build. Sourced.
# `root` is set by whoever sources this file; nobody changes the working directory, so that the paths on
# the command line stay right.

say() { printf '%s\n' "$@"; } # a line for each argument

# One line: what, where and what to do.
die() {
    printf '%s\n' "$*" >&2
    exit 3
}

package_lists=("$root/cmake/debian-packages.txt")
wanted_packages() { sed 's/#.*//; /^[[:space:]]*$/d; s/[[:space:]]*$//' "${package_lists[@]}" | sort -u; }

# Also the names that installed packages provide: they differ between releases.
installed_packages() {
    dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides}\n' |
        sed -n 's/^installed //p' | tr ',' '\n' | sed 's/^ *//; s/ .*//' | sort -u
}

# A few lines of apt's hundreds: how much, how far, and every error.
condense_apt() {
    local line unpacked=0
    while IFS= read -r line; do
        case $line in
        *"newly installed"* | "Need to get"* | "After this"* | E:* | W:* | Err:* | "dpkg: error"* | sudo:*)
            say "  $line"
            ;;
        Unpacking*)
            unpacked=$((unpacked + 1))
            if [ $((unpacked % 100)) -eq 0 ]; then say "  $unpacked unpacked"; fi
            ;;
        esac
    done
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
        # Said once; from then on CMake names what it cannot find.
        [ -d "$root/build" ] ||
            say "This is not Debian: install first what Debian calls $(wanted_packages | xargs)."
        return 0
    fi
    local missing sudo log="$root/build/packages.log"
    missing=$(comm -23 <(wanted_packages) <(installed_packages) | xargs)
    if [ -z "$missing" ]; then return; fi

    say "Installing what is missing:"
    say "  apt-get update && apt-get install --no-install-recommends $missing"
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
compilers() {
    local processors fit=1000000
    processors=$(nproc)
    if [ -r /proc/meminfo ]; then fit=$(awk '/^MemAvailable/ { print int($2 / 1.5e6) + 1 }' /proc/meminfo); fi
    echo $((fit < processors ? fit : processors))
}

# A line for every tenth of ninja's way, and every complaint.
condense_ninja() {
    local line tenth=0 now
    while IFS= read -r line; do
        if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
            now=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
            if [ $now -gt $tenth ]; then say "  ${BASH_REMATCH[0]}"; fi
            tenth=$now
        elif [[ ! $line =~ ^(--|ninja: Entering|ninja: no work) ]]; then
            say "$line"
        fi
    done
}

# build PRESET TARGET...
build() {
    local preset=$1 command
    configure "$preset"
    shift
    command=(ninja -C "$root/build/$preset" -j "$(compilers)" "$@")
    say "Building ($preset)"
    # A terminal has ninja's own moving line.
    if [ -t 1 ]; then "${command[@]}"; else "${command[@]}" | condense_ninja; fi ||
        die "The build failed: the first error above says where."
}
