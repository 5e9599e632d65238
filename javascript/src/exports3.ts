// The names of the package for 3D.

export * from "./common.js";
export { FeatureType, JointAxesMask, JointAxis, JointType, PidAxesMask, PolylineFlags, Quaternion, type Rotation, RotationOps, SdpMatrix3, SdpMatrix3Ops, ShapeType, TriMeshFlags, type Vector, Vector3, VectorOps } from "#dim";
export { RigidBody, RigidBodyDesc } from "#rigid_body";
export { ColliderDesc } from "#collider_desc";
export * from "#shape";
export { World } from "#world";
export { DynamicRayCastVehicleController } from "./vehicle_controller.js";
