//! A small part of the PI C-887 in the shape that devc generates: axes X and Y, a PDO of each direction.
//! Source: PI C887T0011, 3/14/2024. Generated code is public, whoever includes it may use only some of it.
#![allow(unreachable_pub, dead_code)]

use devc_runtime::Device;
use devc_runtime::cia402::{
    Command, Coupling, Edge, Mode, Pattern, State, StatePatterns, StateSet, Transition, UnknownMode,
    UnknownState,
};
use devc_runtime::error::{self, ErrorInfo, ErrorRange};
use devc_runtime::object::{Address, Constant, Entry, ReadOnly, ReadWrite, Value};
use devc_runtime::pdo::{Mapping, Pdo, Rx, Tx};
use devc_runtime::sdo::{Access, DataType, Dictionary, EntryInfo, NONE, ObjectCode, ObjectInfo, Page};
use devc_runtime::unit::Scale;

/// The hexapod controller C-887.53x.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct C887;

impl Device for C887 {
    const NAME: &'static str = "C-887.53x";
    const VENDOR_ID: u32 = 0x0000_076D;
    const PRODUCT_CODE: u32 = 0x0000_0003;
    const REVISION: u32 = 0x0000_0000;
}

/// The axes of the platform; objects of the profile are 0x800 apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u16)]
pub enum Axis {
    /// Along X.
    X = 0x0000,
    /// Along Y.
    Y = 0x0800,
}

impl Axis {
    /// Every axis, in order.
    pub const ALL: [Self; 2] = [Self::X, Self::Y];

    const fn index(self, first: u16) -> u16 {
        first | self as u16
    }
}

/// The objects, as a master reads and writes them.
pub mod objects {
    use super::*;

    /// `0x1008:00` Manufacturer device name.
    pub const DEVICE_NAME: Entry<C887, str, Constant> = Entry::new(0x1008, 0);

    /// `0x6040:00` Controlword.
    pub const fn controlword(axis: Axis) -> Entry<C887, Controlword, ReadWrite> {
        Entry::new(axis.index(0x6040), 0)
    }

    /// `0x6041:00` Statusword.
    pub const fn statusword(axis: Axis) -> Entry<C887, Statusword, ReadOnly> {
        Entry::new(axis.index(0x6041), 0)
    }

    /// `0x6060:00` Modes of operation.
    pub const fn modes_of_operation(axis: Axis) -> Entry<C887, i8, ReadWrite> {
        Entry::new(axis.index(0x6060), 0)
    }

    /// `0x6061:00` Modes of operation display.
    pub const fn modes_of_operation_display(axis: Axis) -> Entry<C887, i8, ReadOnly> {
        Entry::new(axis.index(0x6061), 0)
    }

    /// `0x6064:00` Position actual value, in mm ÷ 100 000.
    pub const fn position_actual_value(axis: Axis) -> Entry<C887, i32, ReadOnly> {
        Entry::new(axis.index(0x6064), 0)
    }

    /// `0x607A:00` Target position, in mm ÷ 100 000.
    pub const fn target_position(axis: Axis) -> Entry<C887, i32, ReadWrite> {
        Entry::new(axis.index(0x607A), 0)
    }

    /// `0x607D` Software position limit.
    pub mod software_position_limit {
        use super::*;

        /// `0x607D:01` Min position limit.
        pub const fn min(axis: Axis) -> Entry<C887, i32, ReadWrite> {
            Entry::new(axis.index(0x607D), 1)
        }

        /// `0x607D:02` Max position limit.
        pub const fn max(axis: Axis) -> Entry<C887, i32, ReadWrite> {
            Entry::new(axis.index(0x607D), 2)
        }
    }
}

/// Positions in process data, in micrometres.
pub const POSITION: Scale = Scale::of::<1, 100>();

/// `0x6040` Controlword.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Controlword(pub u16);

/// `0x6041` Statusword.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Statusword(pub u16);

impl Statusword {
    /// The state that bits 0 to 6 show.
    pub fn state(self) -> Result<State, UnknownState> {
        STATES.decode(self.0)
    }

    /// Bit 7, warning.
    pub const fn warning(self) -> bool {
        self.0 & 1 << 7 != 0
    }
}

impl Value for Controlword {
    type Bytes = [u8; 2];
    const DATA_TYPE: DataType = DataType::UNSIGNED16;
    fn to_bytes(self) -> [u8; 2] {
        self.0.to_le_bytes()
    }
    fn from_bytes(bytes: [u8; 2]) -> Self {
        Self(u16::from_le_bytes(bytes))
    }
}

impl Value for Statusword {
    type Bytes = [u8; 2];
    const DATA_TYPE: DataType = DataType::UNSIGNED16;
    fn to_bytes(self) -> [u8; 2] {
        self.0.to_le_bytes()
    }
    fn from_bytes(bytes: [u8; 2]) -> Self {
        Self(u16::from_le_bytes(bytes))
    }
}

/// `0x1600` RxPDO - CSP, 7 bytes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RxPdo1600 {
    /// `0x6040:00`
    pub controlword: Controlword,
    /// `0x6060:00`
    pub modes_of_operation: i8,
    /// `0x607A:00`
    pub target_position: i32,
}

impl RxPdo1600 {
    /// The fields as they are in the frame.
    #[inline]
    pub const fn pack(self) -> [u8; 7] {
        let [a0, a1] = self.controlword.0.to_le_bytes();
        let [b0] = self.modes_of_operation.to_le_bytes();
        let [c0, c1, c2, c3] = self.target_position.to_le_bytes();
        [a0, a1, b0, c0, c1, c2, c3]
    }

    /// The fields out of the frame.
    #[inline]
    pub const fn unpack([a0, a1, b0, c0, c1, c2, c3]: [u8; 7]) -> Self {
        Self {
            controlword: Controlword(u16::from_le_bytes([a0, a1])),
            modes_of_operation: i8::from_le_bytes([b0]),
            target_position: i32::from_le_bytes([c0, c1, c2, c3]),
        }
    }
}

devc_runtime::process_data!(RxPdo1600: C887, Rx, 7);

devc_runtime::view! {
    pub RxPdo1600View of RxPdo1600, 7;
    controlword, set_controlword: Controlword => 0, 16;
    modes_of_operation, set_modes_of_operation: i8 => 16, 8;
    target_position, set_target_position: i32 => 24, 32;
}

impl Pdo for RxPdo1600 {
    const INDEX: u16 = 0x1600;
    const MAPPING: &'static [Mapping] = &[
        Mapping { address: Address::new(0x6040, 0), bits: 16 },
        Mapping { address: Address::new(0x6060, 0), bits: 8 },
        Mapping { address: Address::new(0x607A, 0), bits: 32 },
    ];
}

/// `0x1A00` TxPDO - CSP, 11 bytes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TxPdo1A00 {
    /// `0x6041:00`
    pub statusword: Statusword,
    /// `0x6061:00`
    pub modes_of_operation_display: i8,
    /// `0x6064:00`
    pub position_actual_value: i32,
    /// `0x60F4:00`
    pub following_error_actual_value: i32,
}

impl TxPdo1A00 {
    /// The fields as they are in the frame.
    #[inline]
    pub const fn pack(self) -> [u8; 11] {
        let [a0, a1] = self.statusword.0.to_le_bytes();
        let [b0] = self.modes_of_operation_display.to_le_bytes();
        let [c0, c1, c2, c3] = self.position_actual_value.to_le_bytes();
        let [d0, d1, d2, d3] = self.following_error_actual_value.to_le_bytes();
        [a0, a1, b0, c0, c1, c2, c3, d0, d1, d2, d3]
    }

    /// The fields out of the frame.
    #[inline]
    pub const fn unpack([a0, a1, b0, c0, c1, c2, c3, d0, d1, d2, d3]: [u8; 11]) -> Self {
        Self {
            statusword: Statusword(u16::from_le_bytes([a0, a1])),
            modes_of_operation_display: i8::from_le_bytes([b0]),
            position_actual_value: i32::from_le_bytes([c0, c1, c2, c3]),
            following_error_actual_value: i32::from_le_bytes([d0, d1, d2, d3]),
        }
    }

    /// The mode that the device shows.
    pub fn mode(self) -> Result<ModeOfOperation, UnknownMode> {
        ModeOfOperation::decode(self.modes_of_operation_display)
    }
}

devc_runtime::process_data!(TxPdo1A00: C887, Tx, 11);

devc_runtime::view! {
    pub TxPdo1A00View of TxPdo1A00, 11;
    statusword, set_statusword: Statusword => 0, 16;
    modes_of_operation_display, set_modes_of_operation_display: i8 => 16, 8;
    position_actual_value, set_position_actual_value: i32 => 24, 32;
    following_error_actual_value, set_following_error_actual_value: i32 => 56, 32;
}

impl Pdo for TxPdo1A00 {
    const INDEX: u16 = 0x1A00;
    const MAPPING: &'static [Mapping] = &[
        Mapping { address: Address::new(0x6041, 0), bits: 16 },
        Mapping { address: Address::new(0x6061, 0), bits: 8 },
        Mapping { address: Address::new(0x6064, 0), bits: 32 },
        Mapping { address: Address::new(0x60F4, 0), bits: 32 },
    ];
}

/// How the statusword shows the states (figure 9).
pub const STATES: StatePatterns = StatePatterns(&[
    (State::NotReadyToSwitchOn, Pattern { mask: 0x007F, value: 0x0000 }),
    (State::SwitchOnDisabled, Pattern { mask: 0x007F, value: 0x0040 }),
    (State::ReadyToSwitchOn, Pattern { mask: 0x007F, value: 0x0021 }),
    (State::SwitchedOn, Pattern { mask: 0x007F, value: 0x0033 }),
    (State::OperationEnabled, Pattern { mask: 0x007F, value: 0x0037 }),
    (State::QuickStopActive, Pattern { mask: 0x007F, value: 0x0017 }),
    (State::FaultReactionActive, Pattern { mask: 0x004F, value: 0x000F }),
    (State::Fault, Pattern { mask: 0x007F, value: 0x0008 }),
]);

/// The commands of the controlword (figure 6).
pub mod commands {
    use super::*;

    const fn command(name: &'static str, mask: u16, value: u16, transitions: &'static [u8]) -> Command {
        let ignored_in = StateSet::NONE;
        Command { name, pattern: Pattern { mask, value }, edge: None, transitions, ignored_in }
    }

    /// Shutdown.
    pub const SHUTDOWN: Command = command("shutdown", 0x0087, 0x0006, &[2, 6, 8]);
    /// Switch on.
    pub const SWITCH_ON: Command = command("switch on", 0x008F, 0x0007, &[3]);
    /// Disable voltage.
    pub const DISABLE_VOLTAGE: Command = command("disable voltage", 0x0082, 0x0000, &[7, 9, 10, 12]);
    /// Quick stop.
    pub const QUICK_STOP: Command = command("quick stop", 0x0086, 0x0002, &[11]);
    /// Disable operation.
    pub const DISABLE_OPERATION: Command = command("disable operation", 0x008F, 0x0007, &[5]);
    /// Enable operation.
    pub const ENABLE_OPERATION: Command = command("enable operation", 0x008F, 0x000F, &[4]);
    /// Fault reset.
    pub const FAULT_RESET: Command =
        Command { edge: Some(Edge::Rising(0x0080)), ..command("fault reset", 0x0080, 0x0080, &[15]) };

    /// Every command.
    pub const ALL: &[Command] =
        &[SHUTDOWN, SWITCH_ON, DISABLE_VOLTAGE, QUICK_STOP, DISABLE_OPERATION, ENABLE_OPERATION, FAULT_RESET];
}

/// The transitions and which axes have to make them; 16 is not supported.
pub const TRANSITIONS: &[Transition] = {
    use Coupling::{All, Any};
    use State::*;
    const fn from(state: State) -> StateSet {
        StateSet::NONE.with(state)
    }
    &[
        Transition { number: 0, from: StateSet::NONE, to: NotReadyToSwitchOn, coupling: All },
        Transition { number: 1, from: from(NotReadyToSwitchOn), to: SwitchOnDisabled, coupling: All },
        Transition { number: 2, from: from(SwitchOnDisabled), to: ReadyToSwitchOn, coupling: All },
        Transition { number: 3, from: from(ReadyToSwitchOn), to: SwitchedOn, coupling: All },
        Transition { number: 4, from: from(SwitchedOn), to: OperationEnabled, coupling: All },
        Transition { number: 5, from: from(OperationEnabled), to: SwitchedOn, coupling: Any },
        Transition { number: 6, from: from(SwitchedOn), to: ReadyToSwitchOn, coupling: Any },
        Transition { number: 7, from: from(ReadyToSwitchOn), to: SwitchOnDisabled, coupling: Any },
        Transition { number: 8, from: from(OperationEnabled), to: ReadyToSwitchOn, coupling: Any },
        Transition { number: 9, from: from(OperationEnabled), to: SwitchOnDisabled, coupling: Any },
        Transition { number: 10, from: from(SwitchedOn), to: SwitchOnDisabled, coupling: Any },
        Transition { number: 11, from: from(OperationEnabled), to: QuickStopActive, coupling: Any },
        Transition { number: 12, from: from(QuickStopActive), to: SwitchOnDisabled, coupling: Any },
        Transition {
            number: 13,
            from: StateSet::ALL.without(FaultReactionActive).without(Fault),
            to: FaultReactionActive,
            coupling: Any,
        },
        Transition { number: 14, from: from(FaultReactionActive), to: Fault, coupling: All },
        Transition {
            number: 15,
            from: StateSet::ALL.without(SwitchOnDisabled).without(FaultReactionActive),
            to: SwitchOnDisabled,
            coupling: All,
        },
    ]
};

/// `0x6060` The modes of operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(i8)]
pub enum ModeOfOperation {
    /// No mode: targets are ignored.
    None = 0,
    /// Homing.
    Homing = 6,
    /// Cyclic synchronous position.
    CyclicSynchronousPosition = 8,
}

impl Mode for ModeOfOperation {
    fn code(self) -> i8 {
        self as i8
    }
    fn from_code(code: i8) -> Option<Self> {
        match code {
            0 => Some(Self::None),
            6 => Some(Self::Homing),
            8 => Some(Self::CyclicSynchronousPosition),
            _ => None,
        }
    }
    fn name(self) -> &'static str {
        match self {
            Self::None => "no mode",
            Self::Homing => "homing",
            Self::CyclicSynchronousPosition => "cyclic synchronous position",
        }
    }
}

/// `0x603F` The error code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ErrorCode(pub u16);

impl ErrorCode {
    /// No error.
    pub const NO_ERROR: Self = Self(0x0000);
    /// Motor blocked.
    pub const MOTOR_BLOCKED: Self = Self(0x7121);
    /// Safety stop triggered.
    pub const SAFETY_STOP_TRIGGERED: Self = Self(0xFF50);
}

impl error::ErrorCode for ErrorCode {
    const TABLE: &'static [ErrorInfo] = &[
        ErrorInfo { code: 0x0000, name: "no error", register: Some(0x00), vendor_codes: &[], text: "" },
        ErrorInfo {
            code: 0x7121,
            name: "motor blocked",
            register: Some(0x81),
            vendor_codes: &[657],
            text: "safety stop, because a motor is stuck",
        },
        ErrorInfo {
            code: 0xFF50,
            name: "safety stop triggered",
            register: Some(0x81),
            vendor_codes: &[500, 501, 657],
            text: "by the E-stop socket",
        },
    ];
    const RANGES: &'static [ErrorRange] =
        &[ErrorRange { first: 0xFF00, last: 0xFFFF, name: "manufacturer-specific error" }];
    fn code(self) -> u16 {
        self.0
    }
}

impl core::fmt::Display for ErrorCode {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        error::display(*self).fmt(f)
    }
}

const fn entry(subindex: u8, item: u8, data_type: DataType, bits: u16, access: Access) -> EntryInfo {
    EntryInfo { subindex, item, data_type, bits, access }
}

const fn variable(field: u16, entries: &'static [EntryInfo]) -> ObjectInfo {
    ObjectInfo { code: ObjectCode::Variable, axis: 0, field, entries, constants: 0 }
}

const READ_WRITE: Access = Access::READ.and(Access::WRITE);

/// The objects of an axis, the same for each.
static AXIS_OBJECTS: [ObjectInfo; 7] = [
    variable(1, &[entry(0, 0, DataType::UNSIGNED16, 16, READ_WRITE.and(Access::RX_PDO))]),
    variable(2, &[entry(0, 0, DataType::UNSIGNED16, 16, Access::READ.and(Access::TX_PDO))]),
    variable(3, &[entry(0, 0, DataType::INTEGER8, 8, READ_WRITE.and(Access::RX_PDO))]),
    variable(4, &[entry(0, 0, DataType::INTEGER8, 8, Access::READ.and(Access::TX_PDO))]),
    variable(5, &[entry(0, 0, DataType::INTEGER32, 32, Access::READ.and(Access::TX_PDO))]),
    variable(6, &[entry(0, 0, DataType::INTEGER32, 32, READ_WRITE.and(Access::RX_PDO))]),
    ObjectInfo {
        code: ObjectCode::Record,
        axis: 0,
        field: 7,
        entries: &[
            entry(0, EntryInfo::CONSTANT, DataType::UNSIGNED8, 8, Access::READ),
            entry(1, 0, DataType::INTEGER32, 32, READ_WRITE),
            entry(2, 1, DataType::INTEGER32, 32, READ_WRITE),
        ],
        constants: 0,
    },
];

/// Where they are, from 0x..40 on.
#[rustfmt::skip]
static AXIS_SLOTS: [u8; 62] = {
    const __: u8 = NONE;
    [
         0,  1, __, __, __, __, __, __, __, __, __, __, __, __, __, __, // 40
        __, __, __, __, __, __, __, __, __, __, __, __, __, __, __, __, // 50
         2,  3, __, __,  4, __, __, __, __, __, __, __, __, __, __, __, // 60
        __, __, __, __, __, __, __, __, __, __,  5, __, __,  6, // 70
    ]
};

/// Every object.
pub static DICTIONARY: Dictionary = Dictionary {
    constants: &[2],
    directory: &{
        let mut pages = [NONE; 256];
        pages[0x10] = 0;
        pages[0x60] = 1;
        pages[0x68] = 2;
        pages
    },
    pages: &[
        Page {
            first: 0x08,
            axis: 0,
            slots: &[0],
            objects: &[variable(0, &[entry(0, 0, DataType::VISIBLE_STRING, 14 * 8, Access::READ)])],
        },
        Page { first: 0x40, axis: 0, slots: &AXIS_SLOTS, objects: &AXIS_OBJECTS },
        Page { first: 0x40, axis: 1, slots: &AXIS_SLOTS, objects: &AXIS_OBJECTS },
    ],
};
