"""Looks at a simulated drive of ours with the library canopen and its profile of drives: canopen_visitor.py PATH NODE."""
import sys
import time

import canopen
from canopen.profiles.p402 import BaseNode402

from canopen_bus import JoinedBus
from canopen_dictionary import dictionary_of


def main():
    path, number = sys.argv[1], int(sys.argv[2])
    network = canopen.Network()
    network.bus = JoinedBus(path)
    network.notifier = canopen.network.can.Notifier(network.bus, network.listeners, 0.2)
    node = BaseNode402(number, dictionary_of(number))
    network.add_node(node)
    node.sdo.RESPONSE_TIMEOUT = 5

    node.nmt.state = "PRE-OPERATIONAL"
    print("type", hex(node.sdo[0x1000].raw), flush=True)
    node.sdo[0x1017].raw = 50
    node.nmt.wait_for_heartbeat(timeout=10)
    print("heartbeat", node.nmt.state, flush=True)
    try:
        node.sdo[0x6041].raw = 1
    except canopen.SdoAbortedError as error:
        print("refused", hex(error.code), flush=True)

    node.sdo[0x6060].raw = 8
    node.nmt.state = "OPERATIONAL"
    node.rpdo.read()
    node.tpdo.read()
    node.setup_402_state_machine(read_pdos=False)
    network.sync.start(0.02)
    node.rpdo[1]["Target position"].raw = node.sdo[0x6064].raw
    node.rpdo[1].start(0.02)            # it answers to SYNC: the library then leaves it to this
    node.TIMEOUT_SWITCH_STATE_FINAL = node.TIMEOUT_SWITCH_STATE_SINGLE = 10
    node.state = "OPERATION ENABLED"
    print("state", node.state, flush=True)
    node.rpdo[1]["Target position"].raw = 4321
    node.rpdo[1].update()
    end = time.monotonic() + 10
    while node.tpdo[1]["Position actual value"].raw != 4321 and time.monotonic() < end:
        node.tpdo[1].wait_for_reception(1)
    print("position", node.tpdo[1]["Position actual value"].raw, flush=True)

    # It watches a heartbeat that comes once: then it must stop by itself, and say so.
    node.emcy.reset()
    node.sdo[0x1016][1].raw = 99 << 16 | 200
    network.send_message(0x700 + 99, [5])
    emergency = node.emcy.wait(timeout=10)
    while node.state != "FAULT" and time.monotonic() < end + 10:
        node.tpdo[1].wait_for_reception(1)
    print("emergency", hex(emergency.code), "state", node.state, flush=True)
    network.sync.stop()
    network.disconnect()


main()
