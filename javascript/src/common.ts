// The names that both packages have.

export { RapierError, type RapierErrorCode } from "./error.js";
export { init, memoryBytes, reserveMemory, version } from "./init.js";
export { hasSimd, type InitOptions, setWarningHandler } from "./raw.js";
export * from "./enums.js";
export { type RigidBodyHandle, RigidBodyType } from "./rigid_body.js";
export { RigidBodySet } from "./rigid_body_set.js";
export { Collider, type ColliderHandle } from "./collider.js";
export { ColliderSet } from "./collider_set.js";
export {
    Ball,
    Capsule,
    Compound,
    CompoundFlags,
    Cuboid,
    HalfSpace,
    HeightFieldFlags,
    Polyline,
    RoundCuboid,
    RoundTriangle,
    Segment,
    Shape,
    TriMesh,
    Triangle,
    type VHACDParameters,
    Voxels,
} from "./shape.js";
export { EventQueue, TempContactForceEvent } from "./event_queue.js";
export { ContactModification, type PhysicsHooks } from "./hooks.js";
export { IntegrationParameters } from "./integration_parameters.js";
export { IslandManager } from "./island_manager.js";
export { PhysicsWorld, World } from "./world.js";
