import { ANGULAR, DIM, ROTATION } from "#dim";
import { raw } from "./raw.js";
import { type RealArray, RealArrayType } from "#real";
import type { RigidBodyHandle } from "./rigid_body.js";
import type { World } from "./world.js";

/** The slot of a body in the arrays of `BodyViews`. */
export function bodyIndex(handle: RigidBodyHandle): number {
    HANDLE[0] = handle;
    return HALVES[0]!;
}

const HANDLE = new Float64Array(1);
const HALVES = new Uint32Array(HANDLE.buffer);

/**
 * Poses, velocities and sleep flags of all bodies, by slot, as views of the engine's memory. Each step brings
 * them up to date. A view is valid until bodies are created or the memory grows: read the property anew in
 * each frame. It creates no object unless the memory has moved. In a module with threads, an older view shows
 * memory that has another use.
 */
export class BodyViews {
    /** Numbers of a body in `poses`: translation, rotation. */
    readonly poseStride = DIM + ROTATION;
    /** Numbers of a body in `velocities`: linear and angular velocity. */
    readonly velocityStride = DIM + ANGULAR;
    private readonly world: World;
    private cachedPoses: RealArray = new RealArrayType(0);
    private cachedVelocities: RealArray = new RealArrayType(0);
    private cachedSleeping = new Uint8Array(0);
    private cachedHandles = new Float64Array(0);

    /** @internal Worlds make theirs. */
    constructor(world: World) {
        this.world = world;
        this.refresh();
    }

    /** Brings the views up to date with changes since the last step. */
    refresh(): void {
        raw.mirror_refresh(this.world.id);
    }

    /** The number of slots. */
    get length(): number {
        return raw.mirror_len(this.world.id);
    }

    /** Translation and rotation of each body. */
    get poses(): RealArray {
        const [address, length] = [raw.mirror_address(this.world.id, 0), this.length * this.poseStride];
        const cached = this.cachedPoses;
        if (isMoved(cached, address, length)) {
            this.cachedPoses = new RealArrayType(raw.memory.buffer, address, length);
        }
        return this.cachedPoses;
    }

    /** Linear and angular velocity of each body. */
    get velocities(): RealArray {
        const [address, length] = [raw.mirror_address(this.world.id, 1), this.length * this.velocityStride];
        if (isMoved(this.cachedVelocities, address, length)) {
            this.cachedVelocities = new RealArrayType(raw.memory.buffer, address, length);
        }
        return this.cachedVelocities;
    }

    /** 1 for bodies that sleep or are fixed, and for slots without a body; 0 for others. */
    get sleeping(): Uint8Array {
        const [address, length] = [raw.mirror_address(this.world.id, 2), this.length];
        if (isMoved(this.cachedSleeping, address, length)) {
            this.cachedSleeping = new Uint8Array(raw.memory.buffer as ArrayBuffer, address, length);
        }
        return this.cachedSleeping;
    }

    /** The handle of each body. NaN for slots without a body. */
    get handles(): Float64Array {
        const [address, length] = [raw.mirror_address(this.world.id, 3), this.length];
        if (isMoved(this.cachedHandles, address, length)) {
            this.cachedHandles = new Float64Array(raw.memory.buffer as ArrayBuffer, address, length);
        }
        return this.cachedHandles;
    }
}

function isMoved(view: RealArray | Uint8Array | Float64Array, address: number, length: number): boolean {
    return view.length !== length || view.byteOffset !== address || view.buffer !== raw.memory.buffer;
}
