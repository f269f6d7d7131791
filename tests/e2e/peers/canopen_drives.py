"""Drives of CiA 402 that are made with the library canopen: canopen_drives.py PATH NODES. Lines on its input are NODE CODE: a fault."""
import sys
import threading

import canopen

from canopen_bus import OwnBus
from canopen_dictionary import SWITCH_ON_DISABLED, dictionary_of

READY, SWITCHED_ON, ENABLED, FAULT = 0x231, 0x233, 0x237, 0x218


class Drive:
    """Its motor is wherever it is told to be."""

    def __init__(self, network, number):
        self.network, self.number = network, number
        self.node = canopen.LocalNode(number, dictionary_of(number))
        network.add_node(self.node)
        self.status, self.control, self.position, self.is_mapped = SWITCH_ON_DISABLED, 0, 0, False
        self.node.nmt.send_command(0)           # the message that it has started
        network.subscribe(0x80, self.sync)

    def map(self):
        for maps in (self.node.rpdo, self.node.tpdo):
            maps.read()
        for pdo in self.node.rpdo.values():
            if pdo.enabled:
                pdo.subscribe()
        self.is_mapped = True

    def sync(self, _id, _data, _time):
        if self.node.nmt.state != "OPERATIONAL":
            self.is_mapped = False
            return
        if not self.is_mapped:
            self.map()
        told = {value.name: value.raw for pdo in self.node.rpdo.values() if pdo.enabled for value in pdo}
        self.obey(told.get("Controlword", 0))
        if self.status == ENABLED and told.get("Modes of operation", 8) == 8:
            self.position = told.get("Target position", self.position)
        self.send({"Statusword": self.status, "Position actual value": self.position, "Modes of operation display": told.get("Modes of operation", 8)})

    def send(self, values):
        for pdo in self.node.tpdo.values():
            if pdo.enabled:
                for value in pdo:
                    value.raw = values.get(value.name, 0)
                pdo.transmit()

    def obey(self, word):
        edge, self.control = word & ~self.control & 0x80, word
        if self.status == FAULT:
            self.status = SWITCH_ON_DISABLED if edge else FAULT
        elif not word & 2:
            self.status = SWITCH_ON_DISABLED
        elif not word & 1:
            self.status = READY
        elif self.status == READY:
            self.status = SWITCHED_ON
        elif self.status in (SWITCHED_ON, ENABLED):
            self.status = ENABLED if word & 8 else SWITCHED_ON

    def fail(self, code):
        self.status = FAULT
        self.node.emcy.send(code, 1)


def main():
    path, count = sys.argv[1], int(sys.argv[2])
    network = canopen.Network()
    network.bus = OwnBus(path)
    drives = {}
    network.notifier = canopen.network.can.Notifier(network.bus, network.listeners, 0.2)
    for number in range(1, count + 1):
        drives[number] = Drive(network, number)
    print("drives", count, flush=True)
    for line in sys.stdin:
        number, code = line.split()
        drives[int(number)].fail(int(code, 16))
    threading.Event().wait()


main()
