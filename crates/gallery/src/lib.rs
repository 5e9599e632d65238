//! # Gallery: runs scenes from the command line
//!
//! Both galleries, `all_examples2` and `all_examples3`, are this crate plus their own list of scenes. It
//! reads the command line and steps every chosen scene with a progress bar. It then prints a table of times,
//! and writes a picture of each scene and a page with all pictures.
//!
//! The crate contains no engine. The trait [`SceneRun`] has the three operations that it needs: step, count,
//! draw. A [`Program`] may provide a window and a graphics adapter. Without them, scenes run headless and the
//! processor paints.

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
