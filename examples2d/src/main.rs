//! Runs the 2D scenes.

use gallery::{Painter, Program};
use rapier_testbed2d::{AdapterPainter, TestbedApp};

fn main() -> std::process::ExitCode {
    let entries = scenes2d::scene::entries(&scenes2d::SCENES);
    let program = Program {
        title: "2D scenes",
        name: "all_examples2",
        entries: &entries,
        window: &|request| TestbedApp::from_scenes(&scenes2d::SCENES, request).run(),
        adapter: &|| AdapterPainter::new().map(|painter| Box::new(painter) as Box<dyn Painter>),
    };
    program.main()
}
