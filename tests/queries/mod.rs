//! Queries of the world, compared with searches of every collider.

mod brute;
mod journal;
mod nonsense;
mod plain;
mod sides;
mod turning;
