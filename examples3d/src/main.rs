//! Runs the 3D scenes.

fn main() -> std::process::ExitCode {
    let entries = examples3d::common::entries(&examples3d::SCENES);
    gallery::main("3D scenes", "all_examples3", &entries)
}
