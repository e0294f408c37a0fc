//! What the CiA 402 manual of the Pilz PMC SC6 and PMC SI6 (1005347-en-US-02) prints.

#[cfg(test)]
mod checks;

use super::table::{Cells, Row, tables};
use super::{AxisLetter, Direction, Edge, Input, Pattern, Sub, Word};

tables! { "pmc-sc6",
    /// An entry of the profile's objects, or the head of an object that has several.
    Object in "objects.tsv" {
        /// Table: 34 is axis A, 35 axis B.
        table: u8,
        /// Index.
        index: u16,
        /// Subindex; [`Sub::Variable`] for the head.
        sub: Sub,
        /// Name.
        name: &'static str,
        /// Whether a `TxPDO` can hold it; none for the head.
        tx: Option<bool>,
        /// Whether an `RxPDO` can hold it; none for the head.
        rx: Option<bool>,
        /// Array, Record or Structure, for the head.
        shape: &'static str,
        /// Number of elements, for the head.
        elements: Option<u8>,
        /// Value of subindex 0, where it counts.
        constant: Option<u8>,
        /// Coordinate of the parameter.
        parameter: &'static str,
        /// Limits of its function, in our own words.
        note: &'static str,
    }
    /// An entry of a default mapping.
    Mapped in "pdos.tsv" {
        /// Table.
        table: u8,
        /// `standard`, or the mode that needs a mapping of its own.
        mapping: &'static str,
        /// Axis.
        axis: AxisLetter,
        /// Direction.
        direction: Direction,
        /// First byte, from 0.
        first: u8,
        /// Last byte.
        last: u8,
        /// Data type.
        data_type: &'static str,
        /// Name.
        name: &'static str,
        /// Axis and coordinate of the parameter.
        parameter: &'static str,
        /// The profile's object; none for a parameter of the manufacturer.
        object: Option<u16>,
    }
    /// A group of parameters in the dictionary.
    Group in "groups.tsv" {
        /// Table: 37 is axis A, 39 axis B.
        table: u8,
        /// Axis.
        axis: AxisLetter,
        /// First index.
        first: u16,
        /// Last index.
        last: u16,
        /// Letter.
        letter: &'static str,
        /// Name.
        name: &'static str,
        /// Number in the formula.
        number: u16,
        /// First parameter.
        lowest: &'static str,
        /// Last parameter.
        highest: &'static str,
    }
    /// A group of parameters in the configurator.
    GroupTopic in "group_topics.tsv" {
        /// Letter.
        letter: &'static str,
        /// Topic.
        topic: &'static str,
    }
    /// The calculation of an index.
    Coordinate in "coordinates.tsv" {
        /// Axis.
        axis: AxisLetter,
        /// What is added.
        base: u16,
        /// What the number of the group is multiplied by.
        factor: u16,
        /// The parameter of the example.
        parameter: &'static str,
        /// Its group.
        group: u16,
        /// Its line.
        line: u16,
        /// Its index.
        index: u16,
        /// Its subindex with the template EtherCAT Rx.
        rx: u8,
        /// Its subindex with the template EtherCAT Rx SDO Info.
        sdo_info: u8,
    }
    /// A command to the drive.
    Command in "commands.tsv" {
        /// Name.
        name: &'static str,
        /// Bits 7 to 0 of the control word.
        pattern: Pattern,
    }
    /// A transition of the drive; what brings it about is in our own words.
    Transition in "transitions.tsv" {
        /// Number.
        transition: u8,
        /// State that is left.
        from: &'static str,
        /// State that is entered.
        to: &'static str,
        /// The command, if there is one.
        command: &'static str,
        /// The additional enable signal: `active` is needed, `inactive` is enough.
        enable: &'static str,
        /// Condition.
        condition: &'static str,
    }
    /// What holds in a state of the drive; none is not given.
    StateFeatures in "state_features.tsv" {
        /// Name of the state.
        state: &'static str,
        /// Whether the power unit is on.
        power_unit: Option<bool>,
        /// Whether the drive function is enabled.
        drive_function: Option<bool>,
        /// Whether the activation function is enabled.
        activation_function: Option<bool>,
        /// The brake, in our own words.
        brake: &'static str,
    }
    /// A cause of the state Switch on disabled, in our own words.
    LockoutCause in "lockout_causes.tsv" {
        /// Number.
        number: u8,
        /// Cause.
        cause: &'static str,
    }
    /// A mode of operation.
    Mode in "modes.tsv" {
        /// Code.
        code: i8,
        /// Name.
        name: &'static str,
        /// Its abbreviation, if there is one.
        short: &'static str,
        /// Who calculates the motion: `controller`, `drive` or, outside of production, neither.
        control: &'static str,
    }
    /// A bit of the control or status word in a mode; meanings are in our own words.
    ModeBit in "mode_bits.tsv" {
        /// Table.
        table: u8,
        /// Code of the mode.
        mode: i8,
        /// Which word.
        word: Word,
        /// Bit.
        bit: u8,
        /// Name.
        name: &'static str,
        /// The edge that counts, if it is one.
        edge: Option<Edge>,
        /// The parameter that selects the signal.
        source: &'static str,
        /// Meaning of 0.
        zero: &'static str,
        /// Meaning of 1.
        one: &'static str,
    }
    /// A combination of bits in homing mode.
    HomingWord in "homing_words.tsv" {
        /// Homing error.
        bit13: Input,
        /// Homing attained.
        bit12: Input,
        /// Target reached.
        bit10: Input,
        /// Meaning.
        meaning: &'static str,
    }
    /// The motion command that a mode of operation stands for.
    Motion in "motion.tsv" {
        /// Code of the mode.
        mode: i8,
        /// Bits and parameters that choose between commands.
        settings: &'static str,
        /// Number of the command.
        code: Option<u8>,
        /// Command.
        command: &'static str,
        /// Control type.
        control: &'static str,
        /// Variables that it needs.
        variables: Vec<&'static str>,
        /// Whether it needs cyclic set values.
        cyclic: bool,
    }
    /// A homing method.
    Homing in "homing.tsv" {
        /// Letter.
        method: &'static str,
        /// Codes of it, the usual one first.
        codes: Vec<i8>,
        /// Name.
        name: &'static str,
        /// Initial movement.
        direction: &'static str,
        /// Whether it needs a zero pulse.
        zero_pulse: bool,
        /// What it looks for.
        feature: &'static str,
        /// Parameters to set before.
        prepared: Vec<&'static str>,
        /// Starting positions that are told apart.
        variants: u8,
    }
    /// A cause that a parameter shows or an event carries.
    Cause in "causes.tsv" {
        /// Section.
        section: &'static str,
        /// The parameter or event.
        place: &'static str,
        /// Value.
        code: u8,
        /// Name.
        name: &'static str,
    }
    /// A comparison of the actual position with a software limit switch.
    LimitCondition in "limit_conditions.tsv" {
        /// Section.
        section: &'static str,
        /// What follows: `fault` or `unlock`.
        effect: &'static str,
        /// Which limit switch.
        switch: &'static str,
        /// How the position must stand to the limit.
        relation: &'static str,
        /// Whether the window is added or subtracted.
        window: &'static str,
    }
    /// A possible cycle time.
    CycleTime in "cycle_times.tsv" {
        /// What is processed.
        signal: &'static str,
        /// Microseconds.
        cycle_us: u16,
        /// The parameter that selects it.
        parameter: &'static str,
    }
    /// A range of values of the PDO timeout.
    PdoTimeout in "pdo_timeout.tsv" {
        /// First value.
        first: u16,
        /// Last value.
        last: u16,
        /// Whether there is monitoring.
        monitoring: bool,
        /// Meaning, in our own words.
        meaning: &'static str,
    }
    /// A data type of parameters.
    DataType in "data_types.tsv" {
        /// Name.
        name: &'static str,
        /// Types of parameters that use it.
        parameter_types: Vec<&'static str>,
        /// Size.
        bits: u16,
        /// Whether it has a sign; none where that says nothing.
        signed: Option<bool>,
        /// Smallest value.
        min: &'static str,
        /// Largest value.
        max: &'static str,
    }
    /// An array parameter that holds the entries of a PDO.
    MappingParameter in "mapping_parameters.tsv" {
        /// Direction.
        direction: Direction,
        /// Axis.
        axis: AxisLetter,
        /// Coordinate.
        parameter: &'static str,
        /// First element.
        first: u8,
        /// Last element.
        last: u8,
    }
    /// A transition in which entries of the start-up list can be written.
    StartupTransition in "startup_transitions.tsv" {
        /// Initials of the two states, such as `PS`.
        transition: &'static str,
    }
    /// A parameter of the manufacturer that the text names.
    Parameter in "parameters.tsv" {
        /// Coordinate.
        parameter: &'static str,
        /// A section that names it.
        section: &'static str,
        /// Name, where one is printed.
        name: &'static str,
    }
    /// A bit of the first touch probe, in our own words.
    TouchProbeBit in "touch_probe_bits.tsv" {
        /// Coordinate of the word.
        parameter: &'static str,
        /// Bit.
        bit: u8,
        /// Meaning of 0.
        zero: &'static str,
        /// Meaning of 1.
        one: &'static str,
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
