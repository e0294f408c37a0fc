//! Frames from a network interface through the devices, and back.

use std::fs::File;
use std::io::{self, BufWriter};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use devc::text::characters::line;
use devc_virtual::drive::Drive;
use devc_virtual::{Event, Interface, Trace, Way, Wire};

use super::Told;
use super::ending::Ending;
use super::fault::Due;
use super::screen::Screen;
use super::store::Store;
use super::table;
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
    store: Option<Store>,
    /// What has happened and was looked at, but is not told yet, with the position of the device.
    events: Vec<(Option<usize>, Event)>,
    /// What is to come.
    dues: Vec<Due>,
    start: Instant,
    /// Up to when the devices know the time.
    known: Instant,
}

impl Bus {
    pub(super) fn new(
        wire: Wire<Drive>,
        interface: Interface,
        (trace, store): (Option<Trace<BufWriter<File>>>, Option<Store>),
        dues: Vec<Due>,
    ) -> Self {
        let start = Instant::now();
        Self { wire, interface, trace, store, events: Vec::new(), dues, start, known: start }
    }

    /// Serves a master to the end, and says what happens.
    pub(super) fn serve(&mut self, ending: &Ending, mut told: Told, report: &Report) -> Result<(), Failure> {
        let (mut looked, mut reported) = (self.start, self.start);
        let mut screen = Screen::of(report);
        while !ending.has_come() {
            self.exchange(&told)?;
            if looked.elapsed() >= LOOK {
                looked = Instant::now();
                let is_second = reported.elapsed() >= SECOND;
                if is_second {
                    reported = looked;
                }
                self.tell(&mut told, is_second, screen.as_mut(), report)?;
            }
        }
        self.tell(&mut told, false, screen.as_mut(), report)
    }

    /// Takes the frames that have come, or lets a tick go by.
    fn exchange(&mut self, told: &Told) -> Result<(), Failure> {
        self.interface.wait(TICK).map_err(lost)?;
        let mut is_idle = true;
        while let Some(mut frame) = self.interface.receive().map_err(lost)? {
            self.go_on();
            self.pass(&mut frame).map_err(lost)?;
            self.work(told)?;
            is_idle = false;
        }
        if is_idle {
            self.go_on();
            self.work(told)?;
        }
        Ok(())
    }

    fn pass(&mut self, frame: &mut [u8]) -> io::Result<()> {
        self.record(Way::In, frame)?;
        if self.wire.pass(frame) {
            self.interface.send(frame)?;
            self.record(Way::Out, frame)?;
        }
        Ok(())
    }

    /// Lets the firmware go on.
    fn work(&mut self, told: &Told) -> Result<(), Failure> {
        self.wire.work();
        self.keep(told)
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
    fn tell(
        &mut self,
        told: &mut Told,
        is_second: bool,
        screen: Option<&mut Screen>,
        report: &Report,
    ) -> Result<(), Failure> {
        let at = self.start.elapsed();
        self.provoke(at);
        let mut events = std::mem::take(&mut self.events);
        events.extend(self.wire.take_events());
        let mut lines: Vec<String> =
            events.iter().map(|(position, event)| told.event(at, *position, event)).collect();
        for (position, subdevice) in self.wire.subdevices_mut().iter_mut().enumerate() {
            lines.extend(told.axes(at, position, &subdevice.firmware.axes()));
            if is_second {
                let (cycles, clocks) = (subdevice.take_cycles(), subdevice.clocks());
                lines.extend(told.cycles(at, position, &cycles, clocks));
            }
        }
        match screen {
            None => lines.iter().for_each(|line| report.line(line)),
            Some(screen) => {
                let lines: Vec<String> = lines.iter().map(|text| line(text).into_owned()).collect();
                let rows = table::rows(&told.shown(self.wire.subdevices()), Screen::size());
                report.output(&screen.update(&lines, rows));
            }
        }
        if let Some(trace) = &mut self.trace {
            // what is lost here is told when more is written
            let _ = trace.flush();
        }
        Ok(())
    }

    fn provoke(&mut self, at: Duration) {
        let subdevices = self.wire.subdevices_mut();
        self.dues.retain(|due| {
            let is_due = due.after <= at;
            if let Some(subdevice) = subdevices.get_mut(due.position).filter(|_| is_due) {
                due.happen(&mut subdevice.firmware);
            }
            !is_due
        });
    }

    /// Keeps what was stored or restored, before a master can fetch the answer.
    fn keep(&mut self, told: &Told) -> Result<(), Failure> {
        let Some(store) = &mut self.store else { return Ok(()) };
        let events = self.wire.take_events();
        for (position, event) in &events {
            let Some(position) = position.filter(|_| matches!(event, Event::Stored | Event::Restored)) else {
                continue;
            };
            if let Some(subdevice) = self.wire.subdevices().get(position) {
                store.keep(position, told.name(position), subdevice.firmware.stored())?;
            }
        }
        self.events.extend(events);
        Ok(())
    }
}

fn lost(error: io::Error) -> Failure {
    Failure::new(format!("the network interface or the trace is lost: {}", reason(&error)))
}
