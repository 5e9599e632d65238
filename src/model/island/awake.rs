//! The list of awake bodies.

use crate::base::in_place::clone_in_place;
use crate::model::body::RigidBodyHandle;
use core::ops::Deref;

/// Awake bodies: first the kinematic ones, which belong to no island, then the dynamic ones. Few stages read
/// the former, and most worlds have few or none: no stage visits all bodies to find them.
///
/// A body stores its position in the list. Each change returns the positions whose bodies must be updated.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct AwakeBodies {
    bodies: Vec<RigidBodyHandle>,
    kinematic: usize,
}

clone_in_place!(AwakeBodies { bodies, kinematic });

impl AwakeBodies {
    /// The kinematic bodies.
    pub fn kinematic(&self) -> &[RigidBodyHandle] {
        &self.bodies[..self.kinematic]
    }

    /// The dynamic bodies.
    pub fn dynamic(&self) -> &[RigidBodyHandle] {
        &self.bodies[self.kinematic..]
    }

    /// Returns whether there are as many bodies as kinematic ones, as must be in a list that was loaded.
    pub fn is_divided(&self) -> bool {
        self.kinematic <= self.bodies.len()
    }

    /// Adds a body. Returns the positions that hold another body than before.
    pub fn insert(&mut self, handle: RigidBodyHandle, is_kinematic: bool) -> [usize; 2] {
        let last = self.bodies.len();
        self.bodies.push(handle);
        if !is_kinematic {
            return [last; 2];
        }
        let place = self.kinematic;
        self.bodies.swap(place, last);
        self.kinematic += 1;
        [place, last]
    }

    /// Removes the body at a position. Returns the positions that hold another body than before, or none.
    pub fn remove(&mut self, position: usize) -> [usize; 2] {
        if position >= self.kinematic {
            self.bodies.swap_remove(position);
            return [position; 2];
        }
        self.kinematic -= 1;
        self.bodies.swap(position, self.kinematic);
        self.bodies.swap_remove(self.kinematic);
        [position, self.kinematic]
    }
}

impl Deref for AwakeBodies {
    type Target = [RigidBodyHandle];

    fn deref(&self) -> &[RigidBodyHandle] {
        &self.bodies
    }
}

#[cfg(test)]
mod tests {
    use super::AwakeBodies;
    use crate::base::random::Random;
    use crate::model::body::RigidBodyHandle;

    /// Kinematic bodies come first after any insertion and removal, and the returned positions keep all
    /// stored positions true.
    #[test]
    fn kinematic_bodies_stand_first_and_links_are_updated() {
        let mut random = Random(71);
        let (mut awake, mut places) = (AwakeBodies::default(), [None; 40]);
        for _ in 0..2_000 {
            let number = random.below(places.len());
            let handle = RigidBodyHandle::from_raw_parts(number as u32, 0);
            let changed = match places[number].take() {
                Some(position) => awake.remove(position),
                None => awake.insert(handle, number.is_multiple_of(3)),
            };
            for position in changed {
                if let Some(moved) = awake.get(position) {
                    places[moved.into_raw_parts().0 as usize] = Some(position);
                }
            }
            let of = |number: usize| RigidBodyHandle::from_raw_parts(number as u32, 0);
            let listed = places.iter().enumerate();
            let listed = listed.filter_map(|(number, place)| Some((of(number), (*place)?)));
            assert!(listed.clone().all(|(handle, place)| awake.get(place) == Some(&handle)));
            assert_eq!(listed.count(), awake.len());
            let is_kinematic =
                |handle: &RigidBodyHandle| handle.into_raw_parts().0.is_multiple_of(3);
            assert!(awake.kinematic().iter().all(is_kinematic));
            assert!(!awake.dynamic().iter().any(is_kinematic));
        }
    }
}
