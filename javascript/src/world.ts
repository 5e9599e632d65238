import { type Vector, VectorOps, putVector } from "#dim";
import type { ColliderDesc } from "#collider_desc";
import type { RigidBody, RigidBodyDesc } from "#rigid_body";
import type { Collider, ColliderHandle } from "./collider.js";
import { ColliderSet } from "./collider_set.js";
import { RapierError } from "./error.js";
import type { EventQueue } from "./event_queue.js";
import { type PhysicsHooks, hookOf, presentHooks } from "./hooks.js";
import { IntegrationParameters } from "./integration_parameters.js";
import { IslandManager } from "./island_manager.js";
import { Owner } from "./owner.js";
import { raw, withCallbacks } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import { RigidBodySet } from "./rigid_body_set.js";

/** A simulation: bodies, colliders, joints, and all that a step needs. */
export class World extends Owner {
    /** The acceleration of all dynamic bodies. */
    gravity: Vector;
    integrationParameters: IntegrationParameters;
    islands: IslandManager;
    bodies: RigidBodySet;
    colliders: ColliderSet;

    constructor(gravity: Vector) {
        super(raw.world_new(), (id) => raw.world_free(id));
        this.gravity = gravity;
        this.integrationParameters = new IntegrationParameters(this);
        this.islands = new IslandManager(this);
        this.bodies = new RigidBodySet(this);
        this.colliders = new ColliderSet(this);
    }

    /** Frees the world with all that is in it. A second call does nothing. */
    override free(): void {
        super.free();
        this.bodies.clear();
        this.colliders.clear();
    }

    // ---- Steps ----

    /** Moves the world forward by one time step. */
    step(eventQueue?: EventQueue, hooks?: PhysicsHooks): void {
        const queue = eventQueue ? eventQueue.id || -1 : 0;
        const present = hooks ? presentHooks(hooks) : 0;
        putVector(0, this.gravity);
        try {
            if (present) {
                withCallbacks({ hook: hookOf(hooks!) }, () => raw.world_step(this.id, queue, present));
            } else {
                raw.world_step(this.id, queue, 0);
            }
        } catch (error) {
            this.breakAfter(error);
            throw error;
        }
    }

    /** A defect of the engine leaves a world that cannot be used. */
    private breakAfter(error: unknown): void {
        const isDefect = error instanceof WebAssembly.RuntimeError || (error instanceof RapierError && error.code === "Internal");
        if (isDefect && this.isAlive()) {
            raw.world_break(this.id);
        }
    }

    /** A hash of the simulated state: the same bits on every machine. */
    hash(): bigint {
        return BigInt.asUintN(64, raw.world_hash(this.id));
    }

    /** Moves colliders of bodies that were moved since the last step, so that queries find them. */
    propagateModifiedBodyPositionsToColliders(): void {
        raw.colliders_propagate(this.id);
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

    /** The largest number of substeps of continuous collision detection. */
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

    /** Removes a body with its colliders and joints. */
    removeRigidBody(body: RigidBody): void {
        this.own(body, "rigid body");
        this.bodies.remove(body.handle);
    }

    /** Creates a collider. */
    createCollider(desc: ColliderDesc, parent?: RigidBody | null): Collider {
        if (parent) {
            this.own(parent, "rigid body");
        }
        return this.colliders.createCollider(this.bodies, desc, parent?.handle);
    }

    /** The collider of a handle. Null if the handle finds none. */
    getCollider(handle: ColliderHandle): Collider {
        return this.colliders.get(handle)!;
    }

    /** Removes a collider. */
    removeCollider(collider: Collider, wakeUp: boolean): void {
        this.own(collider, "collider");
        this.colliders.remove(collider.handle, this.islands, this.bodies, wakeUp);
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

    /** @internal Refuses objects of other worlds. */
    own(object: { readonly world: World }, what: string): void {
        if (object.world !== this) {
            throw new RapierError("StaleHandle", `the ${what} belongs to another world`);
        }
    }
}

/** A world with the gravity of the earth along -y. */
export class PhysicsWorld extends World {
    constructor(gravity?: Vector) {
        const earth = VectorOps.zeros();
        earth.y = -9.81;
        super(gravity ?? earth);
    }

    /** Creates a body with one collider. */
    insert(body: RigidBodyDesc, collider: ColliderDesc): [RigidBody, Collider] {
        const inserted = this.createRigidBody(body);
        try {
            return [inserted, this.createCollider(collider, inserted)];
        } catch (error) {
            this.removeRigidBody(inserted);
            throw error;
        }
    }
}
