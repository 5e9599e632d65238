import { integer, requireFunction } from "./arguments.js";
import type { Collider, ColliderHandle } from "./collider.js";
import type { QueryFilterFlags } from "./enums.js";
import { run } from "./query.js";
import { raw, realsCopy } from "./raw.js";
import { type RealArray, RealArrayType } from "#real";
import type { World } from "./world.js";

/** Lines to draw a world with. */
export class DebugRenderBuffers {
    /** The points, two for each line. */
    vertices: RealArray;
    /** Red, green, blue and opacity of each point. */
    colors: Float32Array;

    constructor(vertices: RealArray, colors: Float32Array) {
        this.vertices = vertices;
        this.colors = colors;
    }
}

/** Draws a world as lines. */
export class DebugRenderPipeline {
    private readonly world: World;
    vertices: RealArray;
    colors: Float32Array = new Float32Array(0);
    /** The drawn lines, as bits of the engine's `DebugRenderMode`. 0 selects the default lines. */
    mode = 0;

    /** @internal Worlds make theirs. */
    constructor(world: World) {
        this.world = world;
        this.vertices = new RealArrayType(0);
    }

    /** Draws the world of the sets. */
    render(
        _bodies?: unknown,
        _colliders?: unknown,
        _impulseJoints?: unknown,
        _multibodyJoints?: unknown,
        _narrowPhase?: unknown,
        filterFlags?: QueryFilterFlags,
        filterPredicate?: (collider: Collider) => boolean,
    ): void {
        if (filterPredicate) {
            requireFunction(filterPredicate, "filterPredicate");
        }
        const { colliders } = this.world;
        const accept = filterPredicate && ((handle: ColliderHandle) => filterPredicate(colliders.get(handle)!));
        const filter = [filterFlags, undefined, undefined, undefined, accept] as const;
        const count = run([...filter], () => raw.debug_render(this.world.id, integer(this.mode, "mode")));
        this.vertices = realsCopy();
        this.colors = new Float32Array(raw.memory.buffer, raw.debug_colors_address(), count).slice();
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}
