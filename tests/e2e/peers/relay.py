#!/usr/bin/env python3
"""A bad network: two network namespaces, and between them nothing but this program, which delays and loses packets.

It does what the kernel's netem does, but needs only a tun device, which kernels without netem have, too. Start it in a
user and network namespace of its own (unshare --map-root-user --net): that is the robot's side. It prints the processes
whose namespaces the two sides are, and then obeys the datagrams that come to the socket named by its only argument:
    impair DELAY LOSS   from now on every packet takes so many seconds, and this part of them is lost
    outage SECONDS      loses all for so long
    cut                 loses all until it is mended
    mend                ends that
    count               prints how many packets were carried and lost
It answers each with a line: the order, the time of this machine's clock at which it counted, and its figures.
"""
import array
import ctypes
import fcntl
import heapq
import math
import os
import random
import select
import signal
import socket
import struct
import subprocess
import sys
import time

SIDES = ("10.77.0.1", "10.77.0.2")
CLONE_NEWNET = 0x40000000
TUNSETIFF, IFF_TUN, IFF_NO_PI = 0x400454CA, 0x0001, 0x1000
PR_SET_PDEATHSIG = 1
MOST_WAITING = 1000
LIBC = ctypes.CDLL(None, use_errno=True)


def open_side(address):
    """A tun device in this process's network namespace."""
    device = os.open("/dev/net/tun", os.O_RDWR)
    fcntl.ioctl(device, TUNSETIFF, struct.pack("16sH", b"bad0", IFF_TUN | IFF_NO_PI))
    for command in ("link set lo up", f"addr add {address}/24 dev bad0", "link set bad0 up mtu 1500"):
        subprocess.run(["ip", *command.split()], check=True)
    return device


def other_side(address):
    """A child whose namespace is the other side; it sends its device and then only waits to be killed."""
    ours, theirs = socket.socketpair()
    child = os.fork()
    if child == 0:
        LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        if LIBC.unshare(CLONE_NEWNET) != 0:
            sys.exit("no network namespace: " + os.strerror(ctypes.get_errno()))
        device = open_side(address)
        theirs.sendmsg([b"x"], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, array.array("i", [device]))])
        signal.pause()
    theirs.close()
    data, ancillary, _, _ = ours.recvmsg(1, socket.CMSG_SPACE(4))
    if not data:
        sys.exit("the other side did not open")
    return child, struct.unpack("i", ancillary[0][2])[0]


class Relay:
    """Carries packets, late and not all of them."""

    def __init__(self, here, there):
        self.peers = {here: there, there: here}
        self.waiting = []
        self.order = 0
        self.random = random.Random(20)
        self.delay = self.loss = 0.0
        self.dark_until = 0.0
        self.carried = self.lost = 0

    def take(self, device):
        packet = os.read(device, 65536)
        now = time.monotonic()
        if now < self.dark_until or self.random.random() < self.loss or len(self.waiting) >= MOST_WAITING:
            self.lost += 1
        else:
            self.order += 1
            heapq.heappush(self.waiting, (now + self.delay, self.order, self.peers[device], packet))

    def deliver(self):
        """Answers the seconds until the next packet is due."""
        now = time.monotonic()
        while self.waiting and self.waiting[0][0] <= now:
            _, _, device, packet = heapq.heappop(self.waiting)
            if now < self.dark_until:
                self.lost += 1
            else:
                os.write(device, packet)
                self.carried += 1
        return max(0.0, self.waiting[0][0] - now) if self.waiting else None

    def obey(self, order):
        word, *figures = order.decode().split()
        if word == "impair":
            self.delay, self.loss = map(float, figures)
        elif word == "outage":
            self.dark_until = time.monotonic() + float(figures[0])
        elif word == "cut":
            self.dark_until = math.inf
        elif word == "mend":
            self.dark_until = 0.0
        print(f"{order.decode()}: at {time.time()} carried {self.carried} lost {self.lost}", flush=True)


def main():
    orders = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    orders.bind(sys.argv[1])
    child, there = other_side(SIDES[1])
    here = open_side(SIDES[0])
    relay = Relay(here, there)
    print(f"sides {os.getpid()} {child}", flush=True)
    while True:
        pause = relay.deliver()
        ready, _, _ = select.select([here, there, orders], [], [], pause)
        for source in ready:
            if source is orders:
                relay.obey(orders.recv(200))
            else:
                relay.take(source)


if __name__ == "__main__":
    main()
