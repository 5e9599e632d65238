// Queries of worlds and of their broad phases.

import { type Rotation, type Vector, putRotation, putVector } from "#dim";
import { integer, real, requireFunction, requireLimits } from "./arguments.js";
import type { Collider, ColliderHandle } from "./collider.js";
import type { InteractionGroups, QueryFilterFlags } from "./enums.js";
import {
    ColliderShapeCastHit,
    PointColliderProjection,
    type Ray,
    RayColliderHit,
    RayColliderIntersection,
    putRay,
} from "./geometry_results.js";
import { getNumber, raw, withCallbacks } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import { type Shape, useShape } from "./shape.js";
import type { World } from "./world.js";

/** The filter of a query, as its last arguments: flags, groups, a collider, a body, a predicate. */
export type Filter = [
    filterFlags?: QueryFilterFlags | undefined,
    filterGroups?: InteractionGroups | undefined,
    filterExcludeCollider?: ColliderHandle | undefined,
    filterExcludeRigidBody?: RigidBodyHandle | undefined,
    filterPredicate?: ((collider: ColliderHandle) => boolean) | undefined,
];

/** Stores the filter of the next query. */
export function putFilter([flags, groups, collider, body, predicate]: Filter): void {
    const [own, mask] = [integer(flags ?? 0, "filterFlags"), groups == null ? -1 : integer(groups, "filterGroups") >>> 0];
    raw.query_filter(own, mask, real(collider ?? NaN, "filterExcludeCollider"), real(body ?? NaN, "filterExcludeRigidBody"), +!!predicate);
}

const NO_CALLBACKS = {};

/** Runs a query with a filter and a visitor. */
export function run<R>(filter: Filter, call: () => R, ...visitors: [visitor?: (collider: ColliderHandle) => boolean]): R {
    const [predicate, visitor] = [filter[4], visitors[0]];
    if (visitors.length > 0) {
        requireFunction(visitor, "callback");
    }
    if (predicate) {
        requireFunction(predicate, "filterPredicate");
    }
    putFilter(filter);
    if (!predicate && !visitor) {
        return withCallbacks(NO_CALLBACKS, call);
    }
    return withCallbacks({ ...(predicate && { accept: predicate }), ...(visitor && { visitor }) }, call);
}

/** The bounding boxes of a world's colliders, which queries search. */
export class BroadPhase {
    private readonly world: World;

    /** @internal Worlds make theirs. */
    constructor(world: World) {
        this.world = world;
    }

    private collider(handle: number): Collider | null {
        return Number.isNaN(handle) ? null : this.world.colliders.get(handle);
    }

    /** The first collider that a ray hits. */
    castRay(_n: unknown, _b: unknown, _c: unknown, ray: Ray, maxToi: number, solid: boolean, ...filter: Filter): RayColliderHit | null {
        putRay(ray);
        const found = this.collider(run(filter, () => raw.query_cast_ray(this.world.id, real(maxToi, "maxToi"), +solid)));
        return found && new RayColliderHit(found, getNumber(2, 0));
    }

    /** The first collider that a ray hits, with the normal there. */
    castRayAndGetNormal(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        ray: Ray,
        maxToi: number,
        solid: boolean,
        ...rest: [...Filter, target?: RayColliderIntersection | undefined]
    ): RayColliderIntersection | null {
        putRay(ray);
        const [filter, target] = splitTarget(rest);
        const found = this.collider(run(filter, () => raw.query_cast_ray_and_get_normal(this.world.id, real(maxToi, "maxToi"), +solid)));
        return found && RayColliderIntersection.read(found, target);
    }

    /** Calls a callback with all colliders that a ray hits, until it returns false. */
    intersectionsWithRay(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        ray: Ray,
        maxToi: number,
        solid: boolean,
        callback: (intersect: RayColliderIntersection) => boolean,
        ...filter: Filter
    ): void {
        requireFunction(callback, "callback");
        putRay(ray);
        const visitor = (handle: ColliderHandle) => callback(RayColliderIntersection.read(this.collider(handle)!));
        run(filter, () => raw.query_intersections_with_ray(this.world.id, real(maxToi, "maxToi"), +solid), visitor);
    }

    /** A collider that a shape touches. */
    intersectionWithShape(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        shapePos: Vector,
        shapeRot: Rotation,
        shape: Shape,
        ...filter: Filter
    ): ColliderHandle | null {
        const found = useShape(shape, "shape", (number) => {
            putVector(0, shapePos, "shapePos");
            putRotation(1, shapeRot, "shapeRot");
            return run(filter, () => raw.query_intersection_with_shape(this.world.id, number));
        });
        return Number.isNaN(found) ? null : found;
    }

    /** The collider nearest to a point. */
    projectPoint(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        point: Vector,
        solid: boolean,
        ...rest: [...Filter, target?: PointColliderProjection | undefined]
    ): PointColliderProjection | null {
        putVector(0, point, "point");
        const [filter, target] = splitTarget(rest);
        const found = this.collider(run(filter, () => raw.query_project_point(this.world.id, +solid)));
        return found && PointColliderProjection.read(found, false, target);
    }

    /** The collider whose surface is nearest to a point, with the feature there. */
    projectPointAndGetFeature(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        point: Vector,
        ...rest: [...Filter, target?: PointColliderProjection | undefined]
    ): PointColliderProjection | null {
        putVector(0, point, "point");
        const [filter, target] = splitTarget(rest);
        const found = this.collider(run(filter, () => raw.query_project_point_and_get_feature(this.world.id)));
        return found && PointColliderProjection.read(found, true, target);
    }

    /** Calls a callback with all colliders that contain a point, until it returns false. */
    intersectionsWithPoint(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        point: Vector,
        callback: (handle: ColliderHandle) => boolean,
        ...filter: Filter
    ): void {
        putVector(0, point, "point");
        run(filter, () => raw.query_intersections_with_point(this.world.id), callback);
    }

    /** The first collider in the path of a shape. */
    castShape(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        shapePos: Vector,
        shapeRot: Rotation,
        shapeVel: Vector,
        shape: Shape,
        targetDistance: number,
        maxToi: number,
        stopAtPenetration: boolean,
        ...rest: [...Filter, target?: ColliderShapeCastHit | undefined]
    ): ColliderShapeCastHit | null {
        requireLimits(targetDistance, maxToi);
        const [filter, target] = splitTarget(rest);
        const found = useShape(shape, "shape", (number) => {
            putVector(0, shapePos, "shapePos");
            putRotation(1, shapeRot, "shapeRot");
            putVector(2, shapeVel, "shapeVel");
            return run(filter, () => raw.query_cast_shape(this.world.id, number, targetDistance, maxToi, +stopAtPenetration));
        });
        const collider = this.collider(found);
        return collider && ColliderShapeCastHit.readOf(collider, target);
    }

    /** Calls a callback with all colliders that a shape touches, until it returns false. */
    intersectionsWithShape(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        shapePos: Vector,
        shapeRot: Rotation,
        shape: Shape,
        callback: (handle: ColliderHandle) => boolean,
        ...filter: Filter
    ): void {
        useShape(shape, "shape", (number) => {
            putVector(0, shapePos, "shapePos");
            putRotation(1, shapeRot, "shapeRot");
            run(filter, () => raw.query_intersections_with_shape(this.world.id, number), callback);
        });
    }

    /** Calls a callback with all colliders whose boxes overlap a box, until it returns false. */
    collidersWithAabbIntersectingAabb(
        _n: unknown,
        _b: unknown,
        _c: unknown,
        aabbCenter: Vector,
        aabbHalfExtents: Vector,
        callback: (handle: ColliderHandle) => boolean,
    ): void {
        putVector(0, aabbCenter, "aabbCenter");
        putVector(1, aabbHalfExtents, "aabbHalfExtents");
        run([], () => raw.query_colliders_in_aabb(this.world.id), callback);
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}

/** The filter and the target of a query. */
function splitTarget<T>(rest: [...Filter, target?: T | undefined]): [Filter, T | undefined] {
    return [rest.slice(0, 5) as Filter, rest[5] as T | undefined];
}
