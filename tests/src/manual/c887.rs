//! What the manual of the PI C-887.53x (C887T0011) prints.

#[cfg(test)]
mod checks;

use super::table::{Cells, Row, tables};
use super::{Access, Axes, Brake, Cell, Direction, ErrorKind, Pattern, Sub};

tables! { "c887",
    /// One row of the object dictionary in the appendix.
    Object in "objects.tsv" {
        /// Page of the manual.
        page: u8,
        /// Object range that the row stands under, such as `Mappings Rx` or `Axis U (ƟX)`; empty at the top.
        range: &'static str,
        /// Index.
        index: u16,
        /// Subindex.
        sub: Sub,
        /// Name.
        name: &'static str,
        /// Access; not printed for `0x1C32` and `0x1C33`.
        access: Option<Access>,
        /// Transition of the EtherCAT state machine in which the entry is written: `P->S` or nothing.
        writing: &'static str,
        /// First cell of the default: hexadecimal, decimal, a text or a mapped entry.
        hex: &'static str,
        /// Second cell of the default, in decimal.
        dec: Option<i64>,
        /// Data type as spelled there, `UNINT32` included; not printed for mappings and assignments.
        data_type: &'static str,
        /// Whether there is a comment.
        commented: bool,
        /// The comment in our own words.
        comment: &'static str,
    }
    /// An entry that a PDO maps.
    Mapped in "mapping.tsv" {
        /// Direction of the PDO.
        direction: Direction,
        /// Index of the PDO.
        pdo: u16,
        /// Subindex of the mapping, from 1.
        position: u8,
        /// Name of the mapping.
        name: &'static str,
        /// Index of the mapped entry.
        index: u16,
        /// Subindex of the mapped entry.
        subindex: u8,
        /// Size of the mapped entry in bits.
        bits: u8,
    }
    /// A place in the default assignment of the PDOs.
    Assigned in "assignment.tsv" {
        /// Direction.
        direction: Direction,
        /// Object that holds the assignment.
        object: u16,
        /// Subindex in it, from 1.
        position: u8,
        /// The assigned PDO; none in a place kept for the future.
        pdo: Option<u16>,
        /// Size of that PDO in bytes; a sum of ours, not a figure of the manual.
        bytes: u8,
    }
    /// A state of the drive.
    State in "states.tsv" {
        /// Name.
        name: &'static str,
        /// Bits 6 to 0 of the status word.
        pattern: Pattern,
    }
    /// A command to the drive.
    Command in "commands.tsv" {
        /// Name.
        name: &'static str,
        /// Bits 7 to 0 of the control word.
        pattern: Pattern,
        /// The transitions it triggers.
        transitions: Vec<u8>,
    }
    /// A transition of the drive, as the coupled axes make it.
    Transition in "transitions.tsv" {
        /// Number.
        transition: u8,
        /// How many axes have to make it.
        axes: Axes,
        /// The power level it switches to: `0`, `A`, `B` or `C`.
        power: &'static str,
    }
    /// What holds in a state of the drive.
    StateFeatures in "state_features.tsv" {
        /// Name of the state.
        state: &'static str,
        /// Brake.
        brake: Brake,
        /// Whether low-level power is applied.
        low_level_power: bool,
        /// Whether high-level power is applied.
        high_level_power: bool,
        /// Whether the drive function is enabled.
        drive_function: bool,
        /// Whether the drive may be configured.
        configuration: bool,
    }
    /// A value of `0x5013:01`.
    HexapodState in "hexapod_state.tsv" {
        /// Value.
        value: u8,
        /// State of the hexapod.
        state: &'static str,
    }
    /// A supported mode of operation.
    Mode in "modes.tsv" {
        /// Code in `0x6060`.
        code: u8,
        /// Name.
        name: &'static str,
        /// Its abbreviation, if there is one.
        short: &'static str,
        /// What it is for, in our own words.
        purpose: &'static str,
    }
    /// A change between modes of operation; the conditions are in our own words.
    ModeChange in "mode_changes.tsv" {
        /// Mode that is left.
        from: u8,
        /// Mode that is entered; none is any.
        to: Option<u8>,
        /// When the change succeeds.
        succeeds: &'static str,
        /// When it ends in transition 13.
        faults: &'static str,
    }
    /// A bit of the control word.
    ControlBit in "control_bits.tsv" {
        /// Bit.
        bit: u8,
        /// The mode it is described for; none for the figure of the whole word.
        mode: Option<u8>,
        /// Name, or `reserved`.
        name: &'static str,
        /// `rising` where only the rising edge counts.
        edge: &'static str,
    }
    /// A bit of the status word; its meanings are in our own words.
    StatusBit in "status_bits.tsv" {
        /// Bit.
        bit: u8,
        /// The mode it is described for; none for the figure of the whole word.
        mode: Option<u8>,
        /// Name, or `reserved`.
        name: &'static str,
        /// Meaning of 0, where there is one.
        zero: &'static str,
        /// Meaning of 1, where there is one.
        one: &'static str,
    }
    /// A row of the table of error codes, in the manual's order.
    ErrorCode in "errors.tsv" {
        /// What the row stands for.
        kind: ErrorKind,
        /// The code, or the first of the range.
        first: u16,
        /// The code again, or the last of the range.
        last: u16,
        /// Name.
        name: &'static str,
        /// The GCS errors it corresponds to.
        gcs: Vec<u16>,
        /// Value of the error register.
        register: Option<u8>,
        /// Whether there is a remark.
        remark: bool,
    }
    /// A bit of the error register `0x1001`.
    ErrorRegisterBit in "error_register.tsv" {
        /// Bit.
        bit: u8,
        /// Name.
        name: &'static str,
    }
    /// An error code of the GCS that belongs to the EtherCAT interface.
    GcsCode in "gcs_codes.tsv" {
        /// Code.
        code: u16,
        /// Constant.
        name: &'static str,
        /// What it says.
        description: &'static str,
        /// Where to read on, in our own words.
        notes: &'static str,
    }
    /// What an LED shows; patterns and meanings are in our own words.
    Led in "leds.tsv" {
        /// Name.
        led: &'static str,
        /// Colour.
        colour: &'static str,
        /// Pattern; empty for an LED that is not used.
        pattern: &'static str,
        /// Meaning.
        meaning: &'static str,
    }
    /// A way to stop a motion while operation is enabled, in our own words.
    StopOption in "stop_options.tsv" {
        /// What stops it.
        action: &'static str,
        /// The transitions it makes.
        transition: Vec<u8>,
        /// What the axes do.
        reaction: &'static str,
        /// How they do it by default; empty where the table does not say.
        default: &'static str,
    }
    /// A transition of the EtherCAT state machine.
    EsmTransition in "esm_transitions.tsv" {
        /// Initials of the two states, such as `PS`.
        transition: &'static str,
        /// What it does, in our own words.
        meaning: &'static str,
    }
    /// A single fact that stands in no table.
    Fact in "misc.tsv" {
        /// Our name for it.
        key: &'static str,
        /// Page of the manual.
        page: u8,
        /// The fact.
        value: &'static str,
    }
}

impl Object {
    /// The default as a number; none for a text, a mapped entry, or where no default is printed.
    ///
    /// It is the first cell that counts: three rows of `0x1C00` repeat it wrongly in decimal.
    #[must_use]
    pub fn default(&self) -> Option<i64> {
        i64::parse(self.hex).ok()
    }

    /// Which axis the row belongs to, from 0; none for the rows of the whole device.
    #[must_use]
    pub fn axis(&self) -> Option<usize> {
        let letter = self.range.strip_prefix("Axis ")?.chars().next()?;
        "XYZUVW".find(letter)
    }
}
