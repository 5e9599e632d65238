//! Queries of the world, compared with searches of every collider.

mod brute;
mod first_touch;
mod grounds;
mod journal;
mod nonsense;
mod pairs;
mod paths;
mod plain;
mod sides;
mod turning;
