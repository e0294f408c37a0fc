"""What all masters of these tests do at an interface."""

import contextlib

import pysoem


@contextlib.contextmanager
def opened(interface, ret=500_000):
    """SOEM at an interface, closed at the end. `ret` is the time in microseconds that a frame may take."""
    timeouts = pysoem.settings.timeouts
    # a machine that is busy with other tests is no reason to fail
    timeouts.ret, timeouts.safe, timeouts.eeprom = ret, 500_000, 500_000
    timeouts.tx_mailbox, timeouts.rx_mailbox = 500_000, 5_000_000
    master = pysoem.Master()
    master.open(interface)
    try:
        yield master
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
