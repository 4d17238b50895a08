"""What desktops, app stores, Flatpak and AppImage are told of the program is one story: check_desktop.py ROOT

Desktop file, metainfo, thumbnailer, MIME types, both recipes, changelogs and CMake name the same program, version and
libraries. Where Debian's validators are installed (cmake/packaging-packages.txt) they judge the files as well.
"""
import configparser
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(sys.argv.pop())
DESKTOP = ROOT / "resources" / "desktop"
ID = "org.tactum.Tactum"
MIME = "{http://www.freedesktop.org/standards/shared-mime-info}"
METAINFO = (DESKTOP / f"{ID}.metainfo.xml").read_text()
RECIPE = (ROOT / "resources" / "appimage" / "AppImageBuilder.yml").read_text()
MANIFEST = ROOT / "resources" / "flatpak" / f"{ID}.json"
CMAKE = (ROOT / "cmake" / "TactumPackage.cmake").read_text()


def entry(file):
    parser = configparser.ConfigParser(interpolation=None)
    parser.optionxform = str
    parser.read(DESKTOP / file)
    return parser[parser.sections()[0]]


def plain(markdown):
    """One line without links and marks."""
    return " ".join(re.sub(r"\[([^]]*)\]\([^)]*\)|[*`]", r"\1", markdown).split())


def releases():
    """Of the changelog: version, date and first paragraph."""
    text = (ROOT / "CHANGELOG.md").read_text()
    return [(version, date, plain(rest.strip().split("\n\n")[0])) for version, date, rest in
            re.findall(r"^## (\d+\.\d+\.\d+), (\d{4}-\d\d-\d\d)\n(.*?)(?=^## |\Z)", text, re.M | re.S)]


class OneName(unittest.TestCase):
    def setUp(self):
        self.metainfo = ElementTree.fromstring(METAINFO)
        self.manifest = json.loads(MANIFEST.read_text())
        self.program = entry("tactum.desktop")["Exec"].split()[0]

    def test_the_id(self):
        self.assertEqual(self.metainfo.findtext("id"), ID)
        self.assertEqual(self.manifest["id"], ID)
        self.assertRegex(RECIPE, rf"(?m)^    id: {re.escape(ID)}$")

    def test_the_files(self):
        self.assertEqual(self.metainfo.findtext("launchable"), "tactum.desktop")
        self.assertEqual(self.manifest["rename-desktop-file"], "tactum.desktop")
        for file in ("tactum.desktop", "tactum.thumbnailer", "tactum-mime.xml"):
            self.assertIn(f"/{file}\"", CMAKE)
        self.assertIn(f"set(metainfo {ID}.metainfo.xml)", CMAKE)

    def test_the_program_and_its_icon(self):
        self.assertEqual(self.metainfo.findtext("provides/binary"), self.program)
        self.assertEqual(self.manifest["command"], self.program)
        self.assertEqual(entry("tactum.thumbnailer")["Exec"].split()[0], self.program)
        self.assertIn(f"    exec: usr/bin/{self.program}\n", RECIPE)
        icon = entry("tactum.desktop")["Icon"]
        self.assertEqual(self.manifest["rename-icon"], icon)
        self.assertIn(f"    icon: {icon}\n", RECIPE)
        self.assertTrue((ROOT / "resources" / "icons" / f"{icon}.svg").exists())
        self.assertIn(f"RENAME {icon}.png", CMAKE)
        sizes = re.search(r"foreach\(size ([\d ]+)\)", CMAKE)[1].split()
        self.assertEqual((sizes[0], sizes[-1]), ("16", "512"))

    def test_the_words(self):
        for key, path in (("Name", "name"), ("Comment", "summary")):
            self.assertEqual(entry("tactum.desktop")[key], self.metainfo.findtext(path))

    def test_the_types_of_files(self):
        opened = entry("tactum.desktop")["MimeType"]
        self.assertEqual(entry("tactum.thumbnailer")["MimeType"], opened)
        types = set(opened.strip(";").split(";"))
        self.assertLessEqual({media.text for media in self.metainfo.findall("provides/mediatype")}, types)
        known = {kind.get("type") for kind in ElementTree.parse(DESKTOP / "tactum-mime.xml").iter(f"{MIME}mime-type")}
        self.assertLessEqual({kind for kind in types if "tactum" in kind or "gltf" in kind}, known)


class OneVersion(unittest.TestCase):
    def test_every_place_has_it(self):
        version = re.search(r"project\(Tactum VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        debian = (ROOT / "resources" / "debian" / "changelog").read_text()
        self.assertEqual(releases()[0][0], version)
        self.assertEqual(re.match(r"tactum \((\S+)\)", debian)[1], version)
        self.assertEqual(re.findall(r"\d+\.\d+\.\d+(?=\n|_amd64|-x86_64)", RECIPE), [version] * 3)

    def test_releases_are_those_of_the_changelog(self):
        told = [(release.get("version"), release.get("date"), plain(release.findtext("description/p")))
                for release in ElementTree.fromstring(METAINFO).iter("release")]
        self.assertEqual(told, releases())


class Libraries(unittest.TestCase):
    def test_the_manifest_has_what_the_program_is_built_with(self):
        wanted, section = set(), ""
        for line in (ROOT / "cmake" / "debian-packages.txt").read_text().splitlines():
            if line.startswith("#"):
                section = line
            name = line.partition("#")[0].strip()
            if section in ("# The core.", "# The program.") and (name.endswith("-dev") or name.startswith("protobuf")):
                wanted.add(name)
        manifest = json.loads(MANIFEST.read_text())
        given = manifest["x-debian-of-the-runtime"] + [name for module in manifest["modules"] for name in
                                                       module.get("x-debian", [])]
        self.assertEqual(sorted(given), sorted(wanted | {"pybind11-dev"}))

    def test_it_may_use_screen_and_devices(self):
        allowed = json.loads(MANIFEST.read_text())["finish-args"]
        for one in ("--socket=wayland", "--socket=fallback-x11", "--share=ipc", "--device=all"):
            self.assertIn(one, allowed)

    def test_both_recipes_are_said_to_be_untried(self):
        for folder in ("flatpak", "appimage"):
            self.assertIn("**Untried**", (ROOT / "resources" / folder / "README.md").read_text())


class Pictures(unittest.TestCase):
    def test_they_are_there(self):
        images = [image.text for image in ElementTree.fromstring(METAINFO).iter("image")]
        self.assertGreaterEqual(len(images), 3)
        for image in images:
            self.assertTrue((ROOT / image.replace("@TACTUM_HOME@/", "")).exists(), image)


class Judged(unittest.TestCase):
    def judge(self, *command, **words):
        if not shutil.which(command[0]):
            self.skipTest(f"there is no {command[0]}")
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **words)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_the_desktop_file(self):
        self.assertEqual(self.judge("desktop-file-validate", DESKTOP / "tactum.desktop"), "")

    def test_the_metainfo(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / f"{ID}.metainfo.xml"
            file.write_text(METAINFO.replace("@TACTUM_HOME@", "https://tactum.example"))
            self.judge("appstreamcli", "validate", "--no-net", file)

    def test_the_manifest(self):
        with tempfile.TemporaryDirectory() as folder:  # it leaves one of its own where it runs
            said = self.judge("flatpak-builder", "--show-manifest", MANIFEST.resolve(), cwd=folder)
        self.assertEqual([line for line in said.splitlines() if "-WARNING **" in line], [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
