//! Queries of the world, compared with searches of every collider.

mod brute;
mod grounds;
mod journal;
mod nonsense;
mod pairs;
mod plain;
mod sides;
mod turning;
