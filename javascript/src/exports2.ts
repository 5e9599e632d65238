// The names of the package for 2D.

export * from "./common.js";
export { FeatureType, JointAxesMask, JointAxis, JointType, PidAxesMask, PolylineFlags, type Rotation, RotationOps, ShapeType, TriMeshFlags, type Vector, Vector2, VectorOps } from "#dim";
export { RigidBody, RigidBodyDesc } from "#rigid_body";
export { ColliderDesc } from "#collider_desc";
export * from "#shape";
export { World } from "#world";
