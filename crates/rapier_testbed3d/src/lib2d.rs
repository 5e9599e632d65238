//! # The 2D testbed: worlds in a window
//!
//! A window with a list of scenes, a camera, and a pointer that pulls bodies. It has panels for every
//! parameter, a plot of the stages of the step, and a history with past states.
//!
//! ```no_run
//! use rapier2d::prelude::*;
//! use rapier_testbed2d::{Testbed, TestbedApp};
//!
//! fn init_world(testbed: &mut Testbed) {
//!     let mut bodies = RigidBodySet::new();
//!     let mut colliders = ColliderSet::new();
//!     let ball = bodies.insert(RigidBodyBuilder::dynamic().translation(Vector::Y * 3.0));
//!     colliders.insert_with_parent(ColliderBuilder::ball(0.5), ball, &mut bodies);
//!     colliders.insert(ColliderBuilder::cuboid(5.0, 0.1));
//!     testbed.set_world(bodies, colliders, ImpulseJointSet::new(), MultibodyJointSet::new());
//!     testbed.look_at([0.0, 1.0], 60.0);
//! }
//!
//! TestbedApp::from_builders(vec![("one ball", init_world)]).run().expect("there is a display");
//! ```

pub use rapier2d as rapier;
pub use scene2d as scene;

mod app;
mod camera;
mod history;
mod look2d;
mod painter;
mod panels;
mod player;
mod pointer;
mod recorder;
mod session;
mod stages;
mod testbed;
mod thumbnails;
mod viewport;

pub use app::TestbedApp;
pub use painter::AdapterPainter;
pub use testbed::{PhysicsEvents, RunState, Testbed, TestbedGraphics};
