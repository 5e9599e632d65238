//! Runs the 3D scenes.

use gallery::{Painter, Program};
use rapier_testbed3d::{AdapterPainter, TestbedApp};

fn main() -> std::process::ExitCode {
    let entries = scenes3d::scene::entries(&scenes3d::SCENES);
    let program = Program {
        title: "3D scenes",
        name: "all_examples3",
        entries: &entries,
        window: &|request| TestbedApp::from_scenes(&scenes3d::SCENES, request).run(),
        adapter: &|| AdapterPainter::new().map(|painter| Box::new(painter) as Box<dyn Painter>),
    };
    program.main()
}
