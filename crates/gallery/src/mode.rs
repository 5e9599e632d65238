//! The choice between a window and a headless run.

/// Environment variables that name a display.
const DISPLAYS: [&str; 2] = ["WAYLAND_DISPLAY", "DISPLAY"];

/// Returns whether a window can be opened here.
pub(crate) fn has_display() -> bool {
    let named = |name: &&str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    cfg!(any(target_os = "windows", target_os = "macos")) || DISPLAYS.iter().any(named)
}
