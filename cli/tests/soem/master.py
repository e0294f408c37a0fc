"""SOEM as the master: brings all subdevices of an interface to Operational and cycles, then tells what it saw as JSON."""

import json
import struct
import sys
import time

import pysoem

from bus import opened, watched


def main(interface, cycles, axes):
    with opened(interface, ret=50_000) as master:
        count = master.config_init()
        seen = {"count": count, "devices": [], "cycles": 0, "wrong": 0}
        for device in master.slaves:
            seen["devices"].append({
                "name": device.name,
                "identity": [device.man, device.id, device.rev],
                "type": int.from_bytes(device.sdo_read(0x1000, 0), "little"),
            })
        master.config_map()
        master.config_dc()
        for device in master.slaves:
            device.dc_sync(True, 2_000_000)
            watched(device)
        for device, told in zip(master.slaves, seen["devices"]):
            told["lengths"] = [len(device.output), len(device.input)]
        check(master, pysoem.SAFEOP_STATE, 10_000_000)
        master.send_processdata()
        master.receive_processdata(2_000_000)
        master.state = pysoem.OP_STATE
        master.write_state()
        for _ in range(1000):
            master.send_processdata()
            master.receive_processdata(2_000_000)
            if master.state_check(pysoem.OP_STATE, 1000) == pysoem.OP_STATE:
                break
        check(master, pysoem.OP_STATE, 100_000)
        begin = time.monotonic()
        for _ in range(cycles):
            master.send_processdata()
            if master.receive_processdata(2_000_000) != master.expected_wkc:
                seen["wrong"] += 1
            seen["cycles"] += 1
        seen["seconds"] = time.monotonic() - begin
        if axes:
            seen["moved"] = move(master, master.slaves[0], axes)
        master.read_state()
        seen["states"] = [device.state for device in master.slaves]
        master.state = pysoem.INIT_STATE
        master.write_state()
        print(json.dumps(seen))


def move(master, device, axes):
    """Enables each axis by CiA 402, and leads it in cyclic synchronous position mode; tells asked and gone, in steps.

    Each axis has its fields in the same place: controlword, mode, target; statusword, mode, actual position.
    """
    out, into = len(device.output) // axes, len(device.input) // axes

    def cycle(words, targets):
        image = bytearray(len(device.output))
        for axis in range(axes):
            struct.pack_into("<Hbi", image, axis * out, words[axis], 8, targets[axis])
        device.output = bytes(image)
        master.send_processdata()
        if master.receive_processdata(2_000_000) != master.expected_wkc:
            raise SystemExit("a wrong working counter")
        time.sleep(0.001)
        return [struct.unpack_from("<Hbi", device.input, axis * into) for axis in range(axes)]

    command = {0x40: 0x06, 0x21: 0x07, 0x23: 0x0F, 0x27: 0x0F}
    words, targets = [0x06] * axes, [0] * axes
    for _ in range(1000):
        seen = cycle(words, targets)
        targets = [actual for _, _, actual in seen]
        # bits 0 to 3, 5 and 6 are the state, whether by five of them or by six
        states = [word & 0x6F for word, _, _ in seen]
        if all(state == 0x27 for state in states) and all(mode == 8 for _, mode, _ in seen):
            break
        words = [command.get(state, command.get(state & 0x4F, 0)) for state in states]
    else:
        raise SystemExit(["not enabled", [hex(state) for state in states]])
    start = targets
    for step in range(1, 201):
        targets = [start[axis] + step * (axis + 1) for axis in range(axes)]
        cycle(words, targets)
    for _ in range(100):
        seen = cycle(words, targets)
    return {"asked": [target - begin for target, begin in zip(targets, start)],
            "gone": [actual - begin for (_, _, actual), begin in zip(seen, start)]}


def check(master, state, timeout):
    if master.state_check(state, timeout) != state:
        master.read_state()
        raise SystemExit([(d.name, hex(d.state), hex(d.al_status), pysoem.al_status_code_to_string(d.al_status))
                          for d in master.slaves])


main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
