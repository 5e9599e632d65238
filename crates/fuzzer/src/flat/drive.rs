//! Operations on vehicles, which do not exist in 2D.

use super::both::play::Play;
use super::dim::Vehicle;

/// Does nothing: there are no vehicles in 2D.
pub fn drive(play: &mut Play<'_>) {
    let Vehicle {} = play.vehicle;
}
