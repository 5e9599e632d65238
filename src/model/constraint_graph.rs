//! The constraint graph: which contact manifold, or which joint, is solved in which colour.
//!
//! Joints and contacts have a graph each: all joints are solved before all contacts.
//!
//! Bodies are nodes, constraints are edges, and an edge gets a colour that no other edge at either of its
//! dynamic bodies has. So constraints of one colour can be solved in any order, in lanes or on threads, with
//! the same result. Constraints never move fixed and kinematic bodies, so any number of constraints of one
//! colour may involve them.
//!
//! Colours are updated as constraints come and go (the lowest free one is taken) and are never recomputed: a
//! settled pile costs nothing. Constraints with only one dynamic body have colours of their own that are
//! solved last, so that contacts with the ground have the smallest error.
//!
//! A constraint that finds no free colour is put into the overflow, whose members are solved one by one. The
//! alternative, unlimited colours, makes the rare hub body (a dynamic floor, say) cost one pass per
//! constraint in the whole world.
//!
//! Sources: Catto, "SIMD Matters" (box2d.org, 2024) for the incremental graph.

use crate::base::in_place::clone_in_place;
use crate::model::contact::PairId;

/// Colours for constraints between two dynamic bodies.
const DYNAMIC_COLORS: u32 = 44;
/// All colours; those from [`DYNAMIC_COLORS`] on are for constraints with one dynamic body.
pub(crate) const COLORS: u32 = 64;
/// Colour of constraints without a free colour.
pub(crate) const OVERFLOW: u32 = COLORS;

/// A manifold of a contact pair.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct ManifoldRef {
    pub pair: PairId,
    pub manifold: u32,
}

/// Position of a constraint in the graph.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct ColorSlot {
    pub color: u32,
    pub position: u32,
}

/// See the [module](self). A constraint is a manifold, or the slot of a joint.
#[derive(Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct ConstraintGraph<C = ManifoldRef> {
    /// The constraints of each colour; the overflow is last.
    colors: Vec<Vec<C>>,
    /// Colours that already hold a constraint of the body in this slot, one bit each.
    colors_of_body: Vec<u64>,
}

clone_in_place!(ConstraintGraph<C> { colors, colors_of_body });

impl<C: Copy> Default for ConstraintGraph<C> {
    fn default() -> Self {
        Self { colors: vec![Vec::new(); COLORS as usize + 1], colors_of_body: Vec::new() }
    }
}

impl<C: Copy> ConstraintGraph<C> {
    /// Gives a constraint a colour. `dynamic` names the slots of its dynamic bodies, one or two.
    pub fn add(&mut self, constraint: C, dynamic: [Option<u32>; 2]) -> ColorSlot {
        let mut used = 0;
        for body in dynamic.into_iter().flatten() {
            if body as usize >= self.colors_of_body.len() {
                self.colors_of_body.resize(body as usize + 1, 0);
            }
            used |= self.colors_of_body[body as usize];
        }
        let both = dynamic[0].is_some() && dynamic[1].is_some();
        let color = lowest_free(used, both);
        if color != OVERFLOW {
            for body in dynamic.into_iter().flatten() {
                self.colors_of_body[body as usize] |= 1 << color;
            }
        }
        let list = &mut self.colors[color as usize];
        list.push(constraint);
        ColorSlot { color, position: list.len() as u32 - 1 }
    }

    /// Takes a constraint out. Returns the constraint that now has its slot. The caller must update that
    /// constraint's owner.
    ///
    /// `bodies` are the slots of both bodies, dynamic or not. The bits of others are not set anyway, and the
    /// type of a removed body is unknown.
    #[must_use]
    pub fn remove(&mut self, slot: ColorSlot, bodies: [u32; 2]) -> Option<C> {
        if slot.color != OVERFLOW {
            for body in bodies {
                if let Some(colors) = self.colors_of_body.get_mut(body as usize) {
                    *colors &= !(1 << slot.color);
                }
            }
        }
        let list = &mut self.colors[slot.color as usize];
        list.swap_remove(slot.position as usize);
        list.get(slot.position as usize).copied()
    }

    /// The constraints of each colour in the order in which colours are solved; the overflow first,
    /// so that the orderly ones correct its errors.
    pub fn in_solving_order(&self) -> impl Iterator<Item = (u32, &[C])> {
        self.all_in_solving_order().filter(|(_, list)| !list.is_empty())
    }

    /// The same, with the colours that have no constraint.
    pub fn all_in_solving_order(&self) -> impl Iterator<Item = (u32, &[C])> {
        let colors = core::iter::once(OVERFLOW).chain(0..COLORS);
        colors.map(|color| (color, self.colors[color as usize].as_slice()))
    }

    /// Returns whether there is a list for each colour, as there must be in one that was loaded.
    pub fn is_complete(&self) -> bool {
        self.colors.len() == COLORS as usize + 1
    }

    /// By body slot: a bit for each colour of its constraints.
    pub fn colors_of_bodies(&self) -> &[u64] {
        &self.colors_of_body
    }

    /// Number of constraints in the graph.
    pub fn len(&self) -> usize {
        self.colors.iter().map(Vec::len).sum()
    }

    /// The manifold in a slot.
    pub fn at(&self, slot: ColorSlot) -> Option<C> {
        self.colors.get(slot.color as usize)?.get(slot.position as usize).copied()
    }
}

/// The lowest colour whose bit is not set, in the range for two dynamic bodies or for one.
fn lowest_free(used: u64, both_dynamic: bool) -> u32 {
    let range =
        if both_dynamic { (1_u64 << DYNAMIC_COLORS) - 1 } else { !((1_u64 << DYNAMIC_COLORS) - 1) };
    let free = !used & range;
    if free == 0 { OVERFLOW } else { free.trailing_zeros() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(pair: u32) -> ManifoldRef {
        ManifoldRef { pair, manifold: 0 }
    }

    #[test]
    fn constraints_of_one_body_never_share_a_color() {
        let mut graph = ConstraintGraph::default();
        let slots: Vec<_> = (0..60).map(|i| graph.add(edge(i), [Some(0), Some(i + 1)])).collect();
        let mut colors: Vec<_> = slots.iter().map(|s| s.color).filter(|&c| c != OVERFLOW).collect();
        colors.sort_unstable();
        colors.dedup();
        assert_eq!(colors.len(), DYNAMIC_COLORS as usize, "every colour once, the rest overflows");
        assert_eq!(graph.len(), 60);
    }

    #[test]
    fn a_removed_constraint_frees_its_color_and_returns_the_moved_one() {
        let mut graph = ConstraintGraph::default();
        let first = graph.add(edge(7), [Some(0), None]);
        let second = graph.add(edge(8), [Some(1), None]);
        assert_eq!((first.color, second.color), (DYNAMIC_COLORS, DYNAMIC_COLORS));
        assert_eq!(graph.remove(first, [0, 9]), Some(edge(8)));
        assert_eq!(graph.add(edge(9), [Some(0), None]).color, DYNAMIC_COLORS);
    }

    #[test]
    fn two_dynamic_bodies_take_low_colors_and_one_takes_high_ones() {
        let mut graph = ConstraintGraph::default();
        assert_eq!(graph.add(edge(0), [Some(0), Some(1)]).color, 0);
        assert_eq!(graph.add(edge(1), [Some(1), Some(2)]).color, 1);
        assert_eq!(graph.add(edge(2), [Some(3), Some(2)]).color, 0);
        assert!(graph.add(edge(3), [None, Some(1)]).color >= DYNAMIC_COLORS);
    }
}
