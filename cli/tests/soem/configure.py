"""SOEM as the master: writes the start-up lists of all subdevices, and tells what comes of them.

The lists come as JSON, rounds of [index, subindex, value in hexadecimal] for each subdevice. After each round all are brought
to Operational; what goes back is the lengths of process data, the states, and how many of a hundred cycles went wrong.
"""

import json
import sys

import pysoem


def main(interface):
    rounds = json.load(sys.stdin)
    timeouts = pysoem.settings.timeouts
    # a machine that is busy with other tests is no reason to fail
    timeouts.ret, timeouts.safe, timeouts.eeprom = 500_000, 500_000, 500_000
    timeouts.tx_mailbox, timeouts.rx_mailbox = 500_000, 5_000_000
    print(json.dumps([configured(interface, lists) for lists in rounds]))


def configured(interface, lists):
    master = pysoem.Master()
    master.open(interface)
    try:
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
    finally:
        master.close()


def watched(device):
    """Sets the watchdog of outputs to two seconds. SOEM waits 2 ms for a register, which a busy machine may take."""
    for _ in range(100):
        try:
            return device.set_watchdog("processdata", 2_000)
        except pysoem.WkcError:
            pass
    raise SystemExit(f"the watchdog of {device.name} cannot be set")


def cycle(master):
    master.send_processdata()
    return master.receive_processdata(2_000_000)


main(sys.argv[1])
