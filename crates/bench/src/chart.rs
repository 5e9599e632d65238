//! Charts for the documentation: bars of ratios, and curves over logarithmic axes.
//!
//! They have a background of their own, so that they can be read on light and on dark pages.

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
/// Where this engine is ahead, with one thread and with more.
const AHEAD: [RGBColor; 2] = [RGBColor(31, 111, 180), RGBColor(120, 173, 214)];
/// Where a peer is, likewise.
const BEHIND: [RGBColor; 2] = [RGBColor(205, 84, 30), RGBColor(232, 152, 112)];
/// For engines, in the order of [`crate::engine::Kind::ALL`].
const LINES: [RGBColor; 4] = [AHEAD[0], BEHIND[0], RGBColor(52, 140, 74), RGBColor(133, 92, 190)];

/// Pixels of text, and of headings.
const TEXT: u32 = 12;
const HEADING: u32 = 15;

/// An area of a picture that is drawn into a text.
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// What becomes of drawing.
type Drawn = Result<(), Box<dyn std::error::Error>>;

/// One engine's curve.
pub struct Curve {
    /// The engine's name.
    pub name: &'static str,
    /// The engine's place in [`crate::engine::Kind::ALL`].
    pub place: usize,
    /// The points, from left to right, all above zero.
    pub points: Vec<(f64, f64)>,
}

/// Curves over the same axes.
pub struct Panel {
    /// What stands above it: what the y axis means.
    pub heading: &'static str,
    /// What the x axis means.
    pub below: &'static str,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// Draws a bar per scene and number of threads: the fastest peer's time divided by this engine's. Says whether there was anything to draw.
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

/// A bar of the chart of ratios.
struct Bar {
    /// The scene; empty if the bar above has the same.
    label: String,
    ratio: f64,
    threads: usize,
    /// The fastest peer.
    peer: &'static str,
}

/// One for each contest in which a peer took part; those of a scene together.
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

/// Height of a bar, and width of the picture, of the labels, and of what stands behind the longest bar (pixels).
const ROW: i32 = 17;
const WIDTH: i32 = 860;
const LABELS: i32 = 150;
const BEYOND: i32 = 190;
/// Above and below the bars (pixels).
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
    // A logarithmic axis: twice as fast is as far from the line as half as fast.
    let width = f64::from(WIDTH - LABELS - BEYOND);
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
        let colors = if bar.ratio < 1.0 { BEHIND } else { AHEAD };
        let color = colors[usize::from(bar.threads > 1)];
        let corners = [(from.min(to), top + 2), (from.max(to), top + ROW - 2)];
        root.draw(&Rectangle::new(corners, color.filled()))?;
        write(&root, &bar.label, (LABELS - 10, middle), HPos::Right, TEXT)?;
        let threads = crate::units::counted(bar.threads, "thread");
        let says = format!("{:.2}  {}, {threads}", bar.ratio, bar.peer);
        write(&root, &says, (from.max(to) + 6, middle), HPos::Left, TEXT)?;
    }
    root.present()?;
    Ok(())
}

/// Round numbers from one to another, about as far apart as their logarithms are: no more than a dozen.
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

/// Writes a text at a place, with its middle at that height.
fn write(area: &Area<'_>, text: &str, place: (i32, i32), side: HPos, size: u32) -> Drawn {
    if !text.is_empty() {
        let font = ("sans-serif", size).into_font().color(&INK);
        let style = font.pos(Pos::new(side, VPos::Center));
        area.draw(&Text::new(text.to_owned(), place, style)).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// Size of a panel, and the heights of title and legend (pixels).
const PANEL: (u32, u32) = (450, 340);
const TITLE: u32 = 36;
const LEGEND: u32 = 32;
/// Around the axes of a panel, and for their labels (pixels).
const MARGIN: u32 = 12;
const LEFT: u32 = 52;
const BELOW: u32 = 44;
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
        let x = (LEFT + MARGIN) as i32 + ENTRY * number as i32;
        let style = LINES[curve.place].filled().stroke_width(2);
        foot.draw(&PathElement::new([(x, height), (x + 24, height)], style))?;
        foot.draw(&Circle::new((x + 12, height), 3, style))?;
        write(&foot, curve.name, (x + 30, height), HPos::Left, TEXT)?;
    }
    root.present()?;
    Ok(())
}

/// Draws curves over their axes, both logarithmic.
fn draw_panel(area: &Area<'_>, panel: &Panel) -> Drawn {
    let points = || panel.curves.iter().flat_map(|curve| curve.points.iter().copied());
    if points().next().is_none() {
        return Ok(());
    }
    let [x_range, y_range] = [around(points().map(|p| p.0)), around(points().map(|p| p.1))];
    let [mut x_ticks, y_ticks] = [&x_range, &y_range].map(|range| ticks(range.start, range.end));
    // All that grows can be counted: there is nothing between two threads.
    x_ticks.retain(|tick| tick.fract() == 0.0);
    let text = ("sans-serif", TEXT).into_font().color(&INK);
    let mut chart = ChartBuilder::on(area)
        .caption(panel.heading, text.clone())
        .margin(MARGIN)
        .x_label_area_size(BELOW)
        .y_label_area_size(LEFT)
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

/// From the smallest to the largest number, and a little farther.
fn around(numbers: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = numbers
        .fold((f64::INFINITY, 0.0_f64), |(low, high), number| (low.min(number), high.max(number)));
    // One number alone stands in the middle.
    let margin = if high > 1.01 * low { (high / low).powf(0.05) } else { 2.0 };
    low / margin..high * margin
}

/// A number of an axis: `0.01`, `500`, `20k`, `1M`.
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
    fn pictures_say_what_they_show() {
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
