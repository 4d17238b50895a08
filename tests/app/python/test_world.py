"""A World that Python steps: alone, in threads, and recorded."""
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np
import tactum
from plates import plate, slide

SCENES = pathlib.Path(sys.argv.pop())


class Stepping(unittest.TestCase):
    def test_step_by_step_is_a_touch(self):
        scene = tactum.open(SCENES / "friction-ladder.glb")
        touch = scene.touch()
        world, path = tactum.World(scene), scene.path
        dts = np.concatenate([[1e-3], np.diff(path[:, 0])])
        for row, (dt, point) in enumerate(zip(dts, path[:, 1:])):
            step = world.step(point, dt)
            self.assertTrue((step.force == touch.force[row]).all() and (step.proxy == touch.proxy[row]).all(), row)
            self.assertEqual(len(step.contacts), touch.contacts[row])
        self.assertAlmostEqual(world.time, path[-1, 0] - path[0, 0] + 1e-3)

    def test_a_contact_says_what_is_touched(self):
        scene = plate(stiffness=400, static_friction=0.5)
        world = tactum.World(scene)
        self.assertEqual(world.step((0, 0, 0.01)).contacts, [])
        world.step((0, 0, 0.0005))
        step = world.step((0.002, 0, 0))
        contact, = step.contacts
        np.testing.assert_allclose(contact.normal, [0, 0, 1], atol=1e-12)
        self.assertAlmostEqual(contact.normal_force, 400 * 1e-3, places=9)
        self.assertEqual((contact.object, contact.surface, contact.slipping), (scene.objects[0].id, 0, True))

    def test_an_edit_is_felt_without_a_jump(self):
        scene = plate(stiffness=400, static_friction=1)
        world = tactum.World(scene)
        world.step((0, 0, 0.01))
        held = world.step((0, 0, -0.001)), world.step((0.0005, 0, -0.001))
        scene.set(stiffness=800)
        world.update(scene)
        after = world.step((0.0005, 0, -0.001))
        np.testing.assert_allclose(after.proxy, held[1].proxy, atol=1e-12)  # it still sticks where it did
        np.testing.assert_allclose(after.force, 2 * held[1].force, atol=1e-9)

    def test_damping_wants_a_velocity(self):
        world = tactum.World(plate(stiffness=400, damping=2))
        world.step((0, 0, 0.0009))
        pressed = world.step((0, 0, 0.0009), velocity=(0, 0, -0.1))
        self.assertAlmostEqual(pressed.force[2], 400 * 1e-4 + 2 * 0.1, places=9)

    def test_a_path_goes_on_where_the_last_one_ended(self):
        scene = plate(stiffness=700, static_friction=0.3)
        path, world = slide(scene), tactum.World(scene)
        halves = world.follow(path[:300]), world.follow(path[300:])
        whole = scene.touch(path)
        np.testing.assert_array_equal(np.concatenate([half.force for half in halves]), whole.force)
        with self.assertRaisesRegex(tactum.Error, "begins before the World's time"):
            world.follow(path)
        world.restart()
        np.testing.assert_array_equal(world.follow(path).force, whole.force)


class Threads(unittest.TestCase):
    def test_python_goes_on_while_a_path_is_followed(self):
        scene = tactum.open(SCENES / "teapot.glb")
        path = scene.path
        long = np.column_stack([np.arange(40 * len(path)) * 1e-3, np.tile(path[:, 1:], (40, 1))])
        times, over = [], threading.Event()

        def watch():
            while not over.is_set():
                times.append(time.perf_counter())
                time.sleep(0.001)

        watcher = threading.Thread(target=watch)
        watcher.start()
        world = tactum.World(scene)
        begin = time.perf_counter()
        world.follow(long)
        end = time.perf_counter()
        over.set()
        watcher.join()
        gap = np.diff([begin] + [t for t in times if begin < t < end] + [end]).max()
        print(f"{len(long)} steps in {end - begin:.3f} s, another thread waited for {1e3 * gap:.1f} ms at most")
        self.assertLess(gap, 0.5 * (end - begin))

    def test_two_threads_step_a_world_each(self):
        scene = tactum.open(SCENES / "teapot.glb")
        expected, done = scene.touch(), [0, 0]
        both = threading.Barrier(2, timeout=60)

        def go(which):
            world = tactum.World(scene)
            for row, point in enumerate(scene_path):
                if row % 100 == 0:
                    both.wait()  # neither is done before the other is under way
                step = world.step(point, dts[row])
                if not (step.force == expected.force[row]).all():
                    return both.abort()
                done[which] = row + 1

        scene_path = scene.path[:, 1:]
        dts = np.concatenate([[1e-3], np.diff(scene.path[:, 0])])
        threads = [threading.Thread(target=go, args=(which,)) for which in (0, 1)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(done, [len(scene_path)] * 2)

    def test_one_world_in_two_threads_is_refused_not_broken(self):
        scene = tactum.open(SCENES / "teapot.glb")
        path = scene.path
        long = np.column_stack([np.arange(40 * len(path)) * 1e-3, np.tile(path[:, 1:], (40, 1))])
        world = tactum.World(scene)
        worker = threading.Thread(target=world.follow, args=(long,))
        worker.start()
        refused = 0
        while worker.is_alive():
            try:
                world.time
            except tactum.Error as error:
                self.assertIn("is being stepped by another thread", str(error))
                refused += 1
            time.sleep(0.001)
        self.assertGreater(refused, 0)

    def test_ctrl_c_ends_a_long_touch(self):
        words = """
import signal, sys, threading, time
import numpy as np, tactum
scene = tactum.open(sys.argv[1])
path = scene.path
many = 2000
long = np.column_stack([np.arange(many * len(path)) * 1e-3, np.tile(path[:, 1:], (many, 1))])
def press():
    global pressed
    pressed = time.perf_counter()
    signal.raise_signal(signal.SIGINT)
threading.Timer(0.5, press).start()
try:
    scene.touch(long)
except KeyboardInterrupt:
    print("ended" if time.perf_counter() - pressed < 5 else "late")
"""
        ended = subprocess.run([sys.executable, "-c", words, SCENES / "teapot.glb"], stdout=subprocess.PIPE, text=True,
                               timeout=120)
        self.assertEqual(ended.stdout, "ended\n")


class Recorded(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "steps.tactum-recording"

    def record(self):
        scene = plate(stiffness=700, static_friction=0.4)
        world = tactum.World(scene, record=True)
        path = slide(scene, way=0.1)  # 2.2 s: with states on the way
        first = world.follow(path[:1000])
        scene.set(stiffness=300)
        world.update(scene)
        second = world.follow(path[1000:])
        world.save(self.file, reason="to be played")
        return np.concatenate([first.force, second.force])

    def test_a_recording_plays_as_the_same_bits(self):
        felt = self.record()
        recording = tactum.play(self.file)
        self.assertEqual((recording.differ, recording.first_difference, recording.servo_ticks), (0, "", 0))
        self.assertEqual((recording.reason, recording.device), ("to be played", "a script in Python"))
        np.testing.assert_array_equal(recording.touch.force, felt)
        self.assertEqual([scene.surfaces[0].stiffness for scene in recording.scenes], [700, 300])

    def test_the_program_plays_it(self):
        felt = self.record()
        played = subprocess.run([os.environ["TACTUM"], "play", self.file], check=True, stdout=subprocess.PIPE, text=True)
        self.assertIn(f"{len(felt)} steps, 0 differ", played.stdout)

    def test_what_is_no_recording_is_said(self):
        self.file.write_bytes(b"none")
        with self.assertRaisesRegex(tactum.Error, "^steps.tactum-recording: is no recording of Tactum; choose a file"):
            tactum.play(self.file)
        with self.assertRaisesRegex(tactum.Error, "^this World does not record; make it with record=True$"):
            tactum.World(plate()).save(self.file)

    def test_only_the_last_minute_is_kept(self):
        scene = plate()
        world = tactum.World(scene, record=True)
        t = np.arange(20000) * 0.01  # 200 s
        path = np.column_stack([t, np.zeros((len(t), 2)), 1e-3 * np.sin(t)])
        felt = world.follow(path)
        world.save(self.file)
        touch = tactum.play(self.file).touch
        self.assertTrue(60 <= touch.t[-1] <= 62, touch.t[-1])
        np.testing.assert_array_equal(touch.force, felt.force[-len(touch.t):])


if __name__ == "__main__":
    unittest.main(verbosity=2)
