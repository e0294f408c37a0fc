//! Traces, read by a crate that knows nothing of ours.

use std::time::Duration;

use devc_virtual::{Trace, Way};
use pcap_file::pcapng::{Block, PcapNgReader};

use crate::master::{BRD, Datagram, frame};

#[test]
fn a_trace_is_read_by_others() {
    let mut file = Vec::new();
    let mut trace = Trace::begin(&mut file, "veth1", "devc, a test").unwrap();
    // 46 bytes, and a length that is no multiple of four
    let frames = [frame(&[Datagram::new(BRD, 0, 0, &[0])]), frame(&[Datagram::new(BRD, 0, 0, &[7; 51])])];
    let begin = Duration::new(1_800_000_000, 123_456_789);
    for (frame, way) in frames.iter().zip([Way::In, Way::Out]) {
        trace.frame(begin, way, frame).unwrap();
    }
    trace.flush().unwrap();

    let mut reader = PcapNgReader::new(file.as_slice()).unwrap();
    let mut packets = Vec::new();
    while let Some(block) = reader.next_block() {
        if let Block::EnhancedPacket(packet) = block.unwrap() {
            packets.push((packet.timestamp, packet.original_len as usize, packet.data.into_owned()));
        }
    }
    let expected = frames.map(|frame| (begin, frame.len(), frame));
    assert_eq!(packets, expected);
    let interface = &reader.interfaces()[0];
    assert_eq!(interface.linktype, pcap_file::DataLink::ETHERNET);
    assert!(interface.options.iter().any(|option| format!("{option:?}").contains("veth1")));
}
