"""SOEM as the master: brings all subdevices of an interface to Operational and cycles, then tells what it saw as JSON."""

import ctypes
import json
import sys
import time

import pysoem


def main(interface, cycles):
    master = pysoem.Master()
    master.open(interface)
    try:
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
        for device, told in zip(master.slaves, seen["devices"]):
            told["lengths"] = [len(device.output), len(device.input)]
        check(master, pysoem.SAFEOP_STATE, 5_000_000)
        master.send_processdata()
        master.receive_processdata(100_000)
        master.state = pysoem.OP_STATE
        master.write_state()
        for _ in range(1000):
            master.send_processdata()
            master.receive_processdata(100_000)
            if master.state_check(pysoem.OP_STATE, 1000) == pysoem.OP_STATE:
                break
        check(master, pysoem.OP_STATE, 100_000)
        begin = time.monotonic()
        for _ in range(cycles):
            master.send_processdata()
            if master.receive_processdata(100_000) != master.expected_wkc:
                seen["wrong"] += 1
            seen["cycles"] += 1
        seen["seconds"] = time.monotonic() - begin
        master.read_state()
        seen["states"] = [device.state for device in master.slaves]
        master.state = pysoem.INIT_STATE
        master.write_state()
        print(json.dumps(seen))
    finally:
        master.close()


def check(master, state, timeout):
    if master.state_check(state, timeout) != state:
        master.read_state()
        raise SystemExit([(d.name, hex(d.state), hex(d.al_status), pysoem.al_status_code_to_string(d.al_status))
                          for d in master.slaves])


main(sys.argv[1], int(sys.argv[2]))
