// The names that both packages have.

export { RapierError, type RapierErrorCode } from "./error.js";
export { init, memoryBytes, reserveMemory, version } from "./init.js";
export { hasSimd, type InitOptions, setWarningHandler, threads } from "./raw.js";
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
export {
    ColliderShapeCastHit,
    PointColliderProjection,
    PointProjection,
    Ray,
    RayColliderHit,
    RayColliderIntersection,
    RayIntersection,
    ShapeCastHit,
    ShapeContact,
} from "./geometry_results.js";
export { BroadPhase } from "./query.js";
export { NarrowPhase, TempContactManifold } from "./narrow_phase.js";
export {
    FixedImpulseJoint,
    FixedMultibodyJoint,
    GearImpulseJoint,
    GenericImpulseJoint,
    ImpulseJoint,
    type ImpulseJointHandle,
    ImpulseJointSet,
    JointData,
    MultibodyJoint,
    type MultibodyJointHandle,
    MultibodyJointSet,
    PrismaticImpulseJoint,
    PrismaticMultibodyJoint,
    PulleyImpulseJoint,
    RackImpulseJoint,
    RevoluteImpulseJoint,
    RevoluteMultibodyJoint,
    RopeImpulseJoint,
    SphericalImpulseJoint,
    SphericalMultibodyJoint,
    SpringImpulseJoint,
    UnitImpulseJoint,
    UnitMultibodyJoint,
} from "./joint.js";
export { EventQueue, TempContactForceEvent } from "./event_queue.js";
export { ContactModification, type PhysicsHooks } from "./hooks.js";
export { IntegrationParameters } from "./integration_parameters.js";
export { IslandManager } from "./island_manager.js";
export { CharacterCollision, KinematicCharacterController } from "./character_controller.js";
export { CCDSolver, PhysicsPipeline, SerializationPipeline } from "./pipelines.js";
export { PidController } from "./pid_controller.js";
export { DebugRenderBuffers, DebugRenderPipeline } from "./debug_render.js";
export { BodyViews, bodyIndex } from "./views.js";
export { type BodyChange } from "./world.js";
export { PhysicsWorld } from "./physics_world.js";
export { type Port } from "./shared_steps.js";
export { WorldFollower } from "./world_follower.js";
export { type PublishOptions, WorldPublisher } from "./world_publisher.js";
