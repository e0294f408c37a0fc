"""SOEM as the master: writes the start-up lists of all subdevices, and tells what comes of them.

The lists come as JSON, rounds of [index, subindex, value in hexadecimal] for each subdevice. After each round all are brought
to Operational; what goes back is the lengths of process data, the states, and how many of a hundred cycles went wrong.
"""

import json
import sys

import pysoem

from bus import opened, watched


def main(interface):
    rounds = json.load(sys.stdin)
    print(json.dumps([configured(interface, lists) for lists in rounds]))


def configured(interface, lists):
    with opened(interface) as master:
        master.config_init()
        for device, writes in zip(master.slaves, lists, strict=True):
            for index, subindex, value in writes:
                device.sdo_write(index, subindex, bytes.fromhex(value))
        master.config_map()
        for device in master.slaves:
            watched(device)
        lengths = [[len(device.output), len(device.input)] for device in master.slaves]
        master.state_check(pysoem.SAFEOP_STATE, 10_000_000)
        master.state = pysoem.OP_STATE
        cycle(master)
        master.write_state()
        for _ in range(1000):
            cycle(master)
            if master.state_check(pysoem.OP_STATE, 1000) == pysoem.OP_STATE:
                break
        wrong = sum(cycle(master) != master.expected_wkc for _ in range(100))
        master.read_state()
        told = {"lengths": lengths, "states": [device.state for device in master.slaves], "wrong": wrong}
        master.state = pysoem.INIT_STATE
        master.write_state()
        return told


def cycle(master):
    master.send_processdata()
    return master.receive_processdata(2_000_000)


main(sys.argv[1])
