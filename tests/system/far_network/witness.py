"""A client beside the server, until its input names a revision and that is felt: witness.py TARGET CREDENTIALS RECORDING.

Prints as JSON when each revision was felt first, by the clock that all processes share; how many states had a force; the
longest pause between two of them; missed ticks. RECORDING gets the server's last minute.
"""
import json
import pathlib
import select
import sys

import tactum
import tactum_pb2 as pb


def main(target, folder, recording):
    folder = pathlib.Path(folder)
    with tactum.connect(target, name="witness", rate=1000, pen=False, certificate=folder / "certificate.pem",
                        token=(folder / "token").read_text().strip(), patience=30.0) as haptics:
        print("attending", flush=True)
        state, felt, touching, longest, most = haptics.state(), {}, 0, 0, 0
        wanted = None
        while wanted is None or state.revision < wanted:
            if wanted is None and select.select([sys.stdin], [], [], 0)[0]:
                wanted = int(sys.stdin.readline())
            last, state = state, haptics.state(newer_than=state.number)
            felt.setdefault(state.revision, state.time_ns)
            touching += int(state.force.any())
            longest = max(longest, state.time_ns - last.time_ns)
            most = max(most, state.attending)
        request = pb.RecordRequest(key=haptics.welcome.key)
        pathlib.Path(recording).write_bytes(b"".join(part.bytes for part in haptics._stub.Record(request)))
        print(json.dumps({"felt": felt, "touching": touching, "longest_pause_ms": longest / 1e6, "attending": most,
                          "ticks": state.ticks, "missed": state.missed, "machine_missed": state.machine_missed}))


main(*sys.argv[1:])
