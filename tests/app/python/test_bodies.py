"""Bodies and joints in Python: made, read and moved as the formulas say."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np
import tactum
from plates import box, plate

SCENES = pathlib.Path(sys.argv.pop())
G = 9.81  # m/s^2
AWAY = (0, 9, 0)  # where the finger touches nothing
NUMBERS = ("low", "high", "spring", "rest", "damping", "friction", "speed", "strength", "spacing", "detent")


def block(mass=0.2, gravity=(0, -G, 0)):
    """A scene of a block of 20 x 20 x 20 mm about the origin, which is a loose body, and that body."""
    scene = tactum.Scene()
    scene.gravity = gravity
    body = scene.add_mesh(*box([-0.01] * 3, [0.01] * 3), name="block").make_body()
    body.mass = mass
    return scene, body


def after(scene, body, seconds, finger=AWAY):
    """Its Reading after so many steps of a millisecond, and the last Step."""
    world = tactum.World(scene)
    for _ in range(round(1e3 * seconds)):
        step = world.step(finger)
    return world.reading(body), step


class Moved(unittest.TestCase):
    def test_a_loose_body_falls(self):
        scene, body = block()
        self.assertEqual((body.joints, scene["block"].body, scene.bodies), ([], body, [body]))
        reading, step = after(scene, body, 0.1)
        place, = step.places.values()
        np.testing.assert_allclose(place.position, [0, -0.5 * G * 0.1**2, 0], atol=1e-9)
        np.testing.assert_allclose(place.rotation, [1, 0, 0, 0], atol=1e-12)
        self.assertEqual((list(step.places), reading.value, reading.force), ([scene["block"].id], None, None))
        self.assertAlmostEqual(reading.kinetic, 0.5 * 0.2 * (G * 0.1)**2, places=9)
        self.assertAlmostEqual(reading.kinetic + reading.potential, 0, places=9)

    def test_it_falls_as_it_is_told(self):
        scene, body = block()
        body.set(gravity_factor=0.5, velocity=(0.3, 0, 0))
        _, step = after(scene, body, 0.1)
        np.testing.assert_allclose(step.places[scene["block"].id].position, [0.03, -0.25 * G * 0.1**2, 0], atol=1e-9)

    def test_a_spring_bears_a_weight(self):
        scene, body = block()
        body.add_joint("slider", at=(0, 0, 0), axis=(0, 1, 0), spring=500, damping=20)
        reading, step = after(scene, body, 2)
        self.assertAlmostEqual(reading.value, -0.2 * G / 500, places=9)
        self.assertAlmostEqual(reading.force, 0.2 * G, places=6)
        self.assertAlmostEqual(reading.rate, 0, places=9)
        self.assertAlmostEqual(step.places[scene["block"].id].position[1], reading.value, places=12)

    def test_a_hinge_turns_about_its_axis(self):
        scene, body = block(gravity=(0, 0, 0))
        body.add_joint("hinge", at=(0.01, 0, 0), axis=(0, 0, 2), spring=0.5, rest=0.7, damping=0.02)
        reading, step = after(scene, body, 2)
        self.assertAlmostEqual(reading.value, 0.7, places=9)
        place = step.places[scene["block"].id]
        np.testing.assert_allclose(place.rotation, [np.cos(0.35), 0, 0, np.sin(0.35)], atol=1e-9)
        np.testing.assert_allclose(place.position, [0.01 - 0.01 * np.cos(0.7), -0.01 * np.sin(0.7), 0], atol=1e-9)

    def test_a_detent_holds_what_it_says(self):
        for part, holds in ((1.05, True), (0.95, False)):
            scene, body = block()
            body.add_joint("slider", at=(0, 0, 0), axis=(0, 1, 0), spacing=0.01, detent=part * 0.2 * G, damping=50)
            reading, _ = after(scene, body, 1)
            self.assertEqual(-0.005 < reading.value, holds, part)

    def test_a_stop_a_motor_and_friction(self):
        scene, body = block()
        joint = body.add_joint("slider", at=(0, 0, 0), axis=(0, 1, 0), low=-0.02, damping=0)
        self.assertAlmostEqual(after(scene, body, 1)[0].value, -0.02, places=5)
        joint.set(low=-1, friction=1.01 * 0.2 * G)
        self.assertAlmostEqual(after(scene, body, 1)[0].value, 0, places=6)
        scene.gravity = 0, 0, 0
        joint.set(friction=0, speed=0.05, strength=2)
        self.assertAlmostEqual(after(scene, body, 1)[0].rate, 0.05, places=4)

    def test_the_finger_pushes_and_feels_it(self):
        scene, body = block(gravity=(0, 0, 0))
        body.add_joint("slider", at=(0, 0, 0), axis=(0, 0, 1), spring=200, damping=2)
        scene.set(stiffness=800)
        world, radius = tactum.World(scene), scene.proxy_radius
        for z in np.concatenate([np.linspace(0.02, 0.005, 400), np.full(2000, 0.005)]):
            step = world.step((0, 0, z))
        pressed = 0.01 + radius - 0.005  # two springs in a row
        self.assertAlmostEqual(step.force[2], pressed / (1 / 800 + 1 / 200), places=6)
        self.assertAlmostEqual(world.reading(body).value, -step.force[2] / 200, places=8)

    def test_one_body_carries_another(self):
        scene, below = block()
        above = scene.add_mesh(*box([-0.01, 0.02, -0.01], [0.01, 0.04, 0.01]), name="above").make_body()
        below.add_joint("slider", at=(0, 0, 0), axis=(0, 1, 0), spring=5000, damping=20)
        joint = above.add_joint("slider", to=below, at=(0, 0, 0), axis=(0, 1, 0), spring=1000, damping=10)
        above.mass = 0.1
        self.assertEqual((joint.to, joint.body, joint.kind, below.joints[0].to), (below, above, "slider", None))
        self.assertAlmostEqual(after(scene, below, 2)[0].value, -0.3 * G / 5000, places=8)
        self.assertAlmostEqual(after(scene, above, 2)[0].value, -0.1 * G / 1000, places=8)

    def test_an_edit_of_a_joint_is_felt_without_a_jump(self):
        scene, body = block()
        joint = body.add_joint("slider", at=(0, 0, 0), axis=(0, 1, 0), spring=500, damping=20)
        world = tactum.World(scene)
        for _ in range(2000):
            world.step(AWAY)
        before = world.reading(body).value
        joint.spring = 1000
        world.update(scene)
        world.step(AWAY)
        self.assertAlmostEqual(world.reading(body).value, before, places=4)
        for _ in range(2000):
            world.step(AWAY)
        self.assertAlmostEqual(world.reading(body).value, before / 2, places=9)

    def test_a_recording_of_them_plays_as_the_same_bits(self):
        scene, body = block(gravity=(0, 0, 0))
        joint = body.add_joint("slider", at=(0, 0, 0), axis=(0, 0, 1), spring=200, damping=2)
        world = tactum.World(scene, record=True)
        for row, z in enumerate(np.linspace(0.02, 0.005, 1500)):
            world.step((0, 0, z))
            if row == 1200:
                joint.spring = 400
                world.update(scene)
        self.assertLess(world.reading(body).value, -0.003)
        with tempfile.TemporaryDirectory() as folder:
            world.save(pathlib.Path(folder) / "pushed.tactum-recording")
            self.assertEqual(tactum.play(pathlib.Path(folder) / "pushed.tactum-recording").differ, 0)
        world.restart()
        self.assertEqual(world.reading(body).value, 0)


class Read(unittest.TestCase):
    def test_a_sample_tells_its_joints(self):
        scene = tactum.open(SCENES / "moving" / "cabinet.glb")
        door = scene["door"].body
        self.assertEqual(door.objects, [scene["door"]])
        self.assertEqual([joint.kind for joint in door.joints], ["hinge"])
        hinge = door.joints[0]
        self.assertGreater(hinge.spacing, 0)
        self.assertGreater(hinge.detent, 0)
        self.assertAlmostEqual(np.linalg.norm(hinge.axis), 1)
        kinds = {joint.kind for body in scene.bodies for joint in body.joints}
        self.assertEqual(kinds, {"hinge", "slider"})

    def test_every_joint_of_every_sample_can_be_read(self):
        kinds = set()
        for sample in sorted((SCENES / "moving").glob("*.glb")):
            for body in tactum.open(sample).bodies:
                self.assertEqual(body.centre.shape, (3,))
                for joint in body.joints:
                    kinds.add(joint.kind)
                    if joint.kind == "other":
                        with self.assertRaisesRegex(tactum.Error, "is neither hinge, slider nor path; remove it"):
                            joint.low
                    else:
                        self.assertTrue(all(isinstance(getattr(joint, name), float) for name in NUMBERS))
        self.assertEqual(kinds, {"hinge", "slider", "path", "other"})

    def test_a_saved_scene_has_the_same_bodies(self):
        scene, body = block()
        values = dict(low=-0.5, high=0.25, spring=1, rest=0.1, damping=0.01, friction=0.02, speed=3, strength=0.5, spacing=0.2,
                      detent=0.04)
        body.add_joint("hinge", at=(0.01, 0, 0), axis=(0, 0, 1), **values)
        with tempfile.TemporaryDirectory() as folder:
            scene.save(pathlib.Path(folder) / "kept.glb")
            again = tactum.open(pathlib.Path(folder) / "kept.glb")
        joint, = again.bodies[0].joints
        for name in NUMBERS:
            self.assertAlmostEqual(getattr(joint, name), values[name], places=6, msg=name)
        self.assertAlmostEqual(again.bodies[0].mass, 0.2, places=6)
        np.testing.assert_allclose(again.gravity, [0, -G, 0], atol=1e-6)

    def test_a_stop_at_the_end_of_its_range_is_none(self):
        _, body = block()
        joint = body.add_joint("hinge")
        self.assertEqual((joint.low, joint.high), (-np.inf, np.inf))
        joint.set(low=-1, high=1)
        self.assertEqual((joint.low, joint.high), (-1, 1))
        joint.low, joint.high = -np.inf, 2 * np.pi
        self.assertEqual((joint.low, joint.high), (-np.inf, np.inf))

    def test_mass_and_moments_change_together(self):
        _, body = block(mass=0.2)
        before = body.inertia
        np.testing.assert_allclose(before, 0.2 / 6 * 0.02**2, rtol=1e-9)  # of a cube
        body.mass = 0.6
        np.testing.assert_allclose(body.inertia, 3 * before, rtol=1e-12)


class Gone(unittest.TestCase):
    def refused(self, sentence, call, *arguments, **words):
        with self.assertRaisesRegex(tactum.Error, sentence) as caught:
            call(*arguments, **words)
        self.assertNotIn("\n", str(caught.exception))

    def test_what_is_taken_away_says_so(self):
        scene, body = block()
        first, second = body.add_joint("slider"), body.add_joint("hinge")
        first.remove()
        self.assertEqual([joint.kind for joint in body.joints], ["hinge"])
        self.refused("^joint 1 is not on its body any more$", second.set, low=-1)
        world = tactum.World(scene)
        self.assertEqual(world.reading(body).value, 0)
        body.make_still()
        self.assertEqual((scene["block"].body, scene.bodies), (None, []))
        for call in (body.make_still, lambda: body.mass, lambda: body.joints, lambda: first.kind):
            self.refused("^body 1 is not in the scene any more$", call)
        world.update(scene)
        self.refused("^body 1 is moved by no force in this World$", world.reading, body)
        self.assertEqual(world.step(AWAY).places, {})

    def test_what_cannot_be_is_said(self):
        scene, body = block()
        self.refused('^"block" moves with a body already$', scene["block"].make_body)
        self.refused("moves by its keys", tactum.open(self.keyed()).objects[0].make_body)
        self.refused('^kind: "rope" is neither hinge nor slider$', body.add_joint, "rope")
        self.refused("^to: is the body itself$", body.add_joint, to=body)
        self.refused("^to: is of another scene$", body.add_joint, to=block()[1])
        self.refused("^axis: has no length that says a direction$", body.add_joint, axis=(0, 0, 0))
        self.refused("^high: 7 is not from 0 to 6.28", body.add_joint, high=7)
        self.refused("^high: is not finite$", body.add_joint, high=-np.inf)
        self.refused('^"stiffness" cannot be set here; there are at, axis, low', body.add_joint, stiffness=7)
        self.assertEqual(body.joints, [])
        self.refused("^mass: 0 is not from 1e-12 to 1e", setattr, body, "mass", 0)
        self.refused("^velocity: has the shape", setattr, body, "velocity", 3)
        self.refused("^body 1 is moved by no force", tactum.World(plate()).reading, body)

    def keyed(self):
        """A glTF of one triangle that moves by keys."""
        import base64
        import json
        import struct
        data = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + struct.pack("<2f", 0, 1) + struct.pack("<6f", 0, 0, 0, 1, 0, 0)
        views = [{"buffer": 0, "byteOffset": o, "byteLength": n} for o, n in ((0, 36), (36, 8), (44, 24))]
        accessors = [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                     {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
                     {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}]
        animation = {"samplers": [{"input": 1, "output": 2}],
                     "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}
        gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "leaf"}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "animations": [animation],
                "accessors": accessors, "bufferViews": views,
                "buffers": [{"byteLength": len(data),
                             "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = pathlib.Path(folder.name) / "keyed.gltf"
        file.write_text(json.dumps(gltf))
        return file


if __name__ == "__main__":
    unittest.main(verbosity=2)
