"""Painted layers and masks: what is painted on a vertex is felt there, linear in between."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np
import tactum
from plates import CORNERS, plate

sys.argv.pop()  # the samples
DEPTH, STIFFNESS = 1e-3, 400.0  # m, N/m
RIGHT = (CORNERS[:, 0] + 0.1) / 0.2  # 0 at the left edge of the plate, 1 at the right one
PLACES = np.array([-0.08, -0.03, 0.001, 0.04, 0.09])


def felt(scene, places=PLACES):
    """The factor of the stiffness at places along x."""
    path = np.column_stack([places, np.full_like(places, 0.02), np.full_like(places, scene.proxy_radius - DEPTH)])
    factors = []
    for point in path:
        world = tactum.World(scene)
        world.step((point[0], point[1], 0.01))
        factors.append(world.step(point, velocity=(0, 0, 0)).force[2] / (STIFFNESS * DEPTH))
    return np.array(factors)


class Painted(unittest.TestCase):
    def setUp(self):
        self.scene = plate(stiffness=STIFFNESS)
        self.surface = self.scene.surfaces[0]

    def expect(self, values):
        """Of the layer's strength, which is 1: at each of PLACES."""
        np.testing.assert_allclose(felt(self.scene), 1 + values, rtol=0, atol=1e-5)

    def test_a_layer_is_what_is_painted(self):
        layer = self.surface.add_layer("painted", paint=RIGHT, target="stiffness", strength=1)
        np.testing.assert_array_equal(layer.paint, RIGHT.astype(np.float32))
        self.assertEqual((layer.source, layer.image, layer.mask), ("painted", None, None))
        self.expect((PLACES + 0.1) / 0.2)
        layer.paint = 1 - RIGHT
        self.expect(1 - (PLACES + 0.1) / 0.2)

    def test_a_painted_mask_says_where_a_layer_counts(self):
        layer = self.surface.add_layer("painted", paint=np.ones(4), mask=RIGHT, target="stiffness", strength=1)
        self.expect((PLACES + 0.1) / 0.2)
        self.assertEqual((layer.mask.source, layer.mask.image), ("painted", None))
        layer.mask.paint = 0.25 * np.ones(4)
        self.expect(0.25)
        layer.set_mask(None)
        self.assertIsNone(layer.mask)
        self.expect(1)

    def test_a_picture_is_a_mask(self):
        halves = np.zeros((8, 64))
        halves[:, 32:] = 1
        layer = self.surface.add_layer("painted", paint=np.ones(4), target="stiffness", strength=1)
        layer.set_mask(halves, mapping="planar", size=0.2)
        np.testing.assert_array_equal(layer.mask.image, halves)
        self.assertEqual((layer.mask.mapping, layer.mask.size, layer.mask.paint), ("planar", 0.2, None))
        wide = felt(self.scene, np.array([-0.05, 0.05]))
        np.testing.assert_allclose(sorted(wide), [1, 2], atol=1e-3)

    def test_a_mask_lies_as_its_layer(self):
        layer = self.surface.add_layer("grooves", mask=np.full((2, 2), 0.5), mapping="planar", size=0.004, rotation=0.5)
        for name in ("mapping", "size", "rotation", "offset_u"):
            self.assertEqual(getattr(layer.mask, name), getattr(layer, name))
        layer.set_mask("noise", size=0.02)
        self.assertEqual((layer.mask.source, layer.mask.size, layer.size), ("noise", 0.02, 0.004))
        layer.mask.set(octaves=2, seed=7)
        self.assertEqual((layer.mask.octaves, layer.mask.seed), (2, 7))

    def test_it_is_kept_in_a_file(self):
        self.surface.add_layer("painted", paint=RIGHT, mask=1 - RIGHT, target="stiffness", strength=1)
        with tempfile.TemporaryDirectory() as folder:
            self.scene.save(pathlib.Path(folder) / "kept.glb")
            again = tactum.open(pathlib.Path(folder) / "kept.glb")
        layer, = again.surfaces[0].layers
        for paint in (layer.paint, 1 - layer.mask.paint):
            order = np.argsort(again.objects[0].vertices[:, 0], kind="stable")
            np.testing.assert_allclose(np.unique(paint[order]), [0, 1])
        np.testing.assert_allclose(felt(again), felt(self.scene), atol=1e-9)

    def test_what_cannot_be_is_said(self):
        add, words = self.surface.add_layer, {"target": "stiffness"}
        for sentence, call in (
                (r"^paint: has the shape \(3,\), and a value for each of the 4 vertices is wanted$",
                 lambda: add("painted", paint=np.ones(3))),
                (r"^paint: has the shape \(2, 2\), ", lambda: add("painted", paint=np.ones((2, 2)))),
                ("^paint: is for the source 'painted', and only for that$", lambda: add("noise", paint=np.ones(4))),
                ("^paint: is for the source 'painted', and only for that$", lambda: add("painted", **words)),
                ("^image: is for the source 'image', and only for that$", lambda: add("painted", np.ones((2, 2)))),
                (r"^mask: has the shape \(5,\), ", lambda: add(mask=np.ones(5))),
                ("^mask: is an array of rows and columns", lambda: add(mask=np.ones((2, 2, 2)))),
                ("^mask: has a number that is not finite$", lambda: add(mask=np.full(4, np.nan))),
                ("^image: is for the source 'image'", lambda: add(mask="image")),
                ('^source: "stones" is none of image, noise', lambda: add(mask="stones"))):
            with self.subTest(sentence), self.assertRaisesRegex(tactum.Error, sentence) as caught:
                call()
            self.assertNotIn("\n", str(caught.exception))
        self.assertEqual(self.surface.layers, [])
        layer = add("noise", mask=np.ones(4))
        mask = layer.mask
        with self.assertRaisesRegex(tactum.Error, "^paint: is for the source 'painted', and only for that$"):
            layer.paint = np.ones(4)
        layer.set_mask(None)
        with self.assertRaisesRegex(tactum.Error, "^the layer has no mask any more$"):
            mask.size


if __name__ == "__main__":
    unittest.main(verbosity=2)
