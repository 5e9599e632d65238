//! # Gallery: runs scenes from the command line
//!
//! Both galleries, `all_examples2` and `all_examples3`, are this crate plus their own list of scenes.
//! It reads the command line, steps every chosen scene with a progress bar, prints a table of what
//! the scenes cost, and leaves a picture of each in a folder together with a page that shows them all.
//!
//! The crate contains no engine. It needs three things of one, in the trait [`SceneRun`]: step, count, draw. A
//! [`Program`] may bring a window and a graphics adapter; without them, scenes run headless and the processor paints.

mod album;
mod args;
mod catalog;
mod mode;
mod painter;
mod program;
mod progress;
mod recording;
mod runner;
mod table;

pub use args::DEFAULT_FOLDER;
pub use catalog::{Category, Entry, SceneRun, StageTimes, Stats};
pub use drawing::{Drawing, View};
pub use painter::Painter;
pub use program::{Program, WindowRequest};
pub use progress::Progress;
pub use table::{Table, grouped};
