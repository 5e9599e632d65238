//! Vehicles drive in 3D only.
