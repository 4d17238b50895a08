"""Two network namespaces with a link between them that takes its time and loses packets.

A relay of packets between two TUN devices: not every kernel has netem. It needs root and `ip`.
"""
import contextlib
import ctypes
import fcntl
import heapq
import os
import random
import select
import struct
import subprocess
import threading
import time

TUNSETIFF, IFF_TUN, IFF_NO_PI, CLONE_NEWNET = 0x400454CA, 1, 0x1000, 0x40000000


def unavailable():
    """Why there can be no such link here, or nothing."""
    if os.geteuid() != 0:
        return "namespaces want root"
    if not os.access("/dev/net/tun", os.R_OK | os.W_OK):
        return "there is no /dev/net/tun"
    made = subprocess.run(["ip", "netns", "add", "tactum-probe"], capture_output=True) if _has_ip() else None
    if made is None or made.returncode:
        return "ip cannot make a network namespace"
    subprocess.run(["ip", "netns", "delete", "tactum-probe"], check=True)
    return ""


def _has_ip():
    return any(os.access(os.path.join(folder, "ip"), os.X_OK) for folder in os.environ["PATH"].split(":") + ["/usr/sbin"])


class End:
    """A namespace with one address, whose packets come out of a descriptor."""

    def __init__(self, name, address):
        self.name, self.address = name, address
        self._ip("netns", "delete", name, check=False)
        self._ip("netns", "add", name)
        self.packets = self._device()
        for words in (["addr", "add", f"{address}/24", "dev", "far"], ["link", "set", "far", "up"], ["link", "set", "lo", "up"]):
            self._ip("-n", name, *words)

    def _ip(self, *words, check=True):
        subprocess.run(["ip", *words], check=check, capture_output=not check)

    def _device(self):
        libc = ctypes.CDLL(None, use_errno=True)
        here, there = os.open("/proc/self/ns/net", os.O_RDONLY), os.open(f"/run/netns/{self.name}", os.O_RDONLY)
        try:
            if libc.setns(there, CLONE_NEWNET):
                raise OSError(ctypes.get_errno(), "setns")
            packets = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
            fcntl.ioctl(packets, TUNSETIFF, struct.pack("16sH", b"far", IFF_TUN | IFF_NO_PI))
            return packets
        finally:
            libc.setns(here, CLONE_NEWNET)
            os.close(here)
            os.close(there)

    def run(self, *command):
        """A command for subprocess that runs there."""
        return ["ip", "netns", "exec", self.name, *map(str, command)]

    def close(self):
        os.close(self.packets)
        self._ip("netns", "delete", self.name, check=False)


class FarLink:
    """delay and jitter in s each way, each packet's own, so that they may pass each other; loss: the share that is lost."""

    def __init__(self, delay=0.0, jitter=0.0, loss=0.0, seed=1):
        self.delay, self.jitter, self.loss = delay, jitter, loss
        self.server, self.client = End("tactum-server", "10.77.0.1"), End("tactum-client", "10.77.0.2")
        self.carried = self.lost = 0
        self._random, self._closing = random.Random(seed), False
        self._relay = threading.Thread(target=self._carry)
        self._relay.start()

    def _carry(self):
        ends = [self.server.packets, self.client.packets]
        under_way, number = [], 0
        while not self._closing:
            wait = min(0.1, max(0.0, under_way[0][0] - time.monotonic())) if under_way else 0.1
            for end in select.select(ends, [], [], wait)[0]:
                for packet in self._waiting(end):
                    if self._random.random() < self.loss:
                        self.lost += 1
                        continue
                    due = time.monotonic() + self.delay + self._random.uniform(0, self.jitter)
                    number += 1
                    heapq.heappush(under_way, (due, number, ends[1 - ends.index(end)], packet))
            while under_way and under_way[0][0] <= time.monotonic():
                _, _, to, packet = heapq.heappop(under_way)
                self.carried += 1
                with contextlib.suppress(OSError):  # a full device loses it
                    os.write(to, packet)

    def _waiting(self, end):
        with contextlib.suppress(BlockingIOError):
            for _ in range(64):
                yield os.read(end, 2048)

    def close(self):
        self._closing = True
        self._relay.join()
        self.server.close()
        self.client.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
