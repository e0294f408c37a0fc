//! The Ethernet frame around datagrams.

use super::Datagrams;

/// Where the type of an Ethernet frame is, behind the two addresses.
const TYPE: usize = 12;
const VLAN_TAG: [u8; 2] = [0x81, 0x00];
const ETHERCAT: [u8; 2] = [0x88, 0xA4];

/// The datagrams of an Ethernet frame; none if it is not one of EtherCAT.
pub(crate) fn datagrams(frame: &mut [u8]) -> Option<Datagrams<'_>> {
    let (_, tagged) = frame.split_at_mut_checked(TYPE)?;
    let tag = if tagged.starts_with(&VLAN_TAG) { 4 } else { 0 };
    let (ethertype, rest) = tagged.get_mut(tag..)?.split_first_chunk_mut::<2>()?;
    let (header, rest) = rest.split_first_chunk_mut::<2>()?;
    let header = u16::from_le_bytes(*header);
    if *ethertype != ETHERCAT || header >> 12 != 1 {
        return None;
    }
    // less than the header says: as much as there is
    let length = usize::from(header & 0x07FF).min(rest.len());
    Some(Datagrams::new(rest.get_mut(..length)?))
}

/// Sets bit 1 of the first byte of the source address, as the first subdevice does. Masters tell by it that a frame has been
/// on its way, and drop what comes back as they sent it.
pub(crate) fn mark_returned(frame: &mut [u8]) {
    if let Some(first) = frame.get_mut(6) {
        *first |= 0x02;
    }
}
