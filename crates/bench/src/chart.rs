//! Charts for the documentation: bars of ratios, and curves over logarithmic axes.
//!
//! Charts have an opaque background, so that they are readable on light and on dark pages.

use crate::contest::Contest;
use crate::means::ratio_to_fastest;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::fmt::Display;
use std::io;
use std::ops::Range;
use std::path::Path;

const PAPER: RGBColor = RGBColor(253, 253, 250);
const INK: RGBColor = RGBColor(45, 45, 45);
const GRID: RGBColor = RGBColor(222, 222, 216);
/// Colours of bars with this engine ahead: with one thread, and with several.
const COLORS_AHEAD: [RGBColor; 2] = [RGBColor(31, 111, 180), RGBColor(120, 173, 214)];
/// Colours of bars with a peer ahead, likewise.
const COLORS_BEHIND: [RGBColor; 2] = [RGBColor(205, 84, 30), RGBColor(232, 152, 112)];
/// Colours of the engines, in the order of [`crate::engine::Kind::ALL`].
const LINES: [RGBColor; 4] =
    [COLORS_AHEAD[0], COLORS_BEHIND[0], RGBColor(52, 140, 74), RGBColor(133, 92, 190)];

/// Sizes of text and of headings (pixels).
const TEXT: u32 = 12;
const HEADING: u32 = 15;

/// Area of a picture in SVG text.
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Result of drawing.
type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Curve of one engine.
pub struct Curve {
    /// Name of the engine.
    pub name: &'static str,
    /// Position of the engine in [`crate::engine::Kind::ALL`].
    pub place: usize,
    /// Points from left to right, all above zero.
    pub points: Vec<(f64, f64)>,
}

/// Curves over the same axes.
pub struct Panel {
    /// Heading above the panel: the meaning of the y axis.
    pub heading: &'static str,
    /// Meaning of the x axis.
    pub below: &'static str,
    /// Curves of the panel.
    pub curves: Vec<Curve>,
}

/// Draws a bar per scene and number of threads: the fastest peer's time divided by this engine's. Returns
/// whether there is a bar.
pub fn ratios(path: &Path, contests: &[Contest]) -> io::Result<bool> {
    let bars = bars(contests);
    if bars.is_empty() {
        return Ok(false);
    }
    let mut picture = String::new();
    draw_bars(&mut picture, &bars).map_err(failed)?;
    std::fs::write(path, picture)?;
    Ok(true)
}

/// Draws panels side by side, with one legend.
pub fn panels(path: &Path, title: &str, panels: &[Panel]) -> io::Result<()> {
    let mut picture = String::new();
    draw_panels(&mut picture, title, panels).map_err(failed)?;
    std::fs::write(path, picture)
}

fn failed(error: impl Display) -> io::Error {
    io::Error::other(error.to_string())
}

/// Bar of the chart of ratios.
struct Bar {
    /// Name of the scene; empty if it is that of the bar above.
    label: String,
    ratio: f64,
    threads: usize,
    /// Name of the fastest peer.
    peer: &'static str,
}

/// Returns one bar for each contest with a peer. Bars of one scene are adjacent.
fn bars(contests: &[Contest]) -> Vec<Bar> {
    let mut bars: Vec<Bar> = Vec::new();
    for (index, first) in contests.iter().enumerate() {
        if contests[..index].iter().any(|earlier| earlier.scene == first.scene) {
            continue;
        }
        let mut label = first.scene.as_str();
        for contest in contests.iter().filter(|contest| contest.scene == first.scene) {
            if let (Some(ratio), Some((peer, _))) =
                (ratio_to_fastest(contest), contest.fastest_peer())
            {
                let (threads, peer) = (contest.threads, contest.engine_name(peer));
                bars.push(Bar { label: label.to_owned(), ratio, threads, peer });
                label = "";
            }
        }
    }
    bars
}

/// Height of a bar, and widths of the picture, the labels, and the text after the longest bar (pixels).
const ROW: i32 = 17;
const WIDTH: i32 = 860;
const LABELS: i32 = 150;
const RIGHT_MARGIN: i32 = 190;
/// Margins above and below the bars (pixels).
const TOP: i32 = 62;
const BOTTOM: i32 = 16;

fn draw_bars(picture: &mut String, bars: &[Bar]) -> Drawn {
    let foot = TOP + ROW * bars.len() as i32;
    let root = SVGBackend::with_string(picture, (WIDTH as u32, (foot + BOTTOM) as u32));
    let root = root.into_drawing_area();
    root.fill(&PAPER)?;
    let heading =
        "Time of the fastest peer / time of this engine (right of the line this engine is faster)";
    write(&root, heading, (LABELS, 20), HPos::Left, HEADING)?;
    let all = || bars.iter().map(|bar| bar.ratio);
    let low = all().fold(0.8, f64::min) / 1.05;
    let high = all().fold(1.5, f64::max);
    // The axis is logarithmic: twice as fast and half as fast are equally far from the line.
    let width = f64::from(WIDTH - LABELS - RIGHT_MARGIN);
    let place = |ratio: f64| LABELS + (width * (ratio / low).ln() / (high / low).ln()) as i32;
    for tick in ticks(low, high) {
        let x = place(tick);
        let (color, stroke) = if tick == 1.0 { (INK, 2) } else { (GRID, 1) };
        let style = ShapeStyle::from(color).stroke_width(stroke);
        root.draw(&PathElement::new([(x, TOP - 6), (x, foot)], style))?;
        write(&root, &tick.to_string(), (x, TOP - 14), HPos::Center, TEXT)?;
    }
    for (row, bar) in bars.iter().enumerate() {
        let top = TOP + ROW * row as i32;
        let middle = top + ROW / 2;
        let (from, to) = (place(1.0), place(bar.ratio));
        let colors = if bar.ratio < 1.0 { COLORS_BEHIND } else { COLORS_AHEAD };
        let color = colors[usize::from(bar.threads > 1)];
        let corners = [(from.min(to), top + 2), (from.max(to), top + ROW - 2)];
        root.draw(&Rectangle::new(corners, color.filled()))?;
        write(&root, &bar.label, (LABELS - 10, middle), HPos::Right, TEXT)?;
        let threads = crate::units::counted(bar.threads, "thread");
        let text = format!("{:.2}  {}, {threads}", bar.ratio, bar.peer);
        write(&root, &text, (from.max(to) + 6, middle), HPos::Left, TEXT)?;
    }
    root.present()?;
    Ok(())
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

/// Writes a text at a place, vertically centred.
fn write(area: &Area<'_>, text: &str, place: (i32, i32), side: HPos, size: u32) -> Drawn {
    if !text.is_empty() {
        let font = ("sans-serif", size).into_font().color(&INK);
        let style = font.pos(Pos::new(side, VPos::Center));
        area.draw(&Text::new(text.to_owned(), place, style)).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// Size of a panel, and heights of title and legend (pixels).
const PANEL: (u32, u32) = (450, 340);
const TITLE: u32 = 36;
const LEGEND: u32 = 32;
/// Margin of a panel, and space for the labels of its axes (pixels).
const MARGIN: u32 = 12;
const Y_LABEL_WIDTH: u32 = 52;
const X_LABEL_HEIGHT: u32 = 44;
/// Width of an entry of the legend (pixels).
const ENTRY: i32 = 165;

fn draw_panels(picture: &mut String, title: &str, panels: &[Panel]) -> Drawn {
    let size = (PANEL.0 * panels.len() as u32, TITLE + PANEL.1 + LEGEND);
    let root = SVGBackend::with_string(picture, size).into_drawing_area();
    root.fill(&PAPER)?;
    let (head, rest) = root.split_vertically(TITLE);
    let (middle, foot) = rest.split_vertically(PANEL.1);
    write(&head, title, ((size.0 / 2) as i32, TITLE as i32 / 2 + 2), HPos::Center, HEADING)?;
    for (area, panel) in middle.split_evenly((1, panels.len())).iter().zip(panels) {
        draw_panel(area, panel)?;
    }
    let curves = panels.first().map_or(&[][..], |panel| &panel.curves);
    let height = LEGEND as i32 / 2;
    for (number, curve) in curves.iter().enumerate() {
        let x = (Y_LABEL_WIDTH + MARGIN) as i32 + ENTRY * number as i32;
        let style = LINES[curve.place].filled().stroke_width(2);
        foot.draw(&PathElement::new([(x, height), (x + 24, height)], style))?;
        foot.draw(&Circle::new((x + 12, height), 3, style))?;
        write(&foot, curve.name, (x + 30, height), HPos::Left, TEXT)?;
    }
    root.present()?;
    Ok(())
}

/// Draws curves over logarithmic axes.
fn draw_panel(area: &Area<'_>, panel: &Panel) -> Drawn {
    let points = || panel.curves.iter().flat_map(|curve| curve.points.iter().copied());
    if points().next().is_none() {
        return Ok(());
    }
    let [x_range, y_range] = [around(points().map(|p| p.0)), around(points().map(|p| p.1))];
    let [mut x_ticks, y_ticks] = [&x_range, &y_range].map(|range| ticks(range.start, range.end));
    // Every x axis is a count, so its ticks are whole numbers.
    x_ticks.retain(|tick| tick.fract() == 0.0);
    let text = ("sans-serif", TEXT).into_font().color(&INK);
    let mut chart = ChartBuilder::on(area)
        .caption(panel.heading, text.clone())
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
        .x_desc(panel.below)
        .x_label_formatter(&|number| short(*number))
        .y_label_formatter(&|number| short(*number))
        .draw()?;
    for curve in &panel.curves {
        let style = LINES[curve.place].filled().stroke_width(2);
        chart.draw_series(LineSeries::new(curve.points.iter().copied(), style).point_size(3))?;
    }
    Ok(())
}

/// Returns the range of the numbers, slightly enlarged.
fn around(numbers: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = numbers
        .fold((f64::INFINITY, 0.0_f64), |(low, high), number| (low.min(number), high.max(number)));
    // A single number gets a range around it.
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
    fn pictures_have_titles_and_labels() {
        let curve =
            |place| Curve { name: "this engine", place, points: vec![(1.0, 2.0), (9.0, 4.0)] };
        let panel = || Panel { heading: "ms", below: "bodies", curves: vec![curve(0), curve(1)] };
        let mut picture = String::new();
        draw_panels(&mut picture, "Growth", &[panel(), panel()]).unwrap();
        for word in ["Growth", "this engine", "ms", "bodies", "</svg>"] {
            assert!(picture.contains(word), "{word}");
        }
        let bar = |ratio| Bar { label: "3d/tower".into(), ratio, threads: 2, peer: "Box3D" };
        let mut picture = String::new();
        draw_bars(&mut picture, &[bar(0.5), bar(3.0)]).unwrap();
        for word in ["3d/tower", "0.50  Box3D, 2 threads", "3.00  Box3D", "</svg>"] {
            assert!(picture.contains(word), "{word}");
        }
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.05, 5.0, 1000.0, 2e4, 1e6].map(short), ["0.05", "5", "1000", "20k", "1M"]);
    }
}
