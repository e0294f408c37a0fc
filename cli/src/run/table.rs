//! The devices as a table, as they are at present.

use devc::text::characters::line;
use devc_virtual::drive::AxisStatus;

/// A device, and what there is to say of it.
#[derive(Debug)]
pub(super) struct Shown<'a> {
    pub(super) name: &'a str,
    pub(super) state: &'static str,
    pub(super) axes: Vec<AxisStatus>,
    /// How regularly process data comes, if that is wanted.
    pub(super) cycles: Option<&'a str>,
}

/// The columns, and whether each has its numbers to the right.
const COLUMNS: [(&str, bool); 8] = [
    ("", true),
    ("device", false),
    ("state", false),
    ("axis", false),
    ("state", false),
    ("position", true),
    ("error", false),
    ("mode", false),
];

type Cells = [String; COLUMNS.len()];

/// Rows of a terminal that is so wide and so high: a head, each axis of each device, and what is said of the cycles. Columns that
/// are empty are left out.
pub(super) fn rows(devices: &[Shown<'_>], (width, height): (usize, usize)) -> Vec<String> {
    let head = COLUMNS.map(|(name, _)| name.to_owned());
    let axes = devices.iter().enumerate().flat_map(|(position, device)| cells(position, device));
    let cells: Vec<Cells> = std::iter::once(head).chain(axes).collect();
    let widths = widths(&cells);
    let axes = cells.iter().map(|cells| row(cells, &widths));
    let cycles = devices.iter().enumerate().filter_map(|(position, device)| {
        Some(format!("{position}  {}: {}", line(device.name), device.cycles?))
    });
    let mut rows: Vec<String> = axes.chain(cycles).map(|row| row.chars().take(width).collect()).collect();
    // the cursor stands on a row of its own
    let room = height.saturating_sub(1).max(2);
    if rows.len() > room {
        let more = rows.len() - (room - 1);
        rows.truncate(room - 1);
        rows.push(format!("and {more} more, in a higher window").chars().take(width).collect());
    }
    rows
}

/// A row for each axis; what is of the device stands in the first.
fn cells(position: usize, device: &Shown<'_>) -> Vec<Cells> {
    let count = device.axes.len().max(1);
    let row = |number: usize| {
        let of_device = |text: String| if number == 0 { text } else { String::new() };
        let axis = device.axes.get(number);
        let of_axis = |text: fn(&AxisStatus) -> String| axis.map(text).unwrap_or_default();
        [
            of_device(position.to_string()),
            of_device(line(device.name).into_owned()),
            of_device(device.state.to_owned()),
            of_axis(|axis| line(&axis.name).into_owned()),
            of_axis(|axis| axis.state.to_string()),
            of_axis(position_of),
            of_axis(error),
            of_axis(mode),
        ]
    };
    (0..count).map(row).collect()
}

/// The mode of an axis by its name, or by its number.
pub(super) fn mode(axis: &AxisStatus) -> String {
    match (axis.mode, axis.mode_name.as_str()) {
        (0, "") => String::new(),
        (mode, "") => format!("mode {mode}"),
        (_, name) => line(name).into_owned(),
    }
}

/// Where an axis is, in its unit if the description has one, to the step.
pub(super) fn position_of(axis: &AxisStatus) -> String {
    let Some((symbol, step)) = &axis.unit else { return format!("{:.0}", axis.position) };
    let digits = (-step.log10()).ceil().clamp(0.0, 12.0) as usize;
    format!("{:.digits$} {}", axis.position * step, line(symbol))
}

fn error(axis: &AxisStatus) -> String {
    if axis.error == 0 { String::new() } else { format!("0x{:04X}", axis.error) }
}

/// How wide the cells below the head are, with the head where there are any.
fn widths(cells: &[Cells]) -> [usize; COLUMNS.len()] {
    let mut widths = [0; COLUMNS.len()];
    for row in cells.iter().skip(1) {
        for ((widest, cell), (name, _)) in widths.iter_mut().zip(row).zip(COLUMNS) {
            let head = if cell.is_empty() { 0 } else { name.len() };
            *widest = (*widest).max(cell.chars().count()).max(head);
        }
    }
    widths
}

fn row(cells: &Cells, widths: &[usize; COLUMNS.len()]) -> String {
    let shown = cells.iter().zip(widths).zip(COLUMNS).filter(|((_, width), _)| **width > 0);
    let padded = shown.map(|((cell, width), (_, is_number))| match is_number {
        true => format!("{cell:>width$}"),
        false => format!("{cell:<width$}"),
    });
    let text = padded.collect::<Vec<_>>().join("  ");
    text.trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use devc_runtime::cia402::State;

    use super::*;

    fn axis(name: &str, state: State, position: f64) -> AxisStatus {
        AxisStatus {
            name: name.to_owned(),
            state,
            mode: 8,
            mode_name: "Cyclic synchronous position mode".to_owned(),
            position,
            velocity: 0.0,
            error: if state == State::Fault { 0x7305 } else { 0 },
            unit: Some(("mm".to_owned(), 1e-3)),
        }
    }

    fn devices() -> Vec<Shown<'static>> {
        let axes = vec![axis("X", State::OperationEnabled, -1500.0), axis("Y", State::Fault, 20.4)];
        let alone = AxisStatus {
            name: String::new(),
            mode: 0,
            unit: None,
            mode_name: String::new(),
            ..axis("", State::SwitchOnDisabled, 7.0)
        };
        vec![
            Shown { name: "c887", state: "Operational", axes, cycles: None },
            Shown { name: "s700", state: "Init", axes: vec![alone], cycles: None },
        ]
    }

    #[test]
    fn an_axis_is_a_row() {
        let expected = [
            "   device  state        axis  state                position  error   mode",
            "0  c887    Operational  X     operation enabled   -1.500 mm          Cyclic synchronous position mode",
            "                        Y     fault                0.020 mm  0x7305  Cyclic synchronous position mode",
            "1  s700    Init               switch on disabled          7",
        ];
        assert_eq!(rows(&devices(), (120, 24)), expected);
    }

    #[test]
    fn a_column_that_says_nothing_is_left_out() {
        let mut devices = devices();
        devices[0].axes.truncate(1);
        assert!(!rows(&devices, (120, 24))[0].contains("error"));
        devices[1].cycles = Some("1000 of 1.0ms");
        let shown = rows(&devices, (120, 24));
        assert_eq!(shown[3..], ["1  s700: 1000 of 1.0ms"]);
    }

    #[test]
    fn a_small_window_shows_what_fits() {
        for (width, height) in [(40, 3), (1, 1), (0, 0), (200, 4)] {
            let shown = rows(&devices(), (width, height));
            assert!(shown.len() < height.max(3), "{shown:?}");
            assert!(shown.iter().all(|row| row.chars().count() <= width), "{shown:?}");
        }
        assert_eq!(rows(&devices(), (60, 4))[2], "and 2 more, in a higher window");
    }
}
