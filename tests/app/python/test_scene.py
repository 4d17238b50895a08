"""A scene in Python without a server: it feels as in the program, and as the formulas say."""
import pathlib
import sys
import tempfile
import unittest
import zipfile

import numpy as np
import tactum
from plates import by_the_program, plate, slide

SCENES = pathlib.Path(sys.argv.pop())


class Felt(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def expect_bits(self, touch, columns):
        np.testing.assert_array_equal(touch.t, columns[:, 0])
        np.testing.assert_array_equal(touch.finger, columns[:, 1:4])
        np.testing.assert_array_equal(touch.proxy, columns[:, 4:7])
        np.testing.assert_array_equal(touch.force, columns[:, 7:10])
        np.testing.assert_array_equal(touch.contacts, columns[:, 10])

    def test_every_sample_gives_its_expected_forces(self):
        """The files beside them have seven decimals."""
        samples = sorted(SCENES.glob("**/*.glb"))
        self.assertGreater(len(samples), 20)
        for sample in samples:
            with self.subTest(sample.stem):
                expected = np.loadtxt(sample.with_suffix(".csv"), delimiter=",", skiprows=1)
                touch = tactum.open(sample).touch()
                self.assertLessEqual(np.abs(touch.force - expected[:, 1:]).max(), 0.501e-7)

    def test_a_bundle_feels_as_it_says(self):
        scene = tactum.open(SCENES / "friction-ladder.glb")
        scene.convert(self.folder / "ladder.tactum")
        with zipfile.ZipFile(self.folder / "ladder.tactum") as bundle:
            expected = np.loadtxt(bundle.open("forces.csv"), delimiter=",", skiprows=1)[:, -3:]
        self.assertGreater(np.abs(expected).max(), 0.1)
        for of in scene, tactum.open(self.folder / "ladder.tactum"):
            self.assertLessEqual(np.abs(of.touch().force - expected).max(), 1e-12)

    def test_the_bits_are_those_of_the_program(self):
        path = np.loadtxt(SCENES / "teapot-finger.csv", delimiter=",", skiprows=1)
        scene = tactum.open(SCENES / "teapot.obj")
        scene.set(static_friction=0.4, dynamic_friction=0.3)
        columns = by_the_program(SCENES / "teapot.obj", path, self.folder, "--static-friction", "0.4",
                                 "--dynamic-friction", "0.3")
        self.assertGreater(np.abs(columns[:, 7:10]).max(), 0.1)
        self.expect_bits(scene.touch(path), columns)
        self.expect_bits(scene.touch(SCENES / "teapot-finger.csv"), columns)

    def test_the_server_gives_the_same_touch(self):
        scene = tactum.open(SCENES / "teapot.glb")
        with tactum.serve() as haptics:
            haptics.open(SCENES / "teapot.glb")
            theirs = haptics.replay(scene.path)
        ours = scene.touch()
        self.assertIs(type(ours), type(theirs))
        for name in ("t", "finger", "proxy", "force", "contacts"):
            np.testing.assert_array_equal(getattr(ours, name), getattr(theirs, name))

    def test_moving_bodies_feel_as_in_the_program(self):
        file = SCENES / "moving" / "windmill.glb"
        scene = tactum.open(file)
        self.expect_bits(scene.touch(), by_the_program(file, scene.path, self.folder))
        self.expect_bits(tactum.World(scene).follow(scene.path), by_the_program(file, scene.path, self.folder))

    def test_a_wall_pushes_with_k_times_depth(self):
        scene = plate(stiffness=400)
        depths = np.linspace(1e-4, 5e-3, 50)
        path = np.column_stack([np.zeros((50, 2)), scene.proxy_radius - depths])
        touch = scene.touch(path, rate=500)
        np.testing.assert_allclose(touch.t, np.arange(50) / 500, rtol=0, atol=0)
        np.testing.assert_allclose(touch.force, 400 * depths[:, None] * [0, 0, 1], rtol=0, atol=1e-9)
        np.testing.assert_array_equal(touch.contacts, 1)

    def test_sliding_friction_is_that_of_coulomb(self):
        scene = plate(stiffness=800, static_friction=0.6, dynamic_friction=0.45)
        force = scene.touch(slide(scene)).force[-200:]
        np.testing.assert_allclose(-force[:, 0] / force[:, 2], 0.45, atol=1e-6)

    def test_a_sweep_is_what_one_value_after_the_other_gives(self):
        scene = plate(stiffness=800)
        path, values = slide(scene), np.linspace(0, 1, 5)
        sweep = scene.sweep("dynamic_friction", values, path)
        self.assertEqual(sweep.force.shape, (5, len(path), 3))
        self.assertEqual(scene.surfaces[0].dynamic_friction, 0)
        for value, force in zip(values, sweep.force):
            one = scene.copy()
            one.set(dynamic_friction=value)
            np.testing.assert_array_equal(force, one.touch(path).force)
        radii = scene.sweep("proxy_radius", [1e-3, 2e-3], path[:, 1:])
        self.assertAlmostEqual(radii.force[1, 199, 2] - radii.force[0, 199, 2], 800 * 1e-3, places=9)

    def test_a_sweep_of_one_surface_leaves_the_others(self):
        scene = plate(stiffness=800)
        scene.add_mesh([[9, 0, 0], [10, 0, 0], [9, 1, 0]], [[0, 1, 2]], name="far")
        path = slide(scene)
        far = scene.sweep("stiffness", [100, 200], path, where=scene["far"])
        np.testing.assert_array_equal(far.force[0], far.force[1])
        near = scene.sweep("stiffness", [100, 200], path, where=scene["plate"].surfaces[0])
        self.assertAlmostEqual(near.force[1, 199, 2], 2 * near.force[0, 199, 2], places=9)


class Kept(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_a_saved_scene_is_the_same_one(self):
        scene = tactum.open(SCENES / "teapot.obj")
        scene.set(stiffness=321, static_friction=0.5, viscosity=2, sides="front", shading=True)
        scene.proxy_radius = 0.002
        scene.objects[0].position = 0.1, 0.2, 0.3
        scene.objects[0].surfaces[0].add_layer("grooves", size=2e-3, strength=1e-4, blend="maximum")
        scene.path = slide(scene)
        scene.save(self.folder / "kept.glb")
        again = tactum.open(self.folder / "kept.glb")
        self.assertEqual(again.proxy_radius, 0.002)
        for before, after in zip(scene.surfaces, again.surfaces):
            for name in tactum.parameters:
                if tactum.parameters[name].of == "surface":
                    self.assertEqual(getattr(before, name), getattr(after, name))
            self.assertEqual((after.sides, after.shading), ("front", True))
        np.testing.assert_array_equal(again.objects[0].position, [0.1, 0.2, 0.3])
        self.assertEqual(again.objects[0].surfaces[0].layers[0].blend, "maximum")
        np.testing.assert_array_equal(again.path, scene.path)
        np.testing.assert_array_equal(again.touch().force, scene.touch().force)

    def test_every_format_is_written_and_says_what_is_lost(self):
        scene = plate(stiffness=500)
        for ending in ("glb", "gltf", "tactum", "x3d", "obj", "ply", "stl", "off"):
            lost = scene.convert(self.folder / f"plate.{ending}")
            self.assertEqual(len(tactum.open(self.folder / f"plate.{ending}").objects), 1, ending)
            if ending in ("glb", "gltf", "tactum"):
                self.assertEqual(lost, [], ending)
        self.assertTrue(any("stiffness" in sentence for sentence in scene.convert(self.folder / "p.stl")))

    def test_units_and_axes_of_a_file_that_says_none(self):
        scene = plate()
        scene.convert(self.folder / "plate.obj")
        small = tactum.open(self.folder / "plate.obj", unit="mm")
        np.testing.assert_allclose(small.bounds, 1e-3 * scene.bounds, atol=1e-15)
        upright = tactum.open(self.folder / "plate.obj", up="z")
        np.testing.assert_allclose(np.ptp(upright.bounds, axis=0), [0.2, 0, 0.2], atol=1e-12)
        fitted = tactum.open(self.folder / "plate.obj", fit=0.5)
        self.assertAlmostEqual(np.linalg.norm(np.ptp(fitted.bounds, axis=0)), 0.5)

    def test_a_mesh_comes_back_as_arrays(self):
        scene = tactum.open(SCENES / "teapot.obj")
        teapot = scene.objects[0]
        vertices, triangles = teapot.vertices, teapot.triangles
        box = np.array([vertices.min(axis=0), vertices.max(axis=0)])
        np.testing.assert_allclose(teapot.bounds, box + teapot.position, atol=1e-12)
        self.assertLess(triangles.max(), len(vertices))
        self.assertEqual(len(teapot.surface_of), len(triangles))
        with self.assertRaises(ValueError):
            vertices[0, 0] = 1
        del scene, teapot
        self.assertTrue(np.isfinite(vertices).all())  # the memory lives as long as the array


class Properties(unittest.TestCase):
    def test_the_parameter_table_makes_them(self):
        surface = plate().surfaces[0]
        of_surface = [parameter for parameter in tactum.parameters.values() if parameter.of == "surface"]
        self.assertIn("static_friction", [parameter.name for parameter in of_surface])
        for parameter in of_surface:
            self.assertEqual(getattr(surface, parameter.name), parameter.initial)
            for value in (parameter.minimum, parameter.maximum):
                setattr(surface, parameter.name, value)
                self.assertEqual(getattr(surface, parameter.name), value)
            self.assertIn(parameter.sentence, getattr(tactum.Surface, parameter.name).__doc__)
            with self.assertRaisesRegex(tactum.Error, f"^{parameter.name}: .* is not from .* to "):
                setattr(surface, parameter.name, parameter.maximum * 1.001)

    def test_dynamic_friction_never_exceeds_static(self):
        surface = plate(static_friction=0.5).surfaces[0]
        surface.dynamic_friction = 0.7
        self.assertEqual(surface.static_friction, 0.7)
        surface.static_friction = 0.2
        self.assertEqual(surface.dynamic_friction, 0.2)

    def test_set_is_all_or_none(self):
        surface = plate(stiffness=500).surfaces[0]
        with self.assertRaisesRegex(tactum.Error, "^viscosity: 51 is not from 0 to 50 N s/m$"):
            surface.set(stiffness=600, viscosity=51)
        with self.assertRaisesRegex(tactum.Error, '^"stifness" cannot be set here; there are name, stiffness,'):
            surface.set(stifness=600)
        self.assertEqual(surface.stiffness, 500)

    def test_what_is_gone_says_so(self):
        scene = plate()
        plate_, surface = scene.objects[0], scene.surfaces[0]
        scene.remove(plate_)
        for gone in (lambda: surface.stiffness, lambda: plate_.position, lambda: scene.remove(plate_)):
            with self.assertRaisesRegex(tactum.Error, "^object 1 is not in the scene any more$"):
                gone()

    def test_a_texture_is_felt_and_comes_back(self):
        scene = plate(stiffness=800)
        wave = np.tile(0.5 + 0.5 * np.sin(np.linspace(0, 2 * np.pi, 64, endpoint=False)), (64, 1))
        layer = scene.surfaces[0].add_layer("image", wave, size=2e-3, strength=2e-4, mapping="planar")
        np.testing.assert_allclose(layer.image, wave, atol=1e-5)
        force = scene.touch(slide(scene)).force[-200:, 0]
        self.assertGreater(np.ptp(force), 0.05)
        layer.enabled = False
        np.testing.assert_allclose(scene.touch(slide(scene)).force[-200:, 0], 0, atol=1e-9)
        with self.assertRaisesRegex(tactum.Error, "^strength: 0.5 is not from -0.01 to 0.01 m$"):
            layer.strength = 0.5
        layer.target = "stiffness"
        layer.strength = 0.5
        scene.surfaces[0].remove_layer(0)
        with self.assertRaisesRegex(tactum.Error, "^layer 0 is not on its surface any more$"):
            layer.size

    def test_presets_by_name_by_file_and_by_themselves(self):
        self.assertIn("cork", tactum.presets())
        cork = tactum.Preset("cork")
        self.assertLessEqual(set(cork.values), set(tactum.parameters))
        for given in ("cork", cork, pathlib.Path(tactum.__file__).parent / "presets" / "cork.tactum-preset"):
            surface = plate(viscosity=1).surfaces[0]
            surface.apply(given)
            for name, value in cork.values.items():
                self.assertEqual(getattr(surface, name), value)
        with self.assertRaisesRegex(tactum.Error, 'there is no preset "crok"; tactum.presets'):
            tactum.Preset("crok")


if __name__ == "__main__":
    unittest.main(verbosity=2)
