#!/usr/bin/env bash
# Installs the packages into an empty Debian 12 and tries them there as a person would: check_package.sh DEB...
# Wants root, debootstrap and the network that apt uses here. Takes some three minutes, most of them for downloads.
set -euo pipefail
mirror=$(apt-get indextargets --format '$(REPO_URI)' 2>/dev/null | grep -m 1 . || echo http://deb.debian.org/debian)
place=$(mktemp -d)
empty="$place/root"
leave() {
    umount -l "$empty/proc" 2>/dev/null || true
    rm -rf "$place"
}
trap leave EXIT
fail() {
    printf 'check_package: %s\n' "$*" >&2
    exit 1
}
inside() { chroot "$empty" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
person() { inside runuser -u person -- env HOME=/home/person "$@"; }
expect() { # expect TEXT COMMAND...: the command succeeds and prints TEXT
    local text=$1 printed
    shift
    printed=$("$@") || fail "\"$*\" ended with $?"
    [[ $printed == *"$text"* ]] || fail "\"$*\" does not print \"$text\" but: ${printed:0:400}"
}

debootstrap --variant=minbase bookworm "$empty" "$mirror" >"$place/debootstrap.log" 2>&1 || { tail "$place/debootstrap.log"; exit 1; }
cp -r /etc/apt/. "$empty/etc/apt/" # what leads to a mirror here leads to it there
mount -t proc proc "$empty/proc"
cp "$@" "$empty/tmp/"
inside useradd -m person
inside apt-get -q update >"$place/apt.log" 2>&1
inside find / -xdev -path /proc -prune -o -path /tmp -prune -o -print | sort >"$place/before"
program=$(basename "$(printf '%s\n' "$@" | grep /tactum_)")
python=$(basename "$(printf '%s\n' "$@" | grep /python3-tactum_)")
library=$(basename "$(printf '%s\n' "$@" | grep '/libtactum[0-9]')")
headers=$(basename "$(printf '%s\n' "$@" | grep /libtactum-dev_)")
SECONDS=0
inside apt-get -q -y install --no-install-recommends "/tmp/$program" >>"$place/apt.log" 2>&1 || { tail -n 20 "$place/apt.log"; exit 1; }
echo "installed in $SECONDS s"

# Without a display.
samples=/usr/share/tactum/scenes
expect teapot person tactum info "$samples/teapot.glb"
expect '"updates"' person tactum touch "$samples/teapot.obj" --path "$samples/teapot-finger.csv" --out /tmp/touch.csv
person tactum convert "$samples/teapot.glb" /home/person/teapot.tactum 2>/dev/null || fail "no bundle was written"
person tactum thumbnail "$samples/teapot.glb" /home/person/teapot.png --size 128 && [ -s "$empty/home/person/teapot.png" ] || fail "no thumbnail"
person tactum devices >/dev/null || fail "tactum devices failed"
expect simulate inside bash -c 'source /usr/share/bash-completion/completions/tactum; COMP_WORDS=(tactum sim); COMP_CWORD=1; _tactum; echo "${COMPREPLY[@]}"'
for file in man/man1/tactum.1.gz zsh/vendor-completions/_tactum fish/vendor_completions.d/tactum.fish \
    mime/packages/tactum.xml thumbnailers/tactum.thumbnailer applications/tactum.desktop icons/hicolor/512x512/apps/tactum.png; do
    [ -s "$empty/usr/share/$file" ] || fail "there is no /usr/share/$file"
done
[ -s "$empty/usr/lib/udev/rules.d/70-tactum.rules" ] || fail "there is no rule for udev"

# Python, out of the package alone: neither the program nor grpc is needed for what a scene feels like.
inside apt-get -q -y install --no-install-recommends "/tmp/$python" >>"$place/apt.log" 2>&1 || { tail -n 20 "$place/apt.log"; exit 1; }
cp "$(dirname "${BASH_SOURCE[0]}")/felt_as_expected.py" "$empty/home/person/"
[ "$(wc -l <"$empty/home/person/felt_as_expected.py")" -le 20 ] || fail "felt_as_expected.py is longer than 20 lines"
for sample in "$empty$samples"/*.glb "$empty$samples"/moving/*.glb; do
    sample=${sample#"$empty"}
    person tactum convert "$sample" /home/person/sample.tactum 2>/dev/null || fail "no bundle was written of $sample"
    expect "steps as expected" person python3 /home/person/felt_as_expected.py "$sample" /home/person/sample.tactum
done
expect "python3-grpcio" person python3 -c "
import tactum
try: tactum.serve()
except tactum.Error as error: print(error)"
inside apt-get -q -y install --no-install-recommends python3-grpcio python3-protobuf >>"$place/apt.log" 2>&1
expect "True" person python3 -c "
import tactum
with tactum.serve() as haptics:
    haptics.open('$samples/teapot.glb')
    print((haptics.replay(tactum.open('$samples/teapot.glb').path).force == tactum.open('$samples/teapot.glb').touch().force).all())"

# C++, out of its two packages alone: a project of a stranger's. Nothing of what the library is made of is installed with it.
inside apt-get -q -y install --no-install-recommends "/tmp/$library" "/tmp/$headers" g++ cmake make >>"$place/apt.log" 2>&1 || { tail -n 20 "$place/apt.log"; exit 1; }
[ ! -e "$empty/usr/include/eigen3" ] || fail "libtactum-dev brings Eigen along"
cp -r "$(dirname "${BASH_SOURCE[0]}")/../../docs/examples/library" "$empty/home/person/project"
inside chown -R person: /home/person/project
person sh -c 'cd && cmake -S project -B built && cmake --build built' >"$place/project.log" 2>&1 || { tail "$place/project.log"; exit 1; }
for sample in teapot friction-ladder texture-wall moving/windmill; do
    person tactum convert "$samples/$sample.glb" /home/person/sample.tactum 2>/dev/null || fail "no bundle was written of $sample"
    expect "steps, largest force" person /home/person/built/play_bundle /home/person/sample.tactum
done

# With one: the window comes up on the teapot and stays.
inside apt-get -q -y install --no-install-recommends xvfb xauth libgl1-mesa-dri fonts-dejavu-core man-db xdg-utils libglib2.0-bin \
    shared-mime-info desktop-file-utils x11-utils >>"$place/apt.log" 2>&1
expect "author haptic scenes" person man tactum
comes_up() { # comes_up SCENE: the window is there with this file in its title, and remembers that it opened it
    local name
    name=$(basename "$1")
    person timeout 60 xvfb-run -a -s "-screen 0 1280x800x24" bash -c "
        is_up() { xwininfo -root -tree | grep -q '$name.*Tactum' && grep -q '$name' ~/.config/Tactum/Tactum.conf; }
        tactum $1 & window=\$!
        for i in \$(seq 200); do is_up && break; sleep 0.2; done
        is_up && kill -0 \$window && kill \$window" || fail "the window did not come up"
}
comes_up "$samples/teapot.glb"

# A newer package takes the place of this one, and what the person has set stays: what was opened last, and a switch of the view.
settings="$empty/home/person/.config/Tactum/Tactum.conf"
sed -i 's/^spheres=false$/spheres=true/' "$settings"
cp "$settings" "$place/settings"
newer() { # newer DEB: the same package under a higher version
    rm -rf "$place/unpacked"
    dpkg-deb -R "$empty/tmp/$1" "$place/unpacked"
    sed -i 's/^Version: .*/&+newer/' "$place/unpacked/DEBIAN/control"
    dpkg-deb --root-owner-group -Znone -b "$place/unpacked" "$empty/tmp/newer-$1" >>"$place/apt.log"
}
newer "$program"
newer "$python"
inside apt-get -q -y install --no-install-recommends "/tmp/newer-$program" "/tmp/newer-$python" >>"$place/apt.log" 2>&1 ||
    { tail -n 20 "$place/apt.log"; exit 1; }
expect "+newer" inside dpkg-query -W -f '${Version}' tactum
cmp "$settings" "$place/settings" || fail "the upgrade changed the settings"
comes_up "$samples/friction-ladder.glb"
grep -q "^recentFiles=.*friction-ladder.glb.*teapot.glb" "$settings" && grep -q "^spheres=true$" "$settings" ||
    fail "the newer program did not take over the settings"

# A double click on a bundle.
expect vnd.tactum.bundle person env XDG_CURRENT_DESKTOP=GNOME xdg-mime query filetype /home/person/teapot.tactum
expect tactum.desktop person env XDG_CURRENT_DESKTOP=GNOME xdg-mime query default application/vnd.tactum.bundle+zip

# Without the program Python and the library read files all the same: each package has an import process of its own.
cp "$empty$samples/teapot.glb" "$empty/home/person/"
inside apt-get -q -y purge tactum >>"$place/apt.log" 2>&1
expect "steps as expected" person python3 /home/person/felt_as_expected.py /home/person/teapot.glb /home/person/teapot.tactum
expect "steps, largest force" person /home/person/built/play_bundle /home/person/teapot.tactum
inside apt-get -q -y purge python3-tactum 'libtactum*' >>"$place/apt.log" 2>&1
left=$(inside find / -xdev -path /proc -prune -o -name '*actum*' -not -path '/tmp/*' -not -path '/home/*' -not -path '/var/cache/*' -print)
[ -z "$left" ] || fail "removal leaves: $left"
echo "packages: installed, used and removed"
