"""A server with an emulated Falcon and its clients in two network namespaces: what the device is sent does not know of
the network between them, whatever that delays, mixes up or loses.

The judge of the forces is the recording: `tactum play` makes every step of both loops again from the finger and the
edits, in a process without a network. What would show that this test is wrong: a recording without edits or touch, so
both are counted, and a link that did not delay or lose, so its packets are. Ends with 77, skipped, where there can be no
namespaces. The environment tells TACTUM and FALCON_SERVER, programs; TACTUM_EDITS for more of them, and TACTUM_WINDOW for
a window at the far end, too.
"""
import contextlib
import json
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import unittest

from far_link import FarLink, unavailable

HERE = pathlib.Path(__file__).resolve().parent
TACTUM = os.environ["TACTUM"]
EDITS = int(os.environ.get("TACTUM_EDITS", "20"))


@contextlib.contextmanager
def program(end, *command, **options):
    """In the namespace of an end; its output by lines. It is gone afterwards."""
    with subprocess.Popen(end.run(*command), stdout=subprocess.PIPE, text=True, **options) as process:
        try:
            yield process
        finally:
            process.terminate()


def python(script, *words):
    return [sys.executable, HERE / script, *words]


class FarNetwork(unittest.TestCase):
    def over(self, link, folder):
        """What the witness saw, the lines of the editor, and what the recording says when it is made again."""
        subprocess.run([TACTUM, "serve", "--credentials", folder, "--make-certificate", link.server.address], check=True,
                       stdout=subprocess.DEVNULL)
        recording = folder / "recording.tactum-recording"
        with program(link.server, os.environ["FALCON_SERVER"], f"{link.server.address}:0", folder) as server:
            target = server.stdout.readline().removeprefix("listening on ").strip()
            with program(link.server, *python("witness.py", target, folder, recording), stdin=subprocess.PIPE) as witness:
                self.assertEqual(witness.stdout.readline(), "attending\n")
                with self.window(link, target, folder):
                    with program(link.client, *python("editor.py", target, folder, str(EDITS))) as editor:
                        asked = [tuple(map(int, line.split())) for line in editor.stdout]
                        self.assertEqual(editor.wait(), 0)
                seen = json.loads(witness.communicate(f"{asked[-1][1]}\n")[0])
            server.send_signal(signal.SIGTERM)
            self.assertEqual(server.wait(), 0)
        summary = folder / "summary.json"
        played = subprocess.run([TACTUM, "play", recording, "--summary", summary], capture_output=True, text=True)
        self.assertIn(played.returncode, (0, 1), played.stderr)
        return seen, asked, json.loads(summary.read_text())

    @contextlib.contextmanager
    def window(self, link, target, folder):
        if "TACTUM_WINDOW" not in os.environ:
            yield
            return
        home = os.environ | {"XDG_CONFIG_HOME": str(folder / "config"), "QT_QPA_PLATFORM": "xcb"}
        with program(link.client, "xvfb-run", "-a", TACTUM, "--connect", target, "--credentials", folder, env=home):
            yield

    def judged(self, **way):
        with tempfile.TemporaryDirectory() as folder, FarLink(**way) as link:
            seen, asked, played = self.over(link, pathlib.Path(folder))
            carried, lost = link.carried, link.lost
        # Of two edits that came close together only the second may have been in a state: then both were felt by it.
        felt = {int(revision): at for revision, at in seen["felt"].items()}
        late = [(min(at for felt_as, at in felt.items() if felt_as >= revision) - asked_at) / 1e6 for asked_at, revision in asked]
        print(f"{way}: edits felt after {min(late):.1f}, {statistics.median(late):.1f}, {max(late):.1f} ms (least, median, most); "
              f"{seen['ticks']} ticks, {seen['missed']} missed, {seen['machine_missed']} of them by the machine; states at most "
              f"{seen['longest_pause_ms']:.1f} ms apart; {carried} packets, {lost} lost; {played['haptic_steps']} and "
              f"{played['servo_ticks']} steps made again, {played['differ']} differ", file=sys.stderr)
        self.assertEqual(len(asked), EDITS)
        self.assertGreater(seen["touching"], 100)
        self.assertEqual(played["differ"], 0, played["first_difference"])
        self.assertGreater(played["scenes"], EDITS)
        if "TACTUM_BUSY" not in os.environ:  # it judges the processor
            self.assertEqual(seen["missed"], seen["machine_missed"])
        self.assertGreaterEqual(min(late), 1e3 * way.get("delay", 0))
        if way.get("loss"):
            self.assertGreater(lost, 0)

    def test_at_once(self):
        self.judged()

    def test_5_ms(self):
        self.judged(delay=0.005)

    def test_50_ms(self):
        self.judged(delay=0.05)

    def test_50_ms_with_jitter_and_loss(self):
        self.judged(delay=0.05, jitter=0.02, loss=0.05)


if __name__ == "__main__":
    if why := unavailable():
        print(f"skipped: {why}")
        sys.exit(77)
    unittest.main(verbosity=2)
