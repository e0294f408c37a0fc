//! What the EtherCAT manual of the Kollmorgen S300, S400, S600 and S700 (edition 07/2016) prints.

#[cfg(test)]
mod checks;

use super::table::{Cells, Row, tables};
use super::{Direction, Edge, Input, Member, Pattern, Sub, Word};

tables! { "s700",
    /// A cyclic value; two objects can share a row of the manual.
    Object in "objects.tsv" {
        /// Section.
        section: &'static str,
        /// `Rx` for setpoints, `Tx` for actual values.
        direction: Direction,
        /// Row of the section's table, from 1.
        row: u8,
        /// Index.
        index: u16,
        /// Subindex; [`Sub::Variable`] where none is printed.
        sub: Sub,
        /// Name.
        name: &'static str,
        /// Data type.
        data_type: &'static str,
        /// Unit, in our own words.
        unit: &'static str,
        /// The `OPMODE` that the setpoint serves.
        opmode: Option<u8>,
        /// The ASCII command that sets or reads the value.
        ascii: &'static str,
        /// Parameters that act on the value or its timing.
        parameters: Vec<&'static str>,
        /// Variables that record it.
        variables: Vec<&'static str>,
    }
    /// A pair of fixed PDOs.
    Interface in "interfaces.tsv" {
        /// Item of the list.
        item: u8,
        /// Title.
        title: &'static str,
        /// Receive PDO.
        rx: u16,
        /// Transmit PDO.
        tx: u16,
        /// Whether the transmit PDO is only named as an example.
        example: bool,
        /// The members that have it; none for all.
        members: Vec<Member>,
    }
    /// A fixed PDO.
    Pdo in "pdos.tsv" {
        /// Direction.
        direction: Direction,
        /// Index.
        pdo: u16,
        /// Items of the list that print it.
        items: Vec<u8>,
        /// The members that have it; none for all.
        members: Vec<Member>,
        /// The members whose default it is.
        default: Vec<Member>,
        /// Bytes in all, as the manual claims.
        total: u8,
    }
    /// An entry of a fixed PDO.
    Entry in "entries.tsv" {
        /// Index of the PDO.
        pdo: u16,
        /// Place in it, from 1.
        position: u8,
        /// Name; not the one of the object.
        name: &'static str,
        /// Size.
        bytes: u8,
    }
    /// A register or memory area of the slave controller.
    Register in "registers.tsv" {
        /// Address.
        address: u16,
        /// Bytes.
        length: u16,
        /// Name.
        name: &'static str,
        /// Access of the master.
        ecat: &'static str,
        /// Access of the drive.
        drive: &'static str,
    }
    /// A field of bits in a register.
    RegisterBits in "register_bits.tsv" {
        /// Address of the register.
        register: u16,
        /// Address that is printed beside the bits.
        address: u16,
        /// Lowest bit.
        first: u8,
        /// Highest bit.
        last: u8,
        /// Name.
        name: &'static str,
        /// Access of the drive.
        drive: &'static str,
        /// Access of the master.
        ecat: &'static str,
    }
    /// A value of bits 3 to 0 of AL Control or AL Status.
    AlState in "al_states.tsv" {
        /// Address of the register.
        register: u16,
        /// Value.
        value: u8,
        /// Name.
        name: &'static str,
    }
    /// An AL status code.
    AlCode in "al_codes.tsv" {
        /// Code.
        code: u16,
        /// Name.
        name: &'static str,
        /// The states, or the changes asked for, that it comes from.
        current: Vec<&'static str>,
        /// The state that results; `E` is the error bit.
        result: &'static str,
    }
    /// A transition of the EtherCAT state machine.
    EsmTransition in "esm_transitions.tsv" {
        /// Initials of the two states, such as `PS`.
        transition: &'static str,
        /// Bits 3 to 0 of AL Control that ask for it.
        al: Option<u8>,
        /// What it does, in our own words.
        meaning: &'static str,
    }
    /// What the bits of the control word must do for a transition.
    Transition in "transitions.tsv" {
        /// Number.
        transition: u8,
        /// Fault reset.
        bit7: Input,
        /// Enable operation.
        bit3: Input,
        /// Quick stop.
        bit2: Input,
        /// Enable voltage.
        bit1: Input,
        /// Switch on.
        bit0: Input,
    }
    /// A state of the drive.
    State in "states.tsv" {
        /// Name in the table of bits.
        name: &'static str,
        /// Bits 6 to 0 of the status word.
        pattern: Pattern,
        /// Name in the table of descriptions.
        described: &'static str,
    }
    /// What an edge in the control word does.
    ControlEdge in "control_edges.tsv" {
        /// Bit.
        bit: u8,
        /// Which edge.
        edge: Edge,
        /// The ASCII command that it sends.
        ascii: &'static str,
        /// What it does, in our own words.
        meaning: &'static str,
    }
    /// A bit of the control word that has a name.
    ControlBit in "control_bits.tsv" {
        /// Bit.
        bit: u8,
        /// Name.
        name: &'static str,
    }
    /// A bit of the status word.
    StatusBit in "status_bits.tsv" {
        /// Bit.
        bit: u8,
        /// Name.
        name: &'static str,
        /// When it holds, in our own words.
        note: &'static str,
    }
    /// A bit or value of a latch word.
    LatchBits in "latch_bits.tsv" {
        /// Which latch word.
        word: Word,
        /// Lowest bit of the field.
        first: u8,
        /// Highest bit of the field.
        last: u8,
        /// The value in binary; none for reserved bits.
        binary: Option<Pattern>,
        /// The value in hexadecimal, with an `x` for each digit that does not matter.
        hex: &'static str,
        /// Name.
        name: &'static str,
    }
    /// A bit of a digital input or output object.
    IoBit in "io_bits.tsv" {
        /// Index.
        index: u16,
        /// Bit.
        bit: u8,
        /// Name.
        name: &'static str,
        /// The members that have it; none for all.
        members: Vec<Member>,
    }
    /// A supported mode of operation.
    Mode in "modes.tsv" {
        /// Name.
        name: &'static str,
        /// Code of the profile.
        code: u8,
        /// Code of the manufacturer, as the byte of a negative number.
        vendor: u8,
    }
    /// The shortest recommended cycle.
    CycleTime in "cycle_times.tsv" {
        /// Which kind of setpoint.
        interface: &'static str,
        /// The members it holds for.
        members: Vec<Member>,
        /// Microseconds.
        min_us: u16,
    }
    /// The cycle of values that are not processed in the bus cycle.
    SlowCycle in "slow_cycles.tsv" {
        /// The members it holds for.
        members: Vec<Member>,
        /// Items of the fixed PDOs; none for all.
        mappings: Vec<u8>,
        /// Microseconds.
        cycle_us: u16,
    }
    /// A step in which a mapping is chosen.
    MappingStep in "mapping_steps.tsv" {
        /// `fixed` or `free`.
        mapping: &'static str,
        /// Step, from 1.
        step: u8,
        /// Index that is written.
        index: u16,
        /// Subindex, where it is one.
        sub: Option<u8>,
        /// Data, where given.
        data: Option<u16>,
    }
    /// A row of the start-up list in the example of a free mapping.
    Startup in "startup.tsv" {
        /// Transition.
        transition: &'static str,
        /// Whether the configurator made the row.
        generated: bool,
        /// Index as printed, misprints included.
        printed: &'static str,
        /// The index that it must mean.
        index: u16,
        /// Subindex.
        sub: u8,
        /// Data in hexadecimal as printed.
        data: &'static str,
        /// The data that it must mean.
        value: u32,
        /// Data in decimal as printed; long numbers are cut.
        decimal: &'static str,
        /// Comment.
        comment: &'static str,
    }
    /// A byte of the mailbox example.
    MailboxByte in "mailbox.tsv" {
        /// `request` or `answer`.
        telegram: &'static str,
        /// Byte.
        byte: u8,
        /// Value.
        value: u8,
        /// Meaning, in short.
        meaning: &'static str,
    }
    /// A field of a mailbox telegram.
    TelegramField in "telegram.tsv" {
        /// `output` or `input`, seen from the master.
        mailbox: &'static str,
        /// The byte by the example.
        byte: u8,
        /// The byte that the text stands beside.
        printed: u8,
        /// Lowest bit.
        first: u8,
        /// Highest bit.
        last: u8,
        /// Name.
        name: &'static str,
    }
    /// A value of a field of a mailbox telegram.
    TelegramValue in "telegram_values.tsv" {
        /// `output` or `input`, seen from the master.
        mailbox: &'static str,
        /// The byte by the example.
        byte: u8,
        /// Field.
        field: &'static str,
        /// Value.
        value: u8,
        /// Name.
        name: &'static str,
        /// Whether it is reserved.
        reserved: bool,
    }
    /// What an LED shows.
    Led in "leds.tsv" {
        /// Name.
        led: &'static str,
        /// Pattern.
        pattern: &'static str,
        /// Meaning.
        meaning: &'static str,
    }
    /// A single fact that stands in no table.
    Fact in "misc.tsv" {
        /// Our name for it.
        key: &'static str,
        /// Section.
        section: &'static str,
        /// The fact.
        value: &'static str,
    }
}
