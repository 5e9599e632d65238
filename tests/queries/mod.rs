//! Do questions about the world get the answers that a look at every collider would give?

mod brute;
mod journal;
mod nonsense;
mod plain;
mod sides;
mod turning;
