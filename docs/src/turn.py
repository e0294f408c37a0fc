"""Turns the drive of `devc new` for four seconds: python3 turn.py INTERFACE"""
import struct
import sys
import time

import pysoem

# What leads towards operation, by the bits of the statusword that show the state.
COMMANDS = {0x40: 0x06, 0x21: 0x07, 0x23: 0x0F, 0x27: 0x0F}
CSP = 8

master = pysoem.Master()
master.open(sys.argv[1])
assert master.config_init() > 0, "no drive is there"
drive = master.slaves[0]
master.config_map()
assert master.state_check(pysoem.SAFEOP_STATE, 50_000) == pysoem.SAFEOP_STATE

# Outputs: controlword, mode of operation, target position. Inputs: statusword, mode, position.
drive.output = struct.pack("<Hbi", 0, CSP, 0)
master.send_processdata()
master.receive_processdata(2000)
master.state = pysoem.OP_STATE
master.write_state()

target = 0
for cycle in range(4000):
    master.send_processdata()
    master.receive_processdata(2000)
    statusword, mode, position = struct.unpack("<Hbi", drive.input)
    state = statusword & (0x4F if statusword & 0x40 else 0x6F)
    enabled = state == 0x27
    target = target + 10 if enabled else position
    drive.output = struct.pack("<Hbi", COMMANDS.get(state, 0x80), CSP, target)
    if cycle % 500 == 0:
        print(f"statusword {statusword:#06x}  position {position}")
    time.sleep(0.001)

drive.output = struct.pack("<Hbi", 0, CSP, target)
master.send_processdata()
master.receive_processdata(2000)
master.state = pysoem.INIT_STATE
master.write_state()
master.close()
assert position > 10_000, "it has not turned"
