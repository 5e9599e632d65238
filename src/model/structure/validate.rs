//! What must hold between steps.

use super::Structure;
use crate::model::constraint_graph::ManifoldRef;
use crate::model::island::NONE;

impl Structure<'_> {
    /// Checks every sentence of the module's documentation.
    ///
    /// # Panics
    /// If one does not hold.
    pub fn validate(&self) {
        self.narrow_phase.contacts.validate();
        self.narrow_phase.intersections.validate();
        for (position, &handle) in self.islands.awake.iter().enumerate() {
            assert_eq!(
                self.bodies[handle].link.awake, position as u32,
                "{handle:?} is listed awake"
            );
            let is_kinematic = position < self.islands.awake.kinematic().len();
            assert_eq!(self.bodies[handle].link.island == NONE, is_kinematic, "{handle:?}");
        }
        for (handle, body) in self.bodies.iter() {
            if body.link.awake != NONE {
                assert_eq!(self.islands.awake.get(body.link.awake as usize), Some(&handle));
            } else {
                // What others move is compared with it.
                let moved = self.islands.motion_of(handle.into_raw_parts().0).bound();
                assert_eq!(moved, 0.0, "{handle:?} does not move");
            }
            if body.link.island != NONE {
                let island = self.islands.island(body.link.island);
                assert_eq!(island.bodies.get(body.link.island_position as usize), Some(&handle));
                assert_eq!(island.sleeping, body.link.awake == NONE, "{handle:?} as its island");
            }
        }
        self.validate_pairs();
        self.validate_joints();
    }

    fn validate_pairs(&self) {
        let mut colored = 0;
        for (handle, collider) in self.colliders.iter() {
            for &id in self.narrow_phase.contacts.ids_of(handle.into_raw_parts().0) {
                let pair = &self.narrow_phase.contacts[id];
                if pair.collider1 != handle {
                    continue;
                }
                let slots = self.narrow_phase.contacts.bodies(id);
                let parent = collider.parent().map_or(NONE, |parent| parent.into_raw_parts().0);
                assert_eq!(slots[0], parent, "the pair knows its first body");
                let awake = slots.iter().any(|&slot| self.is_awake(slot));
                assert_eq!(self.narrow_phase.contacts.is_awake(id), awake, "pair of {slots:?}");
                let dynamic = self.dynamic_slots(slots);
                let solved = pair.attached;
                if let ([Some(slot1), Some(slot2)], true) = (dynamic, solved) {
                    let island_of = |slot| self.body(slot).map(|body| body.link.island);
                    assert_eq!(
                        island_of(slot1),
                        island_of(slot2),
                        "touching bodies share an island"
                    );
                }
                let wanted = solved && dynamic.iter().flatten().any(|&slot| self.is_awake(slot));
                for (index, manifold) in pair.manifolds.iter().enumerate() {
                    let wanted = wanted && manifold.is_solved();
                    assert_eq!(manifold.slot.is_some(), wanted, "colour of pair {id}");
                    let Some(slot) = manifold.slot else { continue };
                    let here = ManifoldRef { pair: id, manifold: index as u32 };
                    assert_eq!(self.islands.graph.at(slot), Some(here));
                    colored += 1;
                }
            }
        }
        assert_eq!(colored, self.islands.graph.len(), "the graph holds nothing else");
    }
}
