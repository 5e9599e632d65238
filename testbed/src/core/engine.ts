// The part of the published API that the shared code uses, without its dimension.
//
// Scenes use the full typings of their package. The stage, the views and the panels serve both dimensions, so
// they see this subset: every engine that follows the API satisfies it. Vectors of the 2D engines have no
// `z`; only code behind the `Dimension` interface reads it.

export interface Vec {
    x: number;
    y: number;
    z: number;
}

export interface ShapeLike {
    readonly type: number;
}

export interface ColliderLike {
    readonly handle: number;
    readonly shape: ShapeLike;
    parent(): BodyLike | null;
    isSensor(): boolean;
    isEnabled(): boolean;
}

export interface BodyLike {
    readonly handle: number;
    isSleeping(): boolean;
    isDynamic(): boolean;
    isFixed(): boolean;
    isKinematic(): boolean;
    isEnabled(): boolean;
    mass(): number;
    wakeUp(): void;
    numColliders(): number;
    collider(index: number): ColliderLike;
    angularDamping(): number;
    setAngularDamping(factor: number): void;
}

export interface EventQueueLike {
    free(): void;
}

export interface DebugBuffers {
    vertices: Float32Array;
    colors: Float32Array;
}

/** Contacts of two colliders. Points of 2D engines have no `z`. */
export interface ManifoldLike {
    numSolverContacts(): number;
    solverContactPoint(index: number): { x: number; y: number; z?: number } | null;
}

/** The contacts of a world. It is no part of `WorldLike`: one package accepts handles in place of colliders. */
export interface Touching {
    contactPairsWith(collider: ColliderLike, visit: (other: ColliderLike) => void): void;
    contactPair(first: ColliderLike, second: ColliderLike, visit: (manifold: ManifoldLike) => void): void;
}

export interface WorldLike {
    gravity: { x: number; y: number };
    timestep: number;
    numSolverIterations: number;
    profilerEnabled: boolean;
    free(): void;
    takeSnapshot(): Uint8Array;
    debugRender(): DebugBuffers;
    forEachCollider(visit: (collider: ColliderLike) => void): void;
    forEachRigidBody(visit: (body: BodyLike) => void): void;
    timingStep(): number;
    timingBroadPhase(): number;
    timingNarrowPhase(): number;
    timingSolver(): number;
    timingCcd(): number;
    timingIslandConstruction(): number;
}

/** A module with the published API. */
export interface EngineModule {
    readonly ShapeType: object;
    readonly World: object;
    version(): string;
    init?(): Promise<unknown>;
}

/** An engine that is ready to run scenes. */
export interface Engine<R extends EngineModule = EngineModule> {
    readonly id: EngineId;
    readonly label: string;
    readonly module: R;
}

export type EngineId = "own" | "published";

const LABELS: Record<EngineId, string> = {
    own: "This engine",
    published: "@dimforge",
};

/** Initialises a module: packages without inlined WebAssembly have no `init`. */
export async function loadEngine<R extends EngineModule>(id: EngineId, module: R): Promise<Engine<R>> {
    await module.init?.();
    return { id, label: `${LABELS[id]} ${module.version()}`, module };
}

/** The names of an enumeration by value, for modules with and without a reverse mapping. */
export function enumNames(enumeration: object): Map<number, string> {
    const names = new Map<number, string>();
    for (const [name, value] of Object.entries(enumeration)) {
        if (typeof value === "number") names.set(value, name);
    }
    return names;
}

/** The hash of the world's state as text, or null for engines without one. */
export function stepHash(world: object): string | null {
    const member: unknown = "hash" in world ? world.hash : undefined;
    const value: unknown = typeof member === "function" ? member.call(world) : member;
    if (typeof value === "bigint") return value.toString(16).padStart(16, "0");
    if (typeof value === "number") return value.toString(16).padStart(8, "0");
    return typeof value === "string" ? value : null;
}
