"""Tactum's haptic server from Python: scenes, forces and replays as numpy arrays.

    import tactum
    with tactum.serve() as haptics:          # or tactum.connect("host:port", ...)
        haptics.open("teapot.obj")
        haptics.material(static_friction=0.4)
        touch = haptics.replay(path)          # rows of t, x, y, z
        print(touch.force)

SI throughout: metre, second, newton, kilogram, radian; the world's frame, y up. docs/python.md has the whole of it.
"""

import contextlib
import os
import pathlib
import queue
import shutil
import subprocess
import threading
import time

os.environ.setdefault("GRPC_VERBOSITY", "NONE")  # what goes wrong is told by Error, in a sentence

import grpc
import numpy as np

import tactum_pb2 as pb
import tactum_pb2_grpc as rpc
from tactum.results import Error, Touch

__all__ = ["Client", "Hand", "State", "connect", "serve"]

HEARTBEAT = 0.25  # s: at least so often the client says something
SILENCE = 3 * HEARTBEAT  # s without a word of the server: it is gone
PIECE = 1 << 18  # bytes of an upload at once


def _sentence(error):
    if error.code() == grpc.StatusCode.UNAVAILABLE:  # the details are of sockets
        return "the server is not there any more: connect to it anew"
    if error.code() == grpc.StatusCode.RESOURCE_EXHAUSTED:
        return "that is more than 4 MiB at once: send less, a mesh or a file by an upload"
    return error.details() or str(error.code())


@contextlib.contextmanager
def _plainly():
    try:
        yield
    except grpc.RpcError as error:
        raise Error(_sentence(error)) from None
    except ValueError:  # of a channel that is closed
        raise Error("this client is closed: connect anew") from None


def _number(hand):
    if not isinstance(hand, int) or hand < 0:
        raise Error(f"hand: {hand!r} is no number of a hand; they are counted from 0")
    return hand


def _secrets(folder, certificate, token):
    """Certificate and token as they are sent, from files or as given."""
    try:
        if folder is not None:
            folder = pathlib.Path(folder)
            certificate, token = folder / "certificate.pem", (folder / "token").read_text()
        roots = pathlib.Path(certificate).read_bytes()
    except OSError as error:
        raise Error(f"{error.filename}: cannot be read; copy it from the folder of the server that made it") from None
    if b"-----BEGIN CERTIFICATE-----" not in roots:
        raise Error(f"{certificate}: is no certificate; copy it from the folder of the server that made it")
    return roots, (token or "").strip()


def _vector(values):
    x, y, z = (float(v) for v in values)
    return pb.Vector(x=x, y=y, z=z)


def _array(vector):
    return np.array([vector.x, vector.y, vector.z])


def _pose(position=None, rotation=None):
    pose = pb.Pose(position=_vector((0, 0, 0) if position is None else position))
    if rotation is not None:
        w, x, y, z = (float(v) for v in rotation)
        pose.rotation.CopyFrom(pb.Rotation(w=w, x=x, y=y, z=z))
    return pose


def _nobody(target, secured):
    certificate = ("with a certificate, and whether yours and the token are those of its folder" if secured
                   else "and whether it wants a certificate and a token")
    return f"no haptic server answers at {target}: see whether tactum serve runs there, {certificate}"


class Hand:
    """What one hand does: finger, proxy and force as arrays, its device, all else as in the protocol's Hand."""

    def __init__(self, message, device):
        self.message, self.device = message, device
        self.finger, self.proxy, self.force = (_array(v) for v in (message.finger, message.proxy, message.force))

    def __getattr__(self, name):
        return getattr(self.message, name)


class State(Hand):
    """The newest that the server told: what is of a hand is that of the first, all else as in the protocol's State."""

    def __init__(self, message, devices):
        super().__init__(message, devices[0])
        self._others = [Hand(other, device) for other, device in zip(message.other, devices[1:])]

    @property
    def hands(self):
        """Each of them, this first one too."""
        return [self, *self._others]


class Client:
    """One client that attends. Ends with close(), or at the end of a with block."""

    def __init__(self, target, name="Python", certificate=None, token=None, rate=60, pen=True, bodies=False,
                 patience=5.0, process=None, credentials=None):
        """`credentials`: the folder with certificate.pem and token; or these two, a file and its text. `rate`: of
        states, 1 to 1000 Hz."""
        if not 1 <= rate <= 1000:
            raise Error(f"rate: {rate} is not from 1 to 1000 Hz")
        self._process = process
        self._credentials = None
        if certificate is not None or credentials is not None:
            roots, token = _secrets(credentials, certificate, token)
            call = grpc.metadata_call_credentials(lambda context, callback: callback((("tactum-token", token),), None))
            self._credentials = grpc.composite_channel_credentials(grpc.ssl_channel_credentials(roots), call)
        self._target = target
        self._channel = self._open()
        self._stub = rpc.HapticsStub(self._channel)
        self._words = queue.Queue()
        self._words.put(pb.Word(name=name, wants_pen=pen, state_rate=rate, bodies=bodies))
        self._news = threading.Condition()
        self._state, self._events, self._fault, self._heard = None, [], None, time.monotonic()
        self.welcome = None
        self._closing = False
        self._call = self._stub.Attend(self._speak(), wait_for_ready=True)
        self._reader = threading.Thread(target=self._listen, daemon=True)
        self._reader.start()
        self._wait(lambda: self.welcome is not None, patience, _nobody(target, self._credentials is not None))

    def _open(self):
        # A pool of its own: each channel is a connection, and an upload never holds up what is said meanwhile.
        options = [("grpc.use_local_subchannel_pool", 1), ("grpc.initial_reconnect_backoff_ms", 100),
                   ("grpc.max_reconnect_backoff_ms", 1000), ("grpc.keepalive_time_ms", 2000)]
        if self._credentials is None:
            return grpc.insecure_channel(self._target, options)
        return grpc.secure_channel(self._target, self._credentials, options)

    # ---- attending ----

    def _speak(self):
        while not self._closing:
            try:
                word = self._words.get(timeout=0.8 * HEARTBEAT)
            except queue.Empty:
                word = pb.Word()  # a heartbeat
            if word is None:
                return
            yield word

    def _listen(self):
        try:
            for news in self._call:
                with self._news:
                    self._hear(news)
                    self._news.notify_all()
        except grpc.RpcError as error:
            self._end(_sentence(error))
        else:
            self._end("the server has ended")

    def _end(self, why):
        with self._news:
            self._fault = why
            self._news.notify_all()

    def _hear(self, news):
        self._heard = time.monotonic()
        what = news.WhichOneof("what")
        if what == "welcome":
            self.welcome = news.welcome
        elif what == "state":
            self._state = State(news.state, self.devices)
            self._words.put(pb.Word(seen=news.state.number))
        elif what == "event":
            self._events.append(news.event)

    def _wait(self, condition, patience, otherwise):
        end = time.monotonic() + patience
        with self._news:
            while not condition():
                if self._fault is not None:
                    raise Error(self._fault)
                if time.monotonic() > end:
                    raise Error(otherwise)
                self._news.wait(0.05)

    @property
    def devices(self):
        """What drives each hand: name, real, max_force and what the protocol's Device has."""
        return [self.welcome.device, *self.welcome.other]

    @property
    def alive(self):
        """Whether the server was heard of late."""
        return self._fault is None and time.monotonic() - self._heard < SILENCE

    def state(self, newer_than=0, patience=5.0):
        """The newest state; waits for one whose number is above `newer_than`. An Error where the server is gone."""
        if self._fault is not None:
            raise Error(self._fault)
        self._wait(lambda: self._state is not None and self._state.number > newer_than, patience, "no state came")
        with self._news:
            return self._state

    def until(self, condition, patience=10.0):
        """Waits for a state for which condition(state) holds, and returns it."""
        self._wait(lambda: self._state is not None and condition(self._state), patience, "it did not come to be")
        return self.state()

    def events(self):
        """What happened since the last call."""
        with self._news:
            events, self._events = self._events, []
        return events

    def push(self, force, hand=0):
        """Adds a force (N) to what a hand's finger feels; say it again within 100 ms, or it fades."""
        self._words.put(pb.Word(push=pb.Push(force=_vector(force), hand=_number(hand))))

    # ---- the scene ----

    def apply(self, *edits, base=0):
        """Edits (tactum_pb2.Edit), all or none; the answer has the scene's revision and what was added."""
        with _plainly():
            return self._stub.Apply(pb.Transaction(key=self.welcome.key, base=base, edit=edits))

    def open(self, file, fit_diagonal=0.0):
        """A file of this machine instead of the scene."""
        file = pathlib.Path(file)
        upload = self.upload(pb.UploadHead(file=file.name), file.read_bytes())
        return self.apply(pb.Edit(open=pb.OpenUpload(upload=upload.upload, fit_diagonal=fit_diagonal)))

    def add_file(self, file, position=None, rotation=None, name=""):
        """The objects of a file beside those that there are; their numbers."""
        file = pathlib.Path(file)
        upload = self.upload(pb.UploadHead(file=file.name), file.read_bytes())
        return self._add(upload, position, rotation, name)

    def add_mesh(self, positions, triangles, normals=None, uvs=None, surfaces=None, position=None, rotation=None,
                 name="mesh", progress=None):
        """A mesh of arrays: positions (n, 3) in m, triangles (m, 3), normals (m, 3, 3), uvs (m, 3, 2), surfaces (m,);
        the number of its object."""
        positions = np.ascontiguousarray(positions)
        wide = positions.dtype == np.float64
        parts = [positions.astype("<f8" if wide else "<f4"), np.ascontiguousarray(triangles).astype("<u4")]
        head = pb.MeshHead(positions=len(positions), triangles=len(parts[1]), doubles=wide)
        for values, field, kind in ((normals, "normals", "<f4"), (uvs, "uvs", "<f4"), (surfaces, "surfaces", "<u4")):
            if values is not None:
                parts.append(np.ascontiguousarray(values).astype(kind))
                setattr(head, field, True)
        if surfaces is not None:
            head.surface_count = int(np.max(surfaces)) + 1
        upload = self.upload(pb.UploadHead(mesh=head), b"".join(part.tobytes() for part in parts), progress)
        return self._add(upload, position, rotation, name)[0]

    def _add(self, upload, position, rotation, name):
        add = pb.AddUpload(upload=upload.upload, name=name, pose=_pose(position, rotation))
        return list(self.apply(pb.Edit(add=add)).added)

    def upload(self, head, content, progress=None):
        """Sends bytes in pieces on a channel of their own; progress(fraction received, fraction checked)."""
        head.key, head.size = self.welcome.key, len(content)
        view = memoryview(content)

        def pieces():
            yield pb.Piece(head=head, bytes=bytes(view[:PIECE]))
            for at in range(PIECE, len(view), PIECE):
                yield pb.Piece(bytes=bytes(view[at:at + PIECE]))

        with self._open() as channel, _plainly():
            for news in rpc.HapticsStub(channel).Upload(pieces()):
                what = news.WhichOneof("what")
                if what == "done":
                    return news.done
                if progress is not None:
                    progress(1.0 if what == "checked" else news.received / max(1, head.size), news.checked)
        raise Error("the upload ended without an answer")

    def material(self, object=0, surface=None, **values):
        """stiffness, damping, static_friction, dynamic_friction, viscosity, shading, sides of a surface, of all surfaces
        of an object, or of all objects (0)."""
        return self.apply(pb.Edit(material=pb.SetMaterial(where=_where(object, surface), **values)))

    def texture(self, image, strength, size, object=0, surface=None, target="height", mapping="triplanar"):
        """A layer of texture from an array (rows, columns) of values from 0 to 1, instead of the layers there are.
        `strength`: m of height, or the share of what `target` is; `size`: m, width of a repeat."""
        values = np.asarray(image, dtype=float)
        if values.ndim != 2 or values.size == 0 or not np.isfinite(values).all():
            raise Error("a texture is an array of rows and columns of numbers from 0 to 1")
        if values.size > 2_000_000:
            raise Error(f"a texture has at most 2,000,000 texels, not {values.size}: make it smaller")
        if not (size > 0 and np.isfinite(size)):
            raise Error(f"size: {size} m is no width of a repeat")
        values = np.clip(values, 0, 1)
        texels = np.round(65535 * values).astype("<u2")
        layer = pb.Layer(source="image", target=target, mapping=mapping, strength=strength, size=size,
                         image=pb.Image(width=texels.shape[1], height=texels.shape[0], texels=texels.tobytes()))
        return self.apply(pb.Edit(layers=pb.SetLayers(where=_where(object, surface), layer=[layer])))

    def move(self, object, position=None, rotation=None):
        return self.apply(pb.Edit(pose=pb.SetPose(object=object, pose=_pose(position, rotation))))

    def remove(self, object):
        return self.apply(pb.Edit(remove=object))

    def describe(self):
        with _plainly():
            return self._stub.Describe(pb.DescribeRequest(key=self.welcome.key))

    def replay(self, path):
        """A finger path, rows of t, x, y, z, over the scene as it is: what `tactum touch` gives, to the bit."""
        path = np.ascontiguousarray(path, dtype="<f8")
        if path.ndim != 2 or path.shape[1] != 4:
            raise Error("a path has rows of t, x, y, z")
        request = pb.ReplayRequest(key=self.welcome.key, path=path.tobytes())
        with _plainly():
            rows = b"".join(part.rows for part in self._stub.Replay(request))
        rows = np.frombuffer(rows, dtype="<f8").reshape(-1, 7)
        return Touch(rows[:, :3], rows[:, 3:6], rows[:, 6].astype(int), path[:, 0], path[:, 1:])

    # ---- orders ----

    def _order(self, of=None, **what):
        of = None if of is None else _number(of)
        with _plainly():
            return self._stub.Order(pb.OrderRequest(key=self.welcome.key, of=of, **what))

    def stop(self):
        """All force of all hands ends, whoever has the pen."""
        return self._order(stop=pb.Stop())

    def arm(self, on=True, hand=None):
        """The force of a hand, or of all of them, on or off."""
        if hand is None and on:  # who names none means the first
            return [self._order(of=each, arm=True) for each in range(len(self.devices))][-1]
        return self._order(of=hand, arm=on)

    def ask_for_pen(self):
        return self._order(ask=pb.Ask()).pen

    def pass_pen(self, to=""):
        return self._order(give=pb.Give(to=to))

    def pace(self, pace):
        return self._order(pace=pace)

    def restart(self, hand=0):
        """The proxy of a hand begins at its finger."""
        return self._order(of=hand, restart=pb.Restart())

    def lead_hand(self, to, hand=0):
        """Where a simulated hand should go."""
        return self._order(of=hand, hand=_vector(to))

    def close(self):
        self._closing = True
        self._words.put(None)
        self._reader.join(1.0)
        self._call.cancel()
        self._channel.close()
        if self._process is not None:
            self._process.terminate()
            self._process.wait(10)
            self._process.stdin.close()
            self._process.stdout.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def _where(object, surface):
    where = pb.Where(object=object)
    if surface is not None:
        where.surface = surface
    return where


def connect(target="127.0.0.1:51270", **options):
    """Attends at a server; elsewhere than on this machine with certificate= (a file) and token=."""
    return Client(target, **options)


def serve(scene=None, device="simulated", program=None, **options):
    """Starts a server of its own that ends with the client. `device`: a name that `tactum devices` lists, or one for
    each hand."""
    program = program or os.environ.get("TACTUM") or shutil.which("tactum") or "tactum"
    words = [str(program), "serve", "--listen", "127.0.0.1:0", "--until-input-ends"]
    for name in [device] if isinstance(device, str) else device:
        words += ["--device", name]
    if scene is not None:
        words.append(str(scene))
    try:
        process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    except OSError as error:
        raise Error(f"{program}: cannot be started ({error.strerror}); set TACTUM to the program") from None
    line = process.stdout.readline()
    if not line.startswith("listening on "):
        process.wait(10)
        raise Error("the server did not start: it says why on standard error")
    try:
        return Client(line.removeprefix("listening on ").strip(), process=process, **options)
    except BaseException:
        process.terminate()
        raise
