"""A server with TLS and a token, as it has to be where others can reach it: who has both attends, nobody else."""
import os
import pathlib
import subprocess
import tempfile
import unittest

import tactum


class Secured(unittest.TestCase):
    def test_the_token_is_needed(self):
        program = os.environ["TACTUM"]
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder) / "server"
            subprocess.run([program, "serve", "--credentials", place, "--make-certificate"], check=True,
                           stdout=subprocess.DEVNULL)
            words = [program, "serve", "--credentials", place, "--listen", "127.0.0.1:0"]
            with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as server:
                try:
                    target = server.stdout.readline().removeprefix("listening on ").strip()
                    certificate, token = place / "certificate.pem", (place / "token").read_text().strip()
                    with tactum.connect(target, certificate=certificate, token=token) as haptics:
                        self.assertTrue(haptics.welcome.pen)
                        haptics.material(stiffness=300)
                        for wrong in ("", "0" * 32, token[:-1]):
                            with self.assertRaisesRegex(tactum.Error, "token is missing or wrong"):
                                tactum.connect(target, certificate=certificate, token=wrong)
                    with tactum.connect(target, credentials=place):  # the token's file ends with a line feed
                        pass
                    with tactum.connect(target, certificate=certificate, token=token + "\n"):
                        pass
                    with self.assertRaisesRegex(tactum.Error, "no haptic server answers at .* wants a certificate"):
                        tactum.connect(target, patience=1.0)
                    with self.assertRaisesRegex(tactum.Error, "nowhere/token: cannot be read; copy it"):
                        tactum.connect(target, credentials=pathlib.Path(folder) / "nowhere")
                finally:
                    server.terminate()


if __name__ == "__main__":
    unittest.main(verbosity=2)
