//! A wire with a drive, and ethercrab at its end; each frame takes a millisecond.

use std::time::Duration;

use devc::model::{Configuration, Device};
use devc_virtual::drive::Drive;
use devc_virtual::{Subdevice, Wire};
use ethercrab::subdevice_group::{NoDc, Op, PreOp};
use ethercrab::{DefaultLock, MainDevice, MainDeviceConfig, PduStorage, SubDeviceGroup};
use ethercrab_wire::{EtherCrabWireRead, EtherCrabWireSized, WireError};
use futures_lite::future;

use crate::carried::{carry, patient};
use crate::shared::model;

pub(crate) type Group<State> = SubDeviceGroup<2, 256, DefaultLock, State, NoDc>;
pub(crate) type Master = MainDevice<'static>;

/// Runs what a master does with a device, and lets something happen to the drive after each frame.
pub(crate) fn run<R, F: Future<Output = R>>(
    device: &Device,
    event: impl Fn(&mut Drive),
    master: impl FnOnce(&'static Master) -> F,
) -> R {
    traced(device, event, |_| (), master)
}

/// As [`run`]; a trace gets each frame as it goes and as it comes.
pub(crate) fn traced<R, F: Future<Output = R>>(
    device: &Device,
    event: impl Fn(&mut Drive),
    mut trace: impl FnMut([&[u8]; 2]),
    master: impl FnOnce(&'static Master) -> F,
) -> R {
    let storage: &'static PduStorage<16, 1100> = Box::leak(Box::new(PduStorage::new()));
    let (to_wire, from_wire, frames) = storage.try_split().expect("once");
    let config = MainDeviceConfig { dc_static_sync_iterations: 10, ..MainDeviceConfig::default() };
    let maindevice = Box::leak(Box::new(MainDevice::new(frames, patient(Duration::from_secs(60)), config)));
    let image = devc::sii::image_of_any_size(device, &[0; 6]);
    let mut wire = Wire::new(vec![Subdevice::new(Drive::new(model(device)), image)]);
    let carried = carry(to_wire, from_wire, &mut wire, |wire, frames| {
        trace(frames);
        event(&mut wire.subdevices_mut()[0].firmware);
        wire.advance(Duration::from_millis(1));
    });
    future::block_on(future::or(async { master(maindevice).await }, carried))
}

/// A value as it travels.
pub(crate) struct Bytes(pub(crate) Vec<u8>);

impl EtherCrabWireRead for Bytes {
    fn unpack_from_slice(bytes: &[u8]) -> Result<Self, WireError> {
        Ok(Self(bytes.to_vec()))
    }
}

impl EtherCrabWireSized for Bytes {
    const PACKED_LEN: usize = 256;
    type Buffer = [u8; 256];

    fn buffer() -> [u8; 256] {
        [0; 256]
    }
}

pub(crate) async fn found(master: &Master) -> Group<PreOp> {
    let group = master.init_single_group::<2, 256>(|| 0).await;
    group.expect("it is found")
}

/// To Operational, with the writes of a configuration.
pub(crate) async fn operational(master: &Master, chosen: Option<&Configuration>) -> Group<Op> {
    let group = found(master).await;
    let drive = group.subdevice(master, 0).expect("the first");
    for write in chosen.into_iter().flat_map(|it| &it.startup) {
        let written = drive.sdo_write(write.address.index.0, write.address.subindex, &write.data[..]).await;
        written.unwrap_or_else(|error| panic!("{}: {error:?}", write.comment));
    }
    let group = group.into_safe_op(master).await.expect("Safe-Operational");
    group.tx_rx(master).await.expect("outputs come");
    group.into_op(master).await.expect("Operational")
}
