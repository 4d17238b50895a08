"""Either side dies of SIGKILL at a random moment: no force stays, the other side says so and goes on.

TACTUM_DEATHS=1000 for more than a few.
"""
import os
import random
import signal
import socket
import subprocess
import sys
import time
import unittest

import numpy as np
import tactum

DEATHS = int(os.environ.get("TACTUM_DEATHS", "4"))
PLATE = (0.1 * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], dtype=float), [[0, 1, 2], [0, 2, 3]])
# Presses, edits and pushes as fast as it can.
VICTIM = """
import sys, tactum
haptics = tactum.connect(sys.argv[1], name="victim")
haptics.arm()
haptics.lead_hand((0, 0, -0.01))
for i in range(10 ** 9):
    haptics.material(stiffness=400 + i % 100)
    haptics.push((0, 0, 0.5))
"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Deaths(unittest.TestCase):
    def setUp(self):
        self.random = random.Random(21)

    def test_a_client_dies(self):
        with tactum.serve(rate=250) as haptics:
            haptics.add_mesh(*PLATE)
            haptics.pass_pen()
            for _ in range(DEATHS):
                with subprocess.Popen([sys.executable, "-c", VICTIM, haptics._target]) as victim:
                    haptics.until(lambda s: s.armed and s.gain > 0 and s.force[2] > 0.1, patience=60)
                    time.sleep(self.random.uniform(0, 0.5))
                    victim.send_signal(signal.SIGKILL)
                haptics.until(lambda s: not s.armed and not np.any(s.force), patience=60)
                texts = [event.text for event in haptics.events()]
                self.assertTrue(any("victim" in text and "the force fades" in text for text in texts), texts)
                self.assertEqual([o.triangles for o in haptics.describe().object], [2])

    def test_a_server_dies(self):
        port = free_port()
        for _ in range(DEATHS):
            words = [os.environ["TACTUM"], "serve", "--listen", f"127.0.0.1:{port}"]
            with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as server:
                # The port of the one before is free at once.
                self.assertEqual(server.stdout.readline(), f"listening on 127.0.0.1:{port}\n")
                with tactum.connect(f"127.0.0.1:{port}", rate=250) as haptics:
                    haptics.add_mesh(*PLATE)
                    time.sleep(self.random.uniform(0, 0.2))
                    server.send_signal(signal.SIGKILL)
                    begin = time.monotonic()
                    with self.assertRaises(tactum.Error):
                        haptics.until(lambda s: False, patience=60)
                    self.assertLess(time.monotonic() - begin, 30)
                    self.assertFalse(haptics.alive)


if __name__ == "__main__":
    unittest.main(verbosity=2)
