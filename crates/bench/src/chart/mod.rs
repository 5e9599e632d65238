//! Charts for the documentation, drawn from the tables of its pages: every figure of a chart is in a table.
//!
//! Charts have an opaque background, so that they are readable on light and on dark pages. The colours are
//! those of Okabe and Ito, which differ for colour-blind readers too; each engine also has a marker.

mod curves;
mod leads;
mod tables;

use crate::catalog::engine_name;
use crate::engine::Kind;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::fmt::Display;
use std::io;
use std::path::Path;

const PAPER: RGBColor = RGBColor(253, 253, 250);
const INK: RGBColor = RGBColor(45, 45, 45);
const FAINT_INK: RGBColor = RGBColor(105, 105, 105);
const GRID: RGBColor = RGBColor(222, 222, 216);
/// Colours of the engines, in the order of [`Kind::ALL`].
const COLORS: [RGBColor; 4] =
    [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];

/// Sizes of text and of headings (pixels).
const TEXT: u32 = 12;
const HEADING: u32 = 16;

/// Area of a picture in SVG text.
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Result of drawing.
type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Draws the charts of a page of the documentation, into the files that the page names above its tables.
pub fn draw(folder: &Path, page: &str) -> io::Result<()> {
    for table in tables::illustrated(page) {
        let mut picture = String::new();
        match table.column("bodies") {
            Some(_) => curves::draw(&mut picture, &table),
            None => leads::draw(&mut picture, &table),
        }
        .map_err(failed)?;
        std::fs::write(folder.join(table.file), picture)?;
    }
    Ok(())
}

fn failed(error: impl Display) -> io::Error {
    io::Error::other(error.to_string())
}

/// Returns the position of an engine in [`Kind::ALL`], from its name in the tables.
fn place_of(engine: &str) -> Option<usize> {
    let is_named = |kind: &Kind| ["2d", "3d"].iter().any(|d| engine_name(*kind, d) == engine);
    Kind::ALL.iter().position(is_named)
}

/// Returns the name of this engine's package, for the dimension that a title names. Peers have `None`.
fn own_name(kind: Kind, title: &str) -> Option<String> {
    let package = format!("rapier{}-engine", if title.contains("2D") { "2d" } else { "3d" });
    match kind {
        Kind::This => Some(package),
        Kind::Double => Some(format!("{package}, f64")),
        Kind::Rapier | Kind::Box => None,
    }
}

/// Writes a text at a place, vertically centred.
fn write(area: &Area<'_>, text: &str, place: (i32, i32), side: HPos, size: u32) -> Drawn {
    write_in(area, text, place, side, ("sans-serif", size).into_font().color(&INK))
}

/// Writes a text in a style.
fn write_in(
    area: &Area<'_>,
    text: &str,
    place: (i32, i32),
    side: HPos,
    style: TextStyle<'_>,
) -> Drawn {
    let style = style.pos(Pos::new(side, VPos::Center));
    area.draw(&Text::new(text.to_owned(), place, style)).map_err(|error| error.to_string())?;
    Ok(())
}
