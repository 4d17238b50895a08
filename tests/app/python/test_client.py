"""The Python client against a server of its own: what it sends is there, what it is refused it says."""
import pathlib
import subprocess
import sys
import time
import unittest

import numpy as np
import tactum
import tactum_pb2 as pb

PLATE = (0.1 * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], dtype=float), [[0, 1, 2], [0, 2, 3]])
STIFFNESS = 400.0


class Client(unittest.TestCase):
    def setUp(self):
        self.haptics = tactum.serve(rate=250)
        self.addCleanup(self.haptics.close)

    def press(self):
        plate = self.haptics.add_mesh(*PLATE)
        self.haptics.material(object=plate, stiffness=STIFFNESS)
        self.haptics.arm()
        self.haptics.lead_hand((0, 0, -0.01))
        # The hand's own spring of 250 N/m against the plate's.
        depth = (0.01 + 1e-3) * 250 / (250 + STIFFNESS)
        return self.haptics.until(lambda s: s.gain == 1 and abs(s.force[2] - STIFFNESS * depth) < 0.01, patience=60)

    def test_a_mesh_is_felt_and_described(self):
        state = self.press()
        self.assertEqual(state.contacts, 1)
        self.assertAlmostEqual(state.proxy[2], 1e-3, places=9)
        scene = self.haptics.describe()
        self.assertEqual([o.triangles for o in scene.object], [2])
        self.assertEqual(scene.object[0].surface[0].stiffness, STIFFNESS)
        self.assertIn(pb.Event.TOUCH, [event.kind for event in self.haptics.events()])

    def test_each_of_two_hands_is_told(self):
        with tactum.serve(device=["simulated", "simulated"], rate=250) as haptics:
            self.assertEqual([device.name for device in haptics.devices], 2 * [haptics.welcome.device.name])
            haptics.material(object=haptics.add_mesh(*PLATE), stiffness=STIFFNESS)
            haptics.arm()
            goals = (-0.01, -0.005)
            for hand, goal in enumerate(goals):
                haptics.lead_hand((0.02 * hand, 0, goal), hand=hand)
            wanted = [STIFFNESS * (1e-3 - goal) * 250 / (250 + STIFFNESS) for goal in goals]
            state = haptics.until(lambda s: all(hand.gain == 1 and abs(hand.force[2] / force - 1) < 0.02
                                                for hand, force in zip(s.hands, wanted)), patience=60)
            self.assertEqual(len(state.hands), 2)
            self.assertAlmostEqual(state.hands[1].finger[0], 0.02, places=6)
            self.assertEqual(state.hands[1].device.name, haptics.devices[1].name)
            touched = {event.hand for event in haptics.events() if event.kind == pb.Event.TOUCH}
            self.assertEqual(touched, {0, 1})
            haptics.arm(False, hand=1)
            state = haptics.until(lambda s: not np.any(s.hands[1].force), patience=60)
            self.assertTrue(state.armed)
            with self.assertRaisesRegex(tactum.Error, "only a simulated hand"):
                haptics.lead_hand((0, 0, 0), hand=2)
            with self.assertRaisesRegex(tactum.Error, "there is no hand 7"):
                haptics.arm(hand=7)
            for none in (-1, "x", 1.5):
                with self.assertRaisesRegex(tactum.Error, "no number of a hand"):
                    haptics.arm(hand=none)

    def test_stop_ends_the_force(self):
        self.press()
        self.haptics.stop()
        self.assertFalse(self.haptics.until(lambda s: not np.any(s.force)).armed)

    def test_a_push_is_felt_within_its_bound_and_fades(self):
        before = self.press()
        pushed = None
        end = time.monotonic() + 60
        while time.monotonic() < end:
            self.haptics.push((0, 0, 50))  # the server allows 1 N
            state = self.haptics.state()
            if abs(state.force[2] - STIFFNESS * (state.proxy[2] - state.finger[2]) - 1) < 0.02:
                pushed = state
                break
            time.sleep(0.02)
        self.assertIsNotNone(pushed)
        self.haptics.until(lambda s: abs(s.force[2] - before.force[2]) < 0.01, patience=60)

    def test_textures_that_are_none(self):
        for image, size in ((np.ones(4), 0.01), (np.full((4, 4), np.nan), 0.01), (np.ones((4, 4)), 0),
                            (np.ones((4, 4)), np.inf), (np.ones((0, 4)), 0.01), (np.ones((2000, 2000)), 0.01)):
            with self.assertRaises(tactum.Error):
                self.haptics.texture(image, 1e-4, size)
        self.assertEqual(self.haptics.describe().revision, 1)

    def test_a_server_that_is_gone_is_said(self):
        self.haptics.state()
        self.haptics._process.kill()
        with self.assertRaisesRegex(tactum.Error, "is not there any more: connect to it anew"):
            while True:
                self.haptics.state()
                time.sleep(0.01)
        with self.assertRaisesRegex(tactum.Error, "is not there any more"):
            self.haptics.material(stiffness=300)
        self.haptics.close()
        with self.assertRaisesRegex(tactum.Error, "closed: connect anew"):
            self.haptics.describe()

    def test_its_server_ends_with_the_program(self):
        words = "import tactum, os; print(tactum.serve()._process.pid, flush=True); os.kill(os.getpid(), 9)"
        died = subprocess.run([sys.executable, "-c", words], stdout=subprocess.PIPE, text=True)
        server = pathlib.Path("/proc") / died.stdout.strip()
        end = time.monotonic() + 60
        while server.exists() and "Z" not in (server / "stat").read_text().rsplit(")", 1)[1]:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)

    def test_what_cannot_be_is_said_at_once(self):
        for rate in (-5, 0, np.nan, 5000):
            with self.assertRaisesRegex(tactum.Error, "1 to 1000 Hz"):
                tactum.connect("127.0.0.1:1", rate=rate)
        with self.assertRaisesRegex(tactum.Error, "cannot be started"):
            tactum.serve(program="/nowhere/tactum")
        with self.assertRaisesRegex(tactum.Error, "no haptic server answers at 127.0.0.1:1: see whether"):
            tactum.connect("127.0.0.1:1", patience=0.5)

    def test_refusals_are_sentences(self):
        with self.assertRaisesRegex(tactum.Error, "there is no object 99"):
            self.haptics.move(99, (0, 0, 0))
        with self.assertRaisesRegex(tactum.Error, "a corner that there is not"):
            self.haptics.add_mesh(PLATE[0], [[0, 1, 7]])
        with self.assertRaisesRegex(tactum.Error, "times of a path"):
            self.haptics.replay(np.zeros((2, 4)))
        with self.assertRaisesRegex(tactum.Error, "has the pen"):
            with tactum.connect(self.haptics._target, name="second") as second:
                second.material(stiffness=300)

    def test_both_widths_and_all_parts_of_a_mesh(self):
        positions, triangles = PLATE
        normals = np.tile([0, 0, 1.0], (2, 3, 1))
        uvs = np.zeros((2, 3, 2))
        number = self.haptics.add_mesh(positions.astype(np.float32), triangles, normals=normals, uvs=uvs,
                                       surfaces=[0, 1], position=(0, 0, 0.5), name="two")
        scene = self.haptics.describe()
        self.assertEqual([(o.id, o.name, len(o.surface)) for o in scene.object], [(number, "two", 2)])
        self.assertEqual(scene.object[0].pose.position.z, 0.5)

    def test_a_server_that_is_gone_is_told(self):
        self.haptics._process.kill()
        with self.assertRaises(tactum.Error):
            self.haptics.until(lambda s: False, patience=30)
        self.assertFalse(self.haptics.alive)


if __name__ == "__main__":
    unittest.main(verbosity=2)
