//! The part of a scene that 2D and 3D share. Both crates compile these files, each against its own engine,
//! which their roots import under the name `rapier`.

mod controls;
mod draw;
mod events;
mod islands;
mod law;
mod overlays;
mod palette;
mod run;
mod scene;
mod surfaces;

pub use controls::Controls;
pub use draw::Artist;
pub(crate) use draw::Look;
pub use events::StepEvents;
pub use law::{Law, gap};
pub use overlays::Overlays;
pub use run::entries;
pub use scene::{BodyColors, Scene, SceneInfo, Script};
pub(crate) use surfaces::{BORDER_PIECES, Surfaces};
