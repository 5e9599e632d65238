// Parts of a collider's picture: one part is an instance of a shared geometry.

import type { BufferGeometry, Matrix4 } from "three";
import type { ShapeLike } from "../core/engine.ts";

export interface Part {
    /** Parts with the same key share geometry and draw call. */
    readonly key: string;
    build(): BufferGeometry;
    /** Scale of the shared geometry. */
    readonly scale: readonly [number, number, number];
    /** Pose within the collider, for compounds. */
    readonly offset?: Matrix4;
    /** Whether edges are drawn from the distance to the sides of a unit box. */
    readonly box?: boolean;
}

/** Returns the parts of a shape whose type has this name. */
export type Partition = (name: string, shape: ShapeLike, names: ReadonlyMap<number, string>) => Part[];

/** A short key of the contents of arrays, so that equal hulls share a geometry (FNV-1a). */
export function contentKey(...arrays: ArrayLike<number>[]): string {
    let hash = 0x811c9dc5;
    const bits = new Int32Array(1);
    const value = new Float32Array(bits.buffer);
    for (const array of arrays) {
        for (let index = 0; index < array.length; index++) {
            value[0] = array[index] ?? 0;
            hash = Math.imul(hash ^ (bits[0] ?? 0), 0x01000193);
        }
        hash = Math.imul(hash ^ array.length, 0x01000193);
    }
    return (hash >>> 0).toString(36);
}

/** A key of dimensions: a tenth of a millimetre makes no difference to the eye. */
export function sizeKey(...sizes: number[]): string {
    return sizes.map((size) => size.toFixed(4)).join(",");
}
