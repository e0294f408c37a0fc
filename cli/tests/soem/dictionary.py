"""SOEM as the master: reads entries of all subdevices in Pre-Operational, and what they tell of their dictionaries.

What is asked comes as JSON: for each subdevice its entries as [index, subindex], and whether it tells its objects. What was
read goes back: values in hexadecimal, and objects with their names, codes and entries, these as [name, data type, bits].
"""

import json
import sys

import pysoem

from bus import opened


def main(interface):
    asked = json.load(sys.stdin)
    with opened(interface) as master:
        master.config_init()
        devices = list(zip(master.slaves, asked, strict=True))
        told = [read(device, entries) for device, (entries, _) in devices]
        # after that, as SOEM takes what it is told of a subindex that there is not for an error of the next access
        for (device, (_, tells)), of in zip(devices, told):
            of["objects"] = objects(device) if tells else []
        print(json.dumps(told))


def read(device, entries):
    values = [upload(device, index, subindex) for index, subindex in entries]
    return {"name": device.name, "values": values}


def upload(device, index, subindex):
    try:
        return device.sdo_read(index, subindex).hex()
    except pysoem.SdoError as error:
        return f"0x{error.abort_code:08X}"


def objects(device):
    return [[item.index, text(item.name), item.object_code,
             [[text(entry.name), entry.data_type, entry.bit_length] for entry in item.entries]] for item in device.od]


def text(name):
    return name.decode("latin-1") if isinstance(name, bytes) else name


main(sys.argv[1])
