//! Frames from a network interface through the devices, and back.

use std::fs::File;
use std::io::{self, BufWriter};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use devc_virtual::drive::Drive;
use devc_virtual::{Interface, Trace, Way, Wire};

use super::{Fault, Told};
use crate::outcome::{Failure, reason};
use crate::report::Report;

/// How long the firmware waits for a frame before it goes on by itself.
const TICK: Duration = Duration::from_micros(500);
/// How often is looked for something to say.
const LOOK: Duration = Duration::from_millis(50);
/// How often cycles are reported.
const SECOND: Duration = Duration::from_secs(1);

/// Devices at a network interface.
pub(super) struct Bus {
    wire: Wire<Drive>,
    interface: Interface,
    trace: Option<Trace<BufWriter<File>>>,
    /// Faults that are to come, each with its device and axis.
    faults: Vec<(usize, usize, Fault)>,
    start: Instant,
    /// Up to when the devices know the time.
    known: Instant,
}

impl Bus {
    pub(super) fn new(
        wire: Wire<Drive>,
        interface: Interface,
        trace: Option<Trace<BufWriter<File>>>,
        faults: Vec<(usize, usize, Fault)>,
    ) -> Self {
        let start = Instant::now();
        Self { wire, interface, trace, faults, start, known: start }
    }

    /// Serves a master, for a time or without end, and says what happens.
    pub(super) fn serve(
        &mut self,
        duration: Option<Duration>,
        mut told: Told,
        report: &Report,
    ) -> Result<(), Failure> {
        let (mut looked, mut reported) = (self.start, self.start);
        while duration.is_none_or(|duration| self.start.elapsed() < duration) {
            self.exchange().map_err(|error| {
                Failure::new(format!("the network interface or the trace is lost: {}", reason(&error)))
            })?;
            if looked.elapsed() >= LOOK {
                looked = Instant::now();
                let is_second = reported.elapsed() >= SECOND;
                if is_second {
                    reported = looked;
                }
                self.tell(&mut told, is_second, report);
            }
        }
        Ok(())
    }

    /// Takes the frames that have come, or lets a tick go by.
    fn exchange(&mut self) -> io::Result<()> {
        self.interface.wait(TICK)?;
        let mut is_idle = true;
        while let Some(mut frame) = self.interface.receive()? {
            self.go_on();
            self.record(Way::In, &frame)?;
            if self.wire.pass(&mut frame) {
                self.interface.send(&frame)?;
                self.record(Way::Out, &frame)?;
            }
            self.wire.work();
            is_idle = false;
        }
        if is_idle {
            self.go_on();
            self.wire.work();
        }
        Ok(())
    }

    fn go_on(&mut self) {
        let now = Instant::now();
        self.wire.elapse(now - self.known);
        self.known = now;
    }

    fn record(&mut self, way: Way, frame: &[u8]) -> io::Result<()> {
        let Some(trace) = &mut self.trace else { return Ok(()) };
        let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        trace.frame(now, way, frame)
    }

    /// Provokes the faults whose time has come, and says what has happened.
    fn tell(&mut self, told: &mut Told, is_second: bool, report: &Report) {
        let at = self.start.elapsed();
        let (due, later) = self.faults.drain(..).partition(|(.., fault)| fault.after <= at);
        self.faults = later;
        let due: Vec<(usize, usize, Fault)> = due;
        for (position, axis, fault) in due {
            if let Some(subdevice) = self.wire.subdevices_mut().get_mut(position) {
                subdevice.firmware.fault(axis, fault.code);
            }
        }
        for (position, event) in self.wire.take_events() {
            report.line(&told.event(at, position, &event));
        }
        for (position, subdevice) in self.wire.subdevices_mut().iter_mut().enumerate() {
            for line in told.axes(at, position, &subdevice.firmware.axes()) {
                report.line(&line);
            }
            if is_second {
                let (cycles, sync0) = (subdevice.take_cycles(), subdevice.sync0_cycle());
                told.cycles(at, position, &cycles, sync0).iter().for_each(|line| report.line(line));
            }
        }
        if let Some(trace) = &mut self.trace {
            // what is lost here is told when more is written
            let _ = trace.flush();
        }
    }
}
