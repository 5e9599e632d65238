//! Runs the 2D scenes.

fn main() -> std::process::ExitCode {
    let entries = examples2d::common::entries(&examples2d::SCENES);
    gallery::main("2D scenes", "all_examples2", &entries)
}
