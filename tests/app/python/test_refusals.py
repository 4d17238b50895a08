"""What cannot be is one sentence in Python, whatever comes in; the process goes on."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np
import tactum
from plates import CORNERS, TRIANGLES, plate, slide

SCENES = pathlib.Path(sys.argv.pop())


class Arrays(unittest.TestCase):
    def refused(self, sentence, call, *arguments, **words):
        with self.assertRaisesRegex(tactum.Error, sentence) as caught:
            call(*arguments, **words)
        self.assertNotIn("\n", str(caught.exception))

    def test_paths_that_are_none(self):
        scene = plate()
        good = slide(scene)
        for path, sentence in (
            ([], r"^path: has the shape \(0,\), and rows of t, x, y, z or of x, y, z are wanted$"),
            (np.zeros((0, 4)), "^path: has no rows$"), (np.zeros((0, 3)), "^path: has no rows$"),
            (np.zeros(4), r"^path: has the shape \(4,\)"), (np.zeros((3, 5)), r"^path: has the shape \(3, 5\)"),
            (np.zeros((2, 2, 4)), r"^path: has the shape \(2, 2, 4\)"), (np.float64(3), r"^path: has the shape \(\)"),
            (np.full((3, 3), np.nan), "^path: has a number that is not finite$"),
            (np.full((3, 3), np.inf), "^path: has a number that is not finite$"),
            (np.full((3, 3), 1e7), "^path: its times have to rise, and its places to be within 1e6 m of the origin$"),
            (good[::-1], "^path: its times have to rise"), (np.zeros((3, 4)), "^path: its times have to rise"),
            (good.astype(complex), "^path: holds complex128, and real numbers are wanted$"),
            (good.astype(str), "^path: holds <U32, and real numbers are wanted$"),
            (good.astype(object), "^path: holds object, and real numbers are wanted$"),
            (good > 0, "^path: holds bool, and real numbers are wanted$"),
            ([[0, 0, 0], [1, 2]], "^path: is no array of numbers; its rows have to be of one length$"),
            (object(), "^path: holds object"), ({"t": 0}, "^path: holds object")):
            with self.subTest(sentence):
                self.refused(sentence, scene.touch, path)
                self.refused(sentence, tactum.World(scene).follow, path)
        self.refused("^path: has its own times; leave the rate out", scene.touch, good, rate=500)
        self.refused("^rate: is not from 1 to 1,000,000 Hz$", scene.touch, good[:, 1:], rate=0)
        self.refused("^rate: is not from 1 to 1,000,000 Hz$", scene.touch, good[:, 1:], rate=np.nan)
        self.refused("^path: the scene has none of its own; give rows of t, x, y, z$", scene.touch)
        self.refused("no.csv", scene.touch, "no.csv")

    def test_every_layout_and_real_type_gives_the_same(self):
        scene = plate()
        path = np.round(slide(scene) * 2**20) / 2**20  # exact in single precision
        felt = scene.touch(path).force
        wide = np.zeros((len(path), 8))
        wide[:, ::2] = path
        for same in (path.tolist(), np.asfortranarray(path), wide[:, ::2], path.astype(np.float32),
                     path.astype(">f8"), path.astype(np.longdouble), path[::-1][::-1]):
            np.testing.assert_array_equal(scene.touch(same).force, felt)
        whole = np.array([[0, 0, 1], [0, 0, 0]])
        np.testing.assert_array_equal(scene.touch(whole).force, scene.touch(whole.astype(float)).force)

    def test_steps_that_cannot_be(self):
        world = tactum.World(plate())
        for finger, sentence in (((0, 0), "^finger: has the shape"), ((0, 0, np.nan), "^finger: has a number"),
                                 ((0, 0, 1e9), "^finger: is farther than 1e6 from"), ("here", "^finger: holds <U4"),
                                 (None, "^finger: holds object"), (np.zeros((1, 3)), "^finger: has the shape")):
            self.refused(sentence, world.step, finger)
        for dt in (0, -1e-3, 2, np.nan, np.inf):
            self.refused("^dt: is not from 1e-6 to 1 s$", world.step, (0, 0, 0), dt)
        self.refused("^velocity: has a number", world.step, (0, 0, 0), velocity=(0, 0, np.inf))
        self.assertEqual(world.time, 0)

    def test_meshes_that_are_none(self):
        scene = tactum.Scene()
        for vertices, triangles, sentence in (
            (CORNERS, [[0, 1, 7]], "^triangles: names 7, and there are 4$"),
            (CORNERS, [[0, 1, -1]], "^triangles: names -1, and there are 4$"),
            (CORNERS, [[0.0, 1, 2]], "^triangles: holds float64, and whole numbers are wanted$"),
            (CORNERS, [0, 1, 2], r"^triangles: has the shape \(3,\), and rows of 3 are wanted$"),
            (CORNERS, np.zeros((0, 3), int), "^triangles: has no rows$"),
            (CORNERS[:, :2], TRIANGLES, "^vertices: rows of x, y, z are wanted, at least one$"),
            (np.zeros((0, 3)), TRIANGLES, "^vertices: rows of x, y, z are wanted, at least one$"),
            (CORNERS * np.nan, TRIANGLES, "^vertices: has a number that is not finite$"),
            (CORNERS * 1e9, TRIANGLES, "^vertices: row 0 is farther than 1e6 m from the origin$")):
            with self.subTest(sentence):
                self.refused(sentence, scene.add_mesh, vertices, triangles)
        self.refused("^surfaces: has 3 numbers, and there are 2 triangles$", scene.add_mesh, CORNERS, TRIANGLES,
                     surfaces=[0, 1, 2])
        self.assertEqual(scene.objects, [])

    def test_images_and_values_that_are_none(self):
        scene = plate()
        surface = scene.surfaces[0]
        for image in (np.ones(4), np.ones((0, 4)), np.full((4, 4), np.nan), np.ones((1, 20000)), "brick"):
            self.refused("^image: ", surface.add_layer, "image", image)
        self.refused("^image: is for the source 'image', and only for that$", surface.add_layer, "noise", np.ones((4, 4)))
        self.refused('^source: "stones" is none of image, noise', surface.add_layer, "stones")
        self.assertEqual(surface.layers, [])
        path = slide(scene)
        self.refused("^values: is one row of numbers", scene.sweep, "stiffness", [], path)
        self.refused("^values: is one row of numbers", scene.sweep, "stiffness", [[1, 2]], path)
        self.refused("^stiffness: 0 is not from 1 to 10000 N/m$", scene.sweep, "stiffness", [5, 0], path)
        self.refused('^"stifness" cannot be set here', scene.sweep, "stifness", [5], path)
        self.refused("^where: is of another scene$", scene.sweep, "stiffness", [5], path, where=plate().objects[0])
        self.refused("^where: is an Object, a Surface", scene.sweep, "stiffness", [5], path, where=7)

    def test_numbers_that_are_none(self):
        surface = plate().surfaces[0]
        for value in ("hard", None, [1, 2], 1j):
            self.refused("^stiffness: .* is no number$", setattr, surface, "stiffness", value)
        self.refused("^stiffness: is not finite$", setattr, surface, "stiffness", np.nan)
        self.refused("^sides: \"left\" is none of both, front, back, none$", setattr, surface, "sides", "left")
        self.refused("^shading: is True or False$", setattr, surface, "shading", 1)
        surface.shading, surface.stiffness = np.True_, np.float32(500)


class Files(unittest.TestCase):
    def test_the_sentence_is_the_programs(self):
        for name, sentence in (("nowhere.obj", "nowhere.obj"), ("teapot.png", "teapot.png")):
            with self.assertRaisesRegex(tactum.Error, sentence) as caught:
                tactum.open(SCENES / name)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(tactum.Error, "^unit: \"ft\" is none of m, cm, mm and in$"):
            tactum.open(SCENES / "teapot.obj", unit="ft")

    def test_a_broken_file_breaks_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "half.glb"
            file.write_bytes((SCENES / "teapot.glb").read_bytes()[:5000])
            with self.assertRaisesRegex(tactum.Error, "half.glb"):
                tactum.open(file)

    def test_what_cannot_be_written_is_said(self):
        scene = plate()
        with self.assertRaisesRegex(tactum.Error, "plate.doc: cannot be written by its ending; writable are glb,"):
            scene.convert("plate.doc")
        with self.assertRaisesRegex(tactum.Error, "there is no folder /nowhere; make it"):
            scene.convert("/nowhere/plate.glb")
        with self.assertRaisesRegex(tactum.Error, r"a scene is saved as .glb; convert\(\) writes other formats"):
            scene.save("plate.obj")


if __name__ == "__main__":
    unittest.main(verbosity=2)
