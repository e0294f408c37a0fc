//! A control program on the master `ethercrab`: it brings the C-887 to Operational, homes it, and moves all six axes, with
//! the types that devc has generated. The hexapod is the virtual drive, made from the same description in the same process:
//! only Ethernet frames go between the two.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use std::path::Path;
use std::time::Duration;

use devc::source::Disk;
use devc_generated::c887::{
    Axis, Controlword, HOMING, Inputs, MACHINE, ModeOfOperation, Outputs, RxPdo1600, TxPdo1A00, objects,
};
use devc_runtime::cia402::{Feedback, Goal, Homing, HomingProgress, Master, Mode, Timing};
use devc_runtime::start_up::StartUp;
use devc_runtime::unit::{Angle, Length, Motion, Unfit};
use devc_virtual::drive::Drive;
use devc_virtual::{Subdevice, Wire};
use ethercrab::{MainDevice, MainDeviceConfig, PduRx, PduStorage, PduTx, Timeouts};
use ethercrab_wire::{EtherCrabWireRead, EtherCrabWireWrite};
use futures_lite::future;

type Failure = Box<dyn std::error::Error>;

static FRAMES: PduStorage<16, 1100> = PduStorage::new();

/// What the device has to be told before process data: nothing more than which PDOs there are.
const START_UP: StartUp = StartUp::of::<Outputs, Inputs>();

/// Cycles, of a millisecond each, that a motion takes.
const CYCLES: u32 = 2000;

fn main() -> Result<(), Failure> {
    let (to_wire, from_wire, frames) = FRAMES.try_split().map_err(|()| "the frames are in use")?;
    let mut wire = Wire::new(vec![hexapod()?]);
    let master = MainDevice::new(frames, Timeouts::default(), MainDeviceConfig::default());
    let carried = async { carry(to_wire, from_wire, &mut wire).await };
    future::block_on(future::or(control(&master), carried))?;
    let subdevices = wire.subdevices();
    for axis in subdevices.iter().flat_map(|subdevice| subdevice.firmware.axes()) {
        println!(
            "drive   {} is at {} steps, {}, in mode {}",
            axis.name, axis.position, axis.state, axis.mode
        );
    }
    Ok(())
}

/// The drive, as the description has it.
fn hexapod() -> Result<Subdevice<Drive>, Failure> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices/c887");
    let family = devc::compile(&Disk, &folder).family.ok_or("the description has errors")?;
    let device = family.members.first().ok_or("there is a member")?;
    Ok(Subdevice::of(device))
}

/// Takes each frame of the master through the wire; it takes a millisecond.
async fn carry(
    mut to_wire: PduTx<'_>,
    mut from_wire: PduRx<'_>,
    wire: &mut Wire<Drive>,
) -> Result<(), Failure> {
    loop {
        while let Some(sendable) = to_wire.next_sendable_frame() {
            let mut frame = Vec::new();
            sendable.send_blocking(|bytes| {
                frame.extend_from_slice(bytes);
                Ok(bytes.len())
            })?;
            wire.pass(&mut frame);
            from_wire.receive_frame(&frame)?;
            wire.advance(Duration::from_millis(1));
        }
        future::yield_now().await;
    }
}

/// From Init to Operational, then a cycle after the other until the program is over.
async fn control(master: &MainDevice<'_>) -> Result<(), Failure> {
    let group = master.init_single_group::<2, 128>(|| 0).await?;
    let hexapod = group.subdevice(master, 0)?;
    println!("master  found {}", hexapod.name());
    for write in START_UP.writes::<{ START_UP.len() }>() {
        hexapod.sdo_write(write.address.index, write.address.subindex, write.data()).await?;
    }
    let group = group.into_safe_op(master).await?;
    group.tx_rx(master).await?;
    let group = group.into_op(master).await?;
    println!("master  Operational");

    let mut program = Program::new()?;
    while program.moved < CYCLES {
        group.tx_rx(master).await?;
        let hexapod = group.subdevice(master, 0)?;
        let mut frame = hexapod.io_raw_mut();
        let inputs = Inputs::unpack_from_slice(frame.inputs())?;
        program.cycle(inputs).pack_to_slice(frame.outputs())?;
    }
    // the last outputs have still to go
    group.tx_rx(master).await?;
    Ok(())
}

/// What is done each cycle: first homing, then the motion.
struct Program {
    /// One for all axes, as they share a state.
    master: Master,
    homing: Homing,
    /// How far each axis goes, in steps.
    reach: [i32; 6],
    targets: [i32; 6],
    seeded: bool,
    moved: u32,
    said: String,
}

impl Program {
    fn new() -> Result<Self, Failure> {
        let mut master = Master::new(&MACHINE);
        master.select(ModeOfOperation::Hm.code()).map_err(|unknown| unknown.to_string())?;
        master.request(Goal::OperationEnabled);
        let mut homing = Homing::new(HOMING, Timing { timeout: 5000, ..Timing::DEFAULT });
        homing.start();
        let reach = reach().map_err(|unfit| unfit.to_string())?;
        Ok(Self { master, homing, reach, targets: [0; 6], seeded: false, moved: 0, said: String::new() })
    }

    fn cycle(&mut self, inputs: Inputs) -> Outputs {
        let [TxPdo1A00 { statusword, modes_of_operation_display: mode, .. }, ..] = inputs.axes;
        let output = self.master.cycle(Feedback { statusword: statusword.0, mode, seeded: self.seeded });
        self.seeded = output.seed;
        let controlword = self.homing.cycle(&output, statusword.0);
        if output.seed {
            self.targets = inputs.axes.map(|axis| axis.position_actual_value);
        }
        self.say(format!("{}, homing {:?}", output.progress, self.homing.progress()));
        if mode == ModeOfOperation::Csp.code() && output.motion {
            self.moved += 1;
            self.targets = self.reach.map(|reach| path(reach, self.moved));
        } else if self.homing.progress() == HomingProgress::Completed {
            // that the drive has the mode is known since it was compiled
            let _ = self.master.select(ModeOfOperation::Csp.code());
        }
        let (controlword, modes_of_operation) = (Controlword(controlword), output.mode);
        let axes = self.targets;
        let axes = axes.map(|target_position| RxPdo1600 { controlword, modes_of_operation, target_position });
        Outputs { axes }
    }

    fn say(&mut self, what: String) {
        if what != self.said {
            println!("master  {what}");
            self.said = what;
        }
    }
}

/// How far the axes go: 5, -3 and 2 mm, 1.5, -1 and 4 degrees, in the unit of each.
fn reach() -> Result<[i32; 6], Unfit> {
    let mut steps = [0; 6];
    let reaches = [5000, -3000, 2000, 1500, -1000, 4000];
    for ((place, axis), reach) in steps.iter_mut().zip(Axis::ALL).zip(reaches) {
        *place = match objects::target_position(axis).unit() {
            Motion::Linear(unit) => unit.exact(Length::micrometres(reach))?,
            Motion::Rotary(unit) => unit.exact(Angle::millidegrees(reach))?,
        };
    }
    Ok(steps)
}

/// From rest to rest: the path has to be smooth (C887T0011, CSP).
fn path(reach: i32, cycle: u32) -> i32 {
    let part = f64::from(cycle) / f64::from(CYCLES);
    let smooth = part.powi(3) * (10.0 - 15.0 * part + 6.0 * part.powi(2));
    (f64::from(reach) * smooth).round() as i32
}
