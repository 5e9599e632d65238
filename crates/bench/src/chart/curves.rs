//! Curves over logarithmic axes: times and memory of growing worlds.

use super::tables::{Table, number};
use super::{Area, COLORS, Drawn, GRID, HEADING, INK, PAPER, TEXT, own_name, place_of, write};
use crate::engine::Kind;
use crate::growth::curve::Curve;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;
use std::ops::Range;

/// Points of one engine, from left to right, all above zero.
struct Line {
    /// Position of the engine in [`Kind::ALL`].
    place: usize,
    name: String,
    points: Vec<(f64, f64)>,
}

/// Size of a panel, and heights of title and legend (pixels).
const PANEL: (u32, u32) = (450, 340);
const TITLE: u32 = 36;
const LEGEND: u32 = 32;
/// Margin of a panel, and space for the labels of its axes (pixels).
const MARGIN: u32 = 12;
const Y_LABEL_WIDTH: u32 = 52;
const X_LABEL_HEIGHT: u32 = 44;
/// Width of an entry of the legend, and of its line (pixels).
const ENTRY: i32 = 185;
const SAMPLE: i32 = 24;
/// Half the size of a marker (pixels).
const MARKER: i32 = 4;

/// Columns of the panels, with their headings.
const PANELS: [(&str, &str); 2] = [
    ("ms/step", "ms per step (lower is better)"),
    ("bytes/body", "bytes per body (lower is better)"),
];

/// Draws a panel of times and a panel of memory, with one legend.
pub(super) fn draw(picture: &mut String, table: &Table<'_>) -> Drawn {
    let of_file = |curve: &Curve| table.file.starts_with(&format!("growth-{}-", curve.name()));
    let curve = Curve::ALL.into_iter().find(of_file).ok_or("a chart of no curve")?;
    let size = (PANEL.0 * PANELS.len() as u32, TITLE + PANEL.1 + LEGEND);
    let root = SVGBackend::with_string(picture, size).into_drawing_area();
    root.fill(&PAPER)?;
    let (head, rest) = root.split_vertically(TITLE);
    let (middle, foot) = rest.split_vertically(PANEL.1);
    let center = ((size.0 / 2) as i32, TITLE as i32 / 2 + 2);
    write(&head, table.title, center, HPos::Center, HEADING)?;
    let mut names = Vec::new();
    for (area, (column, heading)) in middle.split_evenly((1, PANELS.len())).iter().zip(PANELS) {
        let lines = lines(table, curve, column)?;
        draw_panel(area, heading, curve.x_axis(), &lines)?;
        names = lines.into_iter().map(|line| (line.place, line.name)).collect();
    }
    let height = LEGEND as i32 / 2;
    for (number, (place, name)) in names.iter().enumerate() {
        let x = (Y_LABEL_WIDTH + MARGIN) as i32 + ENTRY * number as i32;
        let style = COLORS[*place].filled().stroke_width(2);
        foot.draw(&PathElement::new([(x, height), (x + SAMPLE, height)], style))?;
        foot.draw(&marker((x + SAMPLE / 2, height), *place))?;
        write(&foot, name, (x + SAMPLE + 6, height), HPos::Left, TEXT)?;
    }
    root.present()?;
    Ok(())
}

/// Returns a line for each engine. Values at or below zero have no place on a logarithmic axis and are left
/// out.
fn lines(table: &Table<'_>, curve: Curve, column: &str) -> Result<Vec<Line>, String> {
    let x_column = match curve {
        Curve::Contacts => "points",
        Curve::Threads => "threads",
        _ => "bodies",
    };
    let mut lines: Vec<Line> = Vec::new();
    for [engine, x, y] in table.cells(["engine", x_column, column])? {
        let place = place_of(engine).ok_or_else(|| format!("no engine is called `{engine}`"))?;
        let point = (number(x)?, number(y)?);
        if point.0 <= 0.0 || point.1 <= 0.0 {
            continue;
        }
        match lines.iter_mut().find(|line| line.place == place) {
            Some(line) => line.points.push(point),
            None => {
                let name = own_name(Kind::ALL[place], table.title);
                let name = name.unwrap_or_else(|| engine.to_owned());
                lines.push(Line { place, name, points: vec![point] });
            }
        }
    }
    Ok(lines)
}

/// Draws curves over logarithmic axes.
fn draw_panel(area: &Area<'_>, heading: &str, below: &str, lines: &[Line]) -> Drawn {
    let points = || lines.iter().flat_map(|line| line.points.iter().copied());
    if points().next().is_none() {
        return Ok(());
    }
    let [x_range, y_range] = [around(points().map(|p| p.0)), around(points().map(|p| p.1))];
    let [mut x_ticks, y_ticks] = [&x_range, &y_range].map(|range| ticks(range.start, range.end));
    // Every x axis is a count, so its ticks are whole numbers.
    x_ticks.retain(|tick| tick.fract() == 0.0);
    let text = ("sans-serif", TEXT).into_font().color(&INK);
    let mut chart = ChartBuilder::on(area)
        .caption(heading, text.clone())
        .margin(MARGIN)
        .x_label_area_size(X_LABEL_HEIGHT)
        .y_label_area_size(Y_LABEL_WIDTH)
        .build_cartesian_2d(
            x_range.log_scale().with_key_points(x_ticks),
            y_range.log_scale().with_key_points(y_ticks),
        )?;
    chart
        .configure_mesh()
        .axis_style(INK)
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .label_style(text.clone())
        .axis_desc_style(text)
        .x_desc(below)
        .x_label_formatter(&|number| short(*number))
        .y_label_formatter(&|number| short(*number))
        .draw()?;
    for line in lines {
        let style = COLORS[line.place].filled().stroke_width(2);
        chart.draw_series(LineSeries::new(line.points.iter().copied(), style))?;
        let markers =
            line.points.iter().map(|point| EmptyElement::at(*point) + marker((0, 0), line.place));
        chart.draw_series(markers)?;
    }
    Ok(())
}

/// Returns the marker of an engine: each has its own shape. `at` is in pixels.
fn marker(at: (i32, i32), place: usize) -> Polygon<(i32, i32)> {
    let shape: &[(i32, i32)] = match place {
        0 => &[(-1, -1), (1, -1), (1, 1), (-1, 1)],
        1 => &[(0, -1), (1, 1), (-1, 1)],
        2 => &[(0, -1), (1, 0), (0, 1), (-1, 0)],
        _ => &[(-1, -1), (1, -1), (0, 1)],
    };
    let corner = |(x, y): &(i32, i32)| (at.0 + MARKER * x, at.1 + MARKER * y);
    Polygon::new(shape.iter().map(corner).collect::<Vec<_>>(), COLORS[place].filled())
}

/// Returns at most a dozen round numbers in a range, in nearly equal logarithmic distances.
fn ticks(low: f64, high: f64) -> Vec<f64> {
    let decades = (high / low).log10();
    let digits: &[f64] = match decades {
        d if d < 0.7 => &[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0],
        d if d < 1.5 => &[1.0, 1.5, 2.0, 3.0, 5.0, 7.0],
        d if d < 2.5 => &[1.0, 2.0, 5.0],
        _ => &[1.0],
    };
    let powers = (low.log10().floor() as i32)..=(high.log10().ceil() as i32);
    // The division keeps 0.1 · 3 from becoming 0.30000000000000004.
    let number = |power: i32, digit: f64| match power {
        0.. => digit * 10_f64.powi(power),
        _ => digit / 10_f64.powi(-power),
    };
    let all = powers.flat_map(|power| digits.iter().map(move |&digit| number(power, digit)));
    all.filter(|&tick| tick >= low * 0.999 && tick <= high * 1.001).collect()
}

/// Returns the range of the numbers, slightly enlarged.
fn around(numbers: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = numbers
        .fold((f64::INFINITY, 0.0_f64), |(low, high), number| (low.min(number), high.max(number)));
    // A single number is the middle of its range.
    let margin = if high > 1.01 * low { (high / low).powf(0.05) } else { 2.0 };
    low / margin..high * margin
}

/// Formats a number of an axis: `0.01`, `500`, `20k`, `1M`.
fn short(number: f64) -> String {
    match number {
        n if n >= 1e6 => format!("{}M", n / 1e6),
        n if n >= 1e4 => format!("{}k", n / 1e3),
        n => n.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tables::illustrated;
    use super::*;

    #[test]
    fn ticks_are_round_and_few() {
        assert_eq!(ticks(0.7, 3.2), [0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0]);
        assert_eq!(ticks(90.0, 1.1e6), [100.0, 1e3, 1e4, 1e5, 1e6]);
        for high in [1.1, 2.0, 7.0, 30.0, 900.0, 1e6, 1e9] {
            assert!((1..=12).contains(&ticks(1.0, high).len()), "{high}");
        }
    }

    #[test]
    fn axes_reach_over_all_points() {
        let range = around([10.0, 1000.0].into_iter());
        assert!(range.start < 10.0 && range.end > 1000.0 && range.end < 2000.0);
        assert_eq!(around([5.0].into_iter()), 2.5..10.0);
    }

    #[test]
    fn pictures_have_titles_names_and_labels() {
        let page = "![Threads, 3D](growth-threads-3d.svg)\n\n\
             | engine | bodies | threads | ms/step | bytes/body |\n| --- |\n\
             | this engine | 9 | 1 | 2.0 | 1 000 |\n| this engine | 9 | 2 | 1.5 | 1 000 |\n\
             | Box3D | 9 | 1 | 4.0 | 0 |\n";
        let tables = illustrated(page);
        let lines = lines(&tables[0], Curve::Threads, "ms/step").unwrap();
        assert_eq!(lines[0].points, [(1.0, 2.0), (2.0, 1.5)]);
        let mut picture = String::new();
        draw(&mut picture, &tables[0]).unwrap();
        for word in ["Threads, 3D", "rapier3d-engine", "ms per step", "threads", "</svg>"] {
            assert!(picture.contains(word), "{word} is missing");
        }
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.05, 5.0, 1000.0, 2e4, 1e6].map(short), ["0.05", "5", "1000", "20k", "1M"]);
    }
}
