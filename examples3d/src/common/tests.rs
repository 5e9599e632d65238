//! The list is in order, and every scene runs.

use crate::SCENES;

#[test]
fn names_are_distinct_words() {
    for (i, info) in SCENES.iter().enumerate() {
        assert!(SCENES[..i].iter().all(|other| other.name != info.name), "{} twice", info.name);
        let is_word = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        assert!(info.name.chars().all(is_word), "{}", info.name);
        assert!(info.steps > 0 && info.description.ends_with('.'), "{}", info.name);
    }
}
