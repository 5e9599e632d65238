//! Colours: constraints of one colour have no common dynamic body.

use super::last_step::LastStep;
use super::{Depth, Verdict};
use crate::base::fault::{Fault, ensure};
use crate::model::constraint_graph::{ColorSlot, ConstraintGraph, OVERFLOW};
use core::fmt::Debug;

/// The constraints that were found at their places in a graph.
pub(super) struct Colors<'a, C> {
    graph: &'a ConstraintGraph<C>,
    /// By body slot: a bit for each colour of its constraints. Empty in a quick check.
    of_body: Vec<u64>,
    depth: Depth,
    count: usize,
}

impl<'a, C: Copy + Debug + PartialEq> Colors<'a, C> {
    pub fn of(graph: &'a ConstraintGraph<C>, depth: Depth) -> Result<Self, Fault> {
        ensure!(graph.is_complete(), "colours are missing");
        let bound = if depth == Depth::Full { graph.colors_of_bodies().len() } else { 0 };
        Ok(Self { graph, of_body: vec![0; bound], depth, count: 0 })
    }

    /// Checks the place of a constraint between the bodies in two slots, or that it has none.
    pub fn check(
        &mut self,
        constraint: C,
        place: Option<ColorSlot>,
        is_solved: bool,
        bodies: [u32; 2],
        then: &LastStep<'_>,
    ) -> Verdict {
        ensure!(
            place.is_some() == is_solved,
            "{constraint:?} is at {place:?}, solved: {is_solved}"
        );
        let Some(place) = place else { return Ok(()) };
        let found = self.graph.at(place);
        ensure!(found == Some(constraint), "{found:?} is in the place of {constraint:?}");
        self.count += 1;
        if place.color == OVERFLOW || self.depth == Depth::Quick {
            return Ok(());
        }
        for body in then.dynamic(bodies).into_iter().flatten() {
            let colors = self.of_body.get_mut(body as usize);
            let is_free = colors.is_some_and(|colors| {
                let before = *colors;
                *colors |= 1 << place.color;
                before != *colors
            });
            ensure!(is_free, "body {body} has two constraints of colour {}", place.color);
        }
        Ok(())
    }

    /// There are no other constraints in the graph.
    pub fn finish(self) -> Verdict {
        let Self { graph, of_body, count, .. } = self;
        ensure!(count == graph.len(), "{count} of {} constraints are there", graph.len());
        let wrong = graph.colors_of_bodies().iter().zip(&of_body).position(|(a, b)| a != b);
        ensure!(
            wrong.is_none(),
            "the colours of body {wrong:?} differ from those of its constraints"
        );
        Ok(())
    }
}
