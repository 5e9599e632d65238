//! Bars: how many times as fast as its fastest peer this engine is, scene by scene.

use super::tables::{Table, number};
use super::{
    Area, COLORS, Drawn, FAINT_INK, GRID, HEADING, INK, PAPER, TEXT, own_name, place_of, write,
    write_in,
};
use crate::engine::Kind;
use crate::units::{counted, geometric_mean};
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

/// Bar of one scene.
struct Lead<'t> {
    scene: &'t str,
    /// Time of the fastest peer divided by that of this engine.
    ratio: f64,
    /// Name of the fastest peer.
    peer: &'t str,
}

/// Dimensions, each with a panel.
const DIMENSIONS: [&str; 2] = ["3d", "2d"];
/// Number of threads of the bars. The table below the chart has the other numbers.
const THREADS: &str = "1";

/// Height of a bar; widths of a panel, its labels, and the text after its longest bar (pixels).
const ROW: i32 = 22;
const PANEL: i32 = 450;
const LABELS: i32 = 110;
const RIGHT_MARGIN: i32 = 120;
/// Margins above and below the bars (pixels).
const TOP: i32 = 64;
const BOTTOM: i32 = 52;

/// Draws a panel for each dimension, over one axis.
pub(super) fn draw(picture: &mut String, table: &Table<'_>) -> Drawn {
    let rows = table.cells(["scene", "threads", "engine", "ms/step"])?;
    let mut panels = Vec::new();
    for dimension in DIMENSIONS {
        let leads = leads(&rows, dimension)?;
        if !leads.is_empty() {
            panels.push((dimension, leads));
        }
    }
    let all = || panels.iter().flat_map(|(_, leads)| leads);
    let longest = all().map(|lead| lead.ratio).fold(1.0, f64::max);
    let bars = panels.iter().map(|(_, leads)| leads.len()).max().unwrap_or_default() as i32;
    let size = (PANEL * panels.len() as i32, TOP + ROW * bars + BOTTOM);
    let root = SVGBackend::with_string(picture, (size.0 as u32, size.1 as u32)).into_drawing_area();
    root.fill(&PAPER)?;
    for (area, (dimension, leads)) in root.split_evenly((1, panels.len())).iter().zip(&panels) {
        draw_panel(area, dimension, leads, longest)?;
    }
    root.present()?;
    Ok(())
}

/// Returns the bars of a dimension, the longest first.
fn leads<'t>(rows: &[[&'t str; 4]], dimension: &str) -> Result<Vec<Lead<'t>>, String> {
    let mut times: Vec<(&str, usize, &str, f64)> = Vec::new();
    for &[scene, threads, engine, time] in rows {
        let of_dimension = scene.strip_prefix(dimension).and_then(|rest| rest.strip_prefix('/'));
        if let (Some(scene), THREADS, Some(place)) = (of_dimension, threads, place_of(engine)) {
            times.push((scene, place, engine, number(time)?));
        }
    }
    let ours = times.iter().filter(|(_, place, ..)| Kind::ALL[*place] == Kind::This);
    let mut leads: Vec<Lead<'_>> = ours
        .filter_map(|&(scene, .., time)| {
            let peers = times
                .iter()
                .filter(|(other, place, ..)| *other == scene && Kind::ALL[*place].is_peer());
            let fastest = peers.min_by(|a, b| a.3.total_cmp(&b.3))?;
            Some(Lead { scene, ratio: fastest.3 / time, peer: fastest.2 })
        })
        .collect();
    leads.sort_by(|a, b| b.ratio.total_cmp(&a.ratio));
    Ok(leads)
}

fn draw_panel(area: &Area<'_>, dimension: &str, leads: &[Lead<'_>], longest: f64) -> Drawn {
    let ratios: Vec<f64> = leads.iter().map(|lead| lead.ratio).collect();
    let mean = geometric_mean(&ratios).unwrap_or(1.0);
    let heading = format!(
        "{}: {mean:.2} times as fast as the fastest other engine",
        dimension.to_uppercase()
    );
    let bold = ("sans-serif", HEADING).into_font().style(FontStyle::Bold).color(&INK);
    write_in(area, &heading, (12, 18), HPos::Left, bold)?;
    let note = format!(
        "{}, one thread, geometric mean of {}",
        own_name(Kind::This, &heading).unwrap_or_default(),
        counted(leads.len(), "scene")
    );
    let faint = ("sans-serif", TEXT).into_font().color(&FAINT_INK);
    write_in(area, &note, (12, 38), HPos::Left, faint.clone())?;

    let foot = TOP + ROW * leads.len() as i32;
    let scale = f64::from(PANEL - LABELS - RIGHT_MARGIN) / longest;
    let place = |ratio: f64| LABELS + (scale * ratio) as i32;
    for tick in 0..=longest as i32 {
        let x = place(f64::from(tick));
        area.draw(&PathElement::new([(x, TOP - 4), (x, foot)], GRID))?;
        write(area, &format!("{tick} ×"), (x, foot + 12), HPos::Center, TEXT)?;
    }
    write_in(
        area,
        "times as fast as the engine beside the bar; longer is better",
        (LABELS, foot + 32),
        HPos::Left,
        faint,
    )?;
    for (row, lead) in leads.iter().enumerate() {
        let top = TOP + ROW * row as i32;
        let middle = top + ROW / 2;
        let color = COLORS[usize::from(lead.ratio < 1.0)];
        let corners = [(place(0.0), top + 3), (place(lead.ratio), top + ROW - 3)];
        area.draw(&Rectangle::new(corners, color.filled()))?;
        let scene = lead.scene.replace('_', " ");
        write(area, &scene, (LABELS - 8, middle), HPos::Right, TEXT)?;
        let text = format!("{:.2}  {}", lead.ratio, lead.peer);
        let x = place(lead.ratio.max(1.0)) + 6;
        write(area, &text, (x, middle), HPos::Left, TEXT)?;
    }
    let equal = ShapeStyle::from(INK).stroke_width(2);
    let x = place(1.0);
    area.draw(&PathElement::new([(x, TOP - 4), (x, foot)], equal))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::tables::illustrated;
    use super::*;

    #[test]
    fn bars_are_sorted_and_name_the_fastest_peer() {
        let row = |scene: &str, engine: &str, time: &str| {
            format!("| {scene} | 1 | {engine} | {time} |\n")
        };
        let mut page =
            "![T](t.svg)\n\n| scene | threads | engine | ms/step |\n| --- |\n".to_owned();
        for (scene, times) in [("3d/slow_one", ["2", "1", "9"]), ("3d/fast", ["1", "4", "3"])] {
            for (engine, time) in ["this engine", "Rapier 0.36.1", "Box3D"].iter().zip(times) {
                page += &row(scene, engine, time);
            }
        }
        let tables = illustrated(&page);
        let rows = tables[0].cells(["scene", "threads", "engine", "ms/step"]).unwrap();
        let bars = leads(&rows, "3d").unwrap();
        let bars: Vec<_> = bars.iter().map(|bar| (bar.scene, bar.ratio, bar.peer)).collect();
        assert_eq!(bars, [("fast", 3.0, "Box3D"), ("slow_one", 0.5, "Rapier 0.36.1")]);

        let mut picture = String::new();
        draw(&mut picture, &tables[0]).unwrap();
        for word in ["3D: 1.22 times as fast", "slow one", "0.50  Rapier 0.36.1", "</svg>"] {
            assert!(picture.contains(word), "{word} is missing");
        }
        assert!(!picture.contains("2D:"));
    }
}
