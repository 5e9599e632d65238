import { type PidAxesMask, type Rotation, type Vector, getVector, putVector } from "#dim";
import type { ColliderDesc } from "#collider_desc";
import { RigidBody, type RigidBodyDesc } from "#rigid_body";
import { requireClass, requireFunction, requireList, requireObject } from "./arguments.js";
import { KinematicCharacterController } from "./character_controller.js";
import { Collider, type ColliderHandle } from "./collider.js";
import { ColliderSet } from "./collider_set.js";
import { DebugRenderBuffers, DebugRenderPipeline } from "./debug_render.js";
import type { InteractionGroups, QueryFilterFlags } from "./enums.js";
import { RapierError } from "./error.js";
import { EventQueue } from "./event_queue.js";
import type { ColliderShapeCastHit, PointColliderProjection, Ray, RayColliderHit, RayColliderIntersection } from "./geometry_results.js";
import { type PhysicsHooks, hookOf, presentHooks } from "./hooks.js";
import { IntegrationParameters } from "./integration_parameters.js";
import { IslandManager } from "./island_manager.js";
import {
    ImpulseJoint,
    type ImpulseJointHandle,
    ImpulseJointSet,
    type JointData,
    MultibodyJoint,
    type MultibodyJointHandle,
    MultibodyJointSet,
} from "./joint.js";
import { NarrowPhase, type TempContactManifold } from "./narrow_phase.js";
import { Owner } from "./owner.js";
import { CCDSolver, PhysicsPipeline, SerializationPipeline } from "./pipelines.js";
import { PidController } from "./pid_controller.js";
import { BroadPhase, type Filter } from "./query.js";
import { apart, bytesCopy, listCopy, putBytes, putList, putReals, raw, withCallbacks } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import { RigidBodySet } from "./rigid_body_set.js";
import type { Shape } from "./shape.js";
import { BodyViews, bodyIndex } from "./views.js";

/** The number of a restored world. */
export interface RestoredWorld {
    /** @internal */
    readonly id: number;
}

/** The constructor of a kind of world. */
export type WorldClass<T> = new (gravity: Vector, restored?: RestoredWorld) => T;

/** The object of a world that is in the module. */
function adopt<T extends World>(kind: WorldClass<T>, id: number): T {
    raw.world_gravity(id);
    const world = new kind(getVector(0), { id });
    listCopy(raw.bodies_list(id)).forEach((handle) => world.bodies.adopt(handle));
    listCopy(raw.colliders_list(id)).forEach((handle) => {
        const parent = raw.collider_parent(id, handle);
        world.colliders.adopt(handle, Number.isNaN(parent) ? null : parent);
    });
    [world.impulseJoints, world.multibodyJoints].forEach((joints, set) => {
        listCopy(raw.joints_list(id, set)).forEach((handle) => joints.adopt(handle));
    });
    return world;
}

/** The quantities that `World.changeBodies` changes. */
export type BodyChange =
    | "translation"
    | "rotation"
    | "linvel"
    | "angvel"
    | "nextTranslation"
    | "nextRotation"
    | "addForce"
    | "applyImpulse";

/** The changes in the order of crates/wasm/src/batch.rs. */
const BODY_CHANGES: readonly BodyChange[] = [
    "translation",
    "rotation",
    "linvel",
    "angvel",
    "nextTranslation",
    "nextRotation",
    "addForce",
    "applyImpulse",
];

/** An object of a world that has a handle. */
interface PartOfWorld {
    readonly world: World;
    readonly handle: number;
}

/** The classes of these objects, by their names in errors. */
const PARTS = {
    "rigid body": RigidBody,
    collider: Collider,
    "impulse joint": ImpulseJoint,
    "multibody joint": MultibodyJoint,
} as const;

/** A controller that a world frees. */
interface Controller {
    readonly world: World;
    free(): void;
}

/** Returns whether an optional argument is left out. Programs write `condition && body`, too. */
function isAbsent(value: unknown): value is undefined | null | false {
    return value === undefined || value === null || value === false;
}

/** The filter of a query, as its last arguments. */
type ObjectFilter = [
    filterFlags?: QueryFilterFlags,
    filterGroups?: InteractionGroups,
    filterExcludeCollider?: Collider | ColliderHandle,
    filterExcludeRigidBody?: RigidBody | RigidBodyHandle,
    filterPredicate?: (collider: Collider) => boolean,
];

/** A simulation: bodies, colliders, joints, and the state of the step. */
export class World extends Owner {
    /** The acceleration of all dynamic bodies. */
    gravity: Vector;
    integrationParameters: IntegrationParameters;
    islands: IslandManager;
    broadPhase: BroadPhase;
    narrowPhase: NarrowPhase;
    bodies: RigidBodySet;
    colliders: ColliderSet;
    impulseJoints: ImpulseJointSet;
    multibodyJoints: MultibodyJointSet;
    ccdSolver: CCDSolver;
    physicsPipeline: PhysicsPipeline;
    serializationPipeline: SerializationPipeline;
    debugRenderPipeline: DebugRenderPipeline;
    /** The character controllers of the world. */
    characterControllers = new Set<KinematicCharacterController>();
    /** The PID controllers of the world. */
    pidControllers = new Set<PidController>();
    private bodyViews: BodyViews | undefined;

    /** A snapshot passes the number of its world as a second argument. */
    constructor(gravity: Vector, restored?: RestoredWorld) {
        requireObject(gravity, "gravity", "a vector");
        super(restored?.id ?? raw.world_new(), (id) => raw.world_free(id));
        this.gravity = gravity;
        this.integrationParameters = new IntegrationParameters(this);
        this.islands = new IslandManager(this);
        this.broadPhase = new BroadPhase(this);
        this.narrowPhase = new NarrowPhase(this);
        this.bodies = new RigidBodySet(this);
        this.colliders = new ColliderSet(this);
        this.impulseJoints = new ImpulseJointSet(this);
        this.multibodyJoints = new MultibodyJointSet(this);
        this.ccdSolver = new CCDSolver();
        this.physicsPipeline = new PhysicsPipeline();
        this.serializationPipeline = new SerializationPipeline();
        this.debugRenderPipeline = new DebugRenderPipeline(this);
    }

    /** Frees the world with all its objects. A second call does nothing. */
    override free(): void {
        super.free();
        for (const controllers of [this.characterControllers, this.pidControllers]) {
            controllers.forEach((controller: Owner) => controller.free());
            controllers.clear();
        }
        this.bodies.clear();
        this.colliders.clear();
        this.impulseJoints.clear();
        this.multibodyJoints.clear();
    }

    // ---- Steps ----

    /** Moves the world forward by one time step. */
    step(eventQueue?: EventQueue, hooks?: PhysicsHooks): void {
        if (eventQueue) {
            requireClass(eventQueue, EventQueue, "eventQueue", "an EventQueue");
        }
        if (hooks) {
            requireObject(hooks, "hooks", "an object of hooks");
        }
        const queue = eventQueue ? eventQueue.id || -1 : 0;
        const present = hooks ? presentHooks(hooks) : 0;
        putVector(0, this.gravity, "gravity");
        withCallbacks(present ? { hook: hookOf(hooks!) } : {}, () => raw.world_step(this.id, queue, present));
    }

    /** A hash of the simulated state: the same bits on every machine. */
    hash(): bigint {
        return BigInt.asUintN(64, raw.world_hash(this.id));
    }

    // ---- Snapshots ----

    /** The whole world as bytes: for files, networks and other machines. `userData` is not part of it. */
    takeSnapshot(): Uint8Array {
        putVector(0, this.gravity, "gravity");
        return bytesCopy(raw.world_save(this.id));
    }

    /** A world from a snapshot. It continues bit for bit as the original does, with the same handles. */
    static restoreSnapshot<T extends World>(this: WorldClass<T>, data: Uint8Array): T {
        putBytes(data, "data");
        return adopt(this, raw.world_restore());
    }

    /** A copy of the world in memory: faster than a snapshot, for rollback. */
    clone(): this {
        putVector(0, this.gravity, "gravity");
        return adopt(this.constructor as WorldClass<this>, raw.world_copy(this.id));
    }

    /** Moves colliders of bodies that were moved since the last step. Queries do it, too. */
    propagateModifiedBodyPositionsToColliders(): void {
        raw.colliders_propagate(this.id);
    }

    /**
     * Brings the data of queries up to date with insertions, removals and movements since the last step. The
     * next query does it, too: a call only chooses the time.
     */
    updateSceneQueries(): void {
        raw.world_update_queries(this.id);
    }

    // ---- Times ----

    /** Whether the stages of a step are timed. */
    get profilerEnabled(): boolean {
        return raw.world_is_timed(this.id) !== 0;
    }

    set profilerEnabled(enabled: boolean) {
        raw.world_set_timed(this.id, +enabled);
    }

    private timing(stage: number): number {
        return raw.world_timing(this.id, stage);
    }

    /** Milliseconds of the last step. 0 unless `profilerEnabled`, as all of these. */
    timingStep(): number {
        return this.timing(0);
    }

    /** Milliseconds of collision detection. */
    timingCollisionDetection(): number {
        return this.timing(1);
    }

    /** Milliseconds of the broad phase. */
    timingBroadPhase(): number {
        return this.timing(2);
    }

    /** Milliseconds of the narrow phase. */
    timingNarrowPhase(): number {
        return this.timing(3);
    }

    /** Milliseconds of the solver. */
    timingSolver(): number {
        return this.timing(4);
    }

    /** Milliseconds in which the solver gathers constraints. */
    timingVelocityAssembly(): number {
        return this.timing(5);
    }

    /** Milliseconds in which the solver solves constraints. */
    timingVelocityResolution(): number {
        return this.timing(6);
    }

    /** Milliseconds in which bodies and colliders are moved. */
    timingVelocityUpdate(): number {
        return this.timing(7);
    }

    /** Milliseconds in which the solver writes its results back. */
    timingVelocityWriteback(): number {
        return this.timing(8);
    }

    /** Milliseconds of continuous collision detection. */
    timingCcd(): number {
        return this.timing(9);
    }

    /** Milliseconds in which continuous collision detection searches for impacts. */
    timingCcdToiComputation(): number {
        return this.timing(10);
    }

    /** Always 0: continuous collision detection has no separate broad phase. */
    timingCcdBroadPhase(): number {
        return 0;
    }

    /** Always 0: continuous collision detection has no separate narrow phase. */
    timingCcdNarrowPhase(): number {
        return 0;
    }

    /** Always 0: continuous collision detection has no separate solver. */
    timingCcdSolver(): number {
        return 0;
    }

    /** Milliseconds in which islands are found. */
    timingIslandConstruction(): number {
        return this.timing(11);
    }

    /** Milliseconds in which changes of the program are applied. */
    timingUserChanges(): number {
        return this.timing(12);
    }

    // ---- Parameters ----

    /** The length of a step in seconds. */
    get timestep(): number {
        return this.integrationParameters.dt;
    }

    set timestep(dt: number) {
        this.integrationParameters.dt = dt;
    }

    /** The size of a typical body. */
    get lengthUnit(): number {
        return this.integrationParameters.lengthUnit;
    }

    set lengthUnit(unitsPerMeter: number) {
        this.integrationParameters.lengthUnit = unitsPerMeter;
    }

    /** Substeps of the solver in a step. */
    get numSolverIterations(): number {
        return this.integrationParameters.numSolverIterations;
    }

    set numSolverIterations(niter: number) {
        this.integrationParameters.numSolverIterations = niter;
    }

    /** Iterations of the solver in a substep. */
    get numInternalPgsIterations(): number {
        return this.integrationParameters.numInternalPgsIterations;
    }

    set numInternalPgsIterations(niter: number) {
        this.integrationParameters.numInternalPgsIterations = niter;
    }

    /** Iterations of all constraints in a substep without position correction, beyond the usual one. */
    get numAdditionalFrictionIterations(): number {
        return this.integrationParameters.numAdditionalFrictionIterations;
    }

    set numAdditionalFrictionIterations(niter: number) {
        this.integrationParameters.numAdditionalFrictionIterations = niter;
    }

    /** The largest number of parts into which impacts of fast bodies divide a step (default 1). 0 switches continuous collision detection off. */
    get maxCcdSubsteps(): number {
        return this.integrationParameters.maxCcdSubsteps;
    }

    set maxCcdSubsteps(substeps: number) {
        this.integrationParameters.maxCcdSubsteps = substeps;
    }

    // ---- Bodies and colliders ----

    /** Creates a body. */
    createRigidBody(body: RigidBodyDesc): RigidBody {
        return this.bodies.createRigidBody(this.colliders, body);
    }

    /** The body of a handle. Null if the handle finds none. */
    getRigidBody(handle: RigidBodyHandle): RigidBody {
        return this.bodies.get(handle)!;
    }

    /** Removes a body with its colliders and joints. A body that was removed before is ignored. */
    removeRigidBody(body: RigidBody | RigidBodyHandle): void {
        this.bodies.remove(this.handleOf(body, "rigid body", "body"));
    }

    /** Creates a collider. */
    createCollider(desc: ColliderDesc, parent?: RigidBody | RigidBodyHandle | null): Collider {
        const body = isAbsent(parent) ? undefined : this.handleOf(parent, "rigid body", "parent");
        return this.colliders.createCollider(this.bodies, desc, body);
    }

    /** The collider of a handle. Null if the handle finds none. */
    getCollider(handle: ColliderHandle): Collider {
        return this.colliders.get(handle)!;
    }

    /** Removes a collider. A collider that was removed before, as by its body, is ignored. */
    removeCollider(collider: Collider | ColliderHandle, wakeUp: boolean): void {
        this.colliders.remove(this.handleOf(collider, "collider", "collider"), this.islands, this.bodies, wakeUp);
    }

    /** Calls a function with each collider. */
    forEachCollider(f: (collider: Collider) => void): void {
        this.colliders.forEach(f);
    }

    /** Calls a function with each body. */
    forEachRigidBody(f: (body: RigidBody) => void): void {
        this.bodies.forEach(f);
    }

    /** Calls a function with each body that is awake and not fixed. */
    forEachActiveRigidBody(f: (body: RigidBody) => void): void {
        this.bodies.forEachActiveRigidBody(this.islands, f);
    }

    // ---- Joints ----

    /** Joins two bodies by an impulse joint. */
    createImpulseJoint(
        params: JointData,
        parent1: RigidBody | RigidBodyHandle,
        parent2: RigidBody | RigidBodyHandle,
        wakeUp: boolean,
    ): ImpulseJoint {
        const [first, second] = this.joined(parent1, parent2);
        return this.impulseJoints.createJoint(this.bodies, params, first, second, wakeUp);
    }

    /** Makes the second body a child of the first one, in a multibody. */
    createMultibodyJoint(
        params: JointData,
        parent1: RigidBody | RigidBodyHandle,
        parent2: RigidBody | RigidBodyHandle,
        wakeUp: boolean,
    ): MultibodyJoint {
        const [first, second] = this.joined(parent1, parent2);
        return this.multibodyJoints.createJoint(params, first, second, wakeUp);
    }

    private joined(parent1: RigidBody | RigidBodyHandle, parent2: RigidBody | RigidBodyHandle): [RigidBodyHandle, RigidBodyHandle] {
        return [this.handleOf(parent1, "rigid body", "parent1"), this.handleOf(parent2, "rigid body", "parent2")];
    }

    /** The impulse joint of a handle. Null if the handle finds none. */
    getImpulseJoint(handle: ImpulseJointHandle): ImpulseJoint {
        return this.impulseJoints.get(handle)!;
    }

    /** The multibody joint of a handle. Null if the handle finds none. */
    getMultibodyJoint(handle: MultibodyJointHandle): MultibodyJoint {
        return this.multibodyJoints.get(handle)!;
    }

    /** Removes an impulse joint. A joint that was removed before, as by one of its bodies, is ignored. */
    removeImpulseJoint(joint: ImpulseJoint | ImpulseJointHandle, wakeUp: boolean): void {
        this.impulseJoints.remove(this.handleOf(joint, "impulse joint", "joint"), wakeUp);
    }

    /** Removes a multibody joint. A joint that was removed before, as by one of its bodies, is ignored. */
    removeMultibodyJoint(joint: MultibodyJoint | MultibodyJointHandle, wakeUp: boolean): void {
        this.multibodyJoints.remove(this.handleOf(joint, "multibody joint", "joint"), wakeUp);
    }

    // ---- Controllers ----

    /** Controllers exist outside the world in the module, which therefore cannot refuse them. */
    private requireAlive(): void {
        if (!this.isAlive()) {
            throw new RapierError("Freed", "the world was freed");
        }
    }

    /** Creates a character controller. The offset is its gap to obstacles. */
    createCharacterController(offset: number): KinematicCharacterController {
        this.requireAlive();
        const controller = new KinematicCharacterController(this, offset);
        this.characterControllers.add(controller);
        return controller;
    }

    /** Removes a character controller, and frees it. A controller that was removed before is ignored. */
    removeCharacterController(controller: KinematicCharacterController): void {
        this.removeController(this.characterControllers, controller, KinematicCharacterController);
    }

    /** Creates a PID controller. It serves one body. */
    createPidController(kp: number, ki: number, kd: number, axes: PidAxesMask): PidController {
        this.requireAlive();
        const controller = new PidController(this, kp, ki, kd, axes);
        this.pidControllers.add(controller);
        return controller;
    }

    /** Removes a PID controller, and frees it. A controller that was removed before is ignored. */
    removePidController(controller: PidController): void {
        this.removeController(this.pidControllers, controller, PidController);
    }

    /** @internal Removes a controller of this world, and frees it. */
    removeController<T extends Controller>(controllers: Set<T>, controller: T, kind: new (...parts: never[]) => T): void {
        requireClass(controller, kind, "controller", `a ${kind.name}`);
        if (controller.world.id !== this.id) {
            throw new RapierError("StaleHandle", `the ${kind.name} belongs to another world`);
        }
        controllers.delete(controller);
        controller.free();
    }

    // ---- Batches and views ----

    /**
     * Poses, velocities and sleep flags of all bodies as views of the engine's memory. From the first use on,
     * each step writes them.
     */
    get views(): BodyViews {
        this.bodyViews ??= new BodyViews(this);
        return this.bodyViews;
    }

    /**
     * Changes many bodies at once: none if one of the values cannot be used. The values stand side by side,
     * in the order of the bodies.
     */
    changeBodies(change: BodyChange, bodies: readonly RigidBody[] | Float64Array, values: ArrayLike<number>, wakeUp = true): void {
        requireList(bodies, "bodies");
        requireList(values, "values");
        const own = apart(values);
        putList(bodies instanceof Float64Array ? bodies : bodies.map((body) => this.handleOf(body, "rigid body", "a body")));
        putReals(own, "values");
        raw.bodies_change(this.id, BODY_CHANGES.indexOf(change), +wakeUp);
    }

    // ---- Debug lines and times ----

    /** The world as lines. */
    debugRender(filterFlags?: QueryFilterFlags, filterPredicate?: (collider: Collider) => boolean): DebugRenderBuffers {
        const { bodies, colliders, impulseJoints, multibodyJoints, narrowPhase, debugRenderPipeline: pipeline } = this;
        pipeline.render(bodies, colliders, impulseJoints, multibodyJoints, narrowPhase, filterFlags, filterPredicate);
        return new DebugRenderBuffers(pipeline.vertices, pipeline.colors);
    }

    // ---- Queries ----

    /** The filter of a query, with colliders and bodies as objects. */
    private filter([flags, groups, collider, body, predicate]: ObjectFilter): Filter {
        if (!isAbsent(predicate)) {
            requireFunction(predicate, "filterPredicate");
        }
        const accept = predicate && ((handle: ColliderHandle) => predicate(this.colliders.get(handle)!));
        const excluded = [
            isAbsent(collider) ? undefined : this.handleOf(collider, "collider", "filterExcludeCollider"),
            isAbsent(body) ? undefined : this.handleOf(body, "rigid body", "filterExcludeRigidBody"),
        ] as const;
        return [flags, groups, ...excluded, accept];
    }

    /** The first collider that a ray hits. */
    castRay(ray: Ray, maxToi: number, solid: boolean, ...filter: ObjectFilter): RayColliderHit | null {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        return broadPhase.castRay(narrowPhase, bodies, colliders, ray, maxToi, solid, ...this.filter(filter));
    }

    /** The first collider that a ray hits, with the normal there. */
    castRayAndGetNormal(ray: Ray, maxToi: number, solid: boolean, ...filter: ObjectFilter): RayColliderIntersection | null {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        return broadPhase.castRayAndGetNormal(narrowPhase, bodies, colliders, ray, maxToi, solid, ...this.filter(filter));
    }

    /** Calls a callback with all colliders that a ray hits, until it returns false. */
    intersectionsWithRay(
        ray: Ray,
        maxToi: number,
        solid: boolean,
        callback: (intersect: RayColliderIntersection) => boolean,
        ...filter: ObjectFilter
    ): void {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        broadPhase.intersectionsWithRay(narrowPhase, bodies, colliders, ray, maxToi, solid, callback, ...this.filter(filter));
    }

    /** A collider that a shape touches. */
    intersectionWithShape(shapePos: Vector, shapeRot: Rotation, shape: Shape, ...filter: ObjectFilter): Collider | null {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        const found = broadPhase.intersectionWithShape(narrowPhase, bodies, colliders, shapePos, shapeRot, shape, ...this.filter(filter));
        return found === null ? null : colliders.get(found);
    }

    /** The collider nearest to a point. */
    projectPoint(point: Vector, solid: boolean, ...filter: ObjectFilter): PointColliderProjection | null {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        return broadPhase.projectPoint(narrowPhase, bodies, colliders, point, solid, ...this.filter(filter));
    }

    /** The collider whose surface is nearest to a point, with the feature there. */
    projectPointAndGetFeature(point: Vector, ...filter: ObjectFilter): PointColliderProjection | null {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        return broadPhase.projectPointAndGetFeature(narrowPhase, bodies, colliders, point, ...this.filter(filter));
    }

    /** Calls a callback with all colliders that contain a point, until it returns false. */
    intersectionsWithPoint(point: Vector, callback: (collider: Collider) => boolean, ...filter: ObjectFilter): void {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        broadPhase.intersectionsWithPoint(narrowPhase, bodies, colliders, point, this.visitor(callback), ...this.filter(filter));
    }

    /** The first collider in the path of a shape. */
    castShape(
        shapePos: Vector,
        shapeRot: Rotation,
        shapeVel: Vector,
        shape: Shape,
        targetDistance: number,
        maxToi: number,
        stopAtPenetration: boolean,
        ...filter: ObjectFilter
    ): ColliderShapeCastHit | null {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        return broadPhase.castShape(
            narrowPhase,
            bodies,
            colliders,
            shapePos,
            shapeRot,
            shapeVel,
            shape,
            targetDistance,
            maxToi,
            stopAtPenetration,
            ...this.filter(filter),
        );
    }

    /** Calls a callback with all colliders that a shape touches, until it returns false. */
    intersectionsWithShape(
        shapePos: Vector,
        shapeRot: Rotation,
        shape: Shape,
        callback: (collider: Collider) => boolean,
        ...filter: ObjectFilter
    ): void {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        const visitor = this.visitor(callback);
        broadPhase.intersectionsWithShape(narrowPhase, bodies, colliders, shapePos, shapeRot, shape, visitor, ...this.filter(filter));
    }

    /** Calls a callback with all colliders whose boxes overlap a box, until it returns false. */
    collidersWithAabbIntersectingAabb(aabbCenter: Vector, aabbHalfExtents: Vector, callback: (handle: Collider) => boolean): void {
        const { broadPhase, narrowPhase, bodies, colliders } = this;
        const visitor = this.visitor(callback);
        broadPhase.collidersWithAabbIntersectingAabb(narrowPhase, bodies, colliders, aabbCenter, aabbHalfExtents, visitor);
    }

    private visitor(callback: (collider: Collider) => boolean): (handle: ColliderHandle) => boolean {
        requireFunction(callback, "callback");
        return (handle) => callback(this.colliders.get(handle)!);
    }

    // ---- Contacts ----

    /** A function of handles. It leaves out colliders that the given function has removed. */
    private present(f: (collider: Collider) => void): (handle: ColliderHandle) => void {
        return (handle) => {
            const collider = this.colliders.get(handle);
            if (collider) {
                f(collider);
            }
        };
    }

    /** Calls a function with each collider that has a contact pair with a collider. */
    contactPairsWith(collider1: Collider | ColliderHandle, f: (collider2: Collider) => void): void {
        requireFunction(f, "f");
        this.narrowPhase.contactPairsWith(this.handleOf(collider1, "collider", "collider1"), this.present(f));
    }

    /** Calls a function with each collider that intersects a collider, one of them a sensor. */
    intersectionPairsWith(collider1: Collider | ColliderHandle, f: (collider2: Collider) => void): void {
        requireFunction(f, "f");
        this.narrowPhase.intersectionPairsWith(this.handleOf(collider1, "collider", "collider1"), this.present(f));
    }

    /**
     * Calls a function with each manifold of a pair. `flipped` is true if the manifold has the colliders in
     * the other order.
     */
    contactPair(
        collider1: Collider | ColliderHandle,
        collider2: Collider | ColliderHandle,
        f: (manifold: TempContactManifold, flipped: boolean) => void,
    ): void {
        const [first, second] = [this.handleOf(collider1, "collider", "collider1"), this.handleOf(collider2, "collider", "collider2")];
        this.narrowPhase.contactPair(first, second, this.bodies, f);
    }

    /** Returns whether two colliders, one of them a sensor, intersect. */
    intersectionPair(collider1: Collider | ColliderHandle, collider2: Collider | ColliderHandle): boolean {
        return this.narrowPhase.intersectionPair(this.handleOf(collider1, "collider", "collider1"), this.handleOf(collider2, "collider", "collider2"));
    }

    /**
     * @internal The handle of an object of this world, or a handle as it is. Objects of other worlds are
     * refused. The name is that of the argument.
     */
    handleOf(object: PartOfWorld | number, what: keyof typeof PARTS, name: string): number {
        if (typeof object === "number" && !Number.isNaN(object)) {
            return object;
        }
        requireClass<PartOfWorld>(object, PARTS[what], name, `a ${what} or its handle`);
        // Libraries pass proxies of worlds: the number distinguishes worlds.
        if (object.world.id !== this.id) {
            throw new RapierError("StaleHandle", `the ${what} ${bodyIndex(object.handle)} belongs to another world`);
        }
        return object.handle;
    }
}
