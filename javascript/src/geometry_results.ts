// The results of queries.

import { FEATURE_TYPES, FeatureType, type Vector, VectorOps, alongRay, getVector, putVector } from "#dim";
import { requireObject } from "./arguments.js";
import type { Collider } from "./collider.js";
import { getNumber, raw } from "./raw.js";

/** A ray. */
export class Ray {
    /** The origin of the ray. */
    origin: Vector;
    /** The direction. Its length is the distance that the ray covers per unit of time. */
    dir: Vector;

    constructor(origin: Vector, dir: Vector) {
        this.origin = origin;
        this.dir = dir;
    }

    /** The point of the ray at a time. */
    pointAt(t: number): Vector {
        return alongRay(this.origin, this.dir, t);
    }
}

/** Writes a ray into the scratch block. */
export function putRay(ray: Ray): void {
    requireObject(ray, "ray", "a Ray");
    putVector(0, ray.origin, "ray.origin");
    putVector(1, ray.dir, "ray.dir");
}

/** The object that a program gives for a result, if it gives one. */
function reused<T extends object>(target: T | null | undefined): T | undefined {
    if (target === undefined || target === null) {
        return undefined;
    }
    requireObject(target, "target", "an object of results");
    return target;
}

/** The feature that a query wrote into a place. */
function feature(place: number): [FeatureType, number | undefined] {
    const type = FEATURE_TYPES[getNumber(place, 0)] ?? FeatureType.Unknown;
    return [type, type === FeatureType.Unknown ? undefined : raw.query_feature_id(place) >>> 0];
}

/** The hit of a ray on a shape. */
export class RayIntersection {
    /** The time at which the ray hits: the point is `ray.pointAt(timeOfImpact)`. */
    timeOfImpact: number;
    /** The normal of the surface. */
    normal: Vector;
    featureType: FeatureType;
    featureId: number | undefined;

    constructor(timeOfImpact: number, normal: Vector, featureType: FeatureType = FeatureType.Unknown, featureId?: number) {
        this.timeOfImpact = timeOfImpact;
        this.normal = normal;
        this.featureType = featureType;
        this.featureId = featureId;
    }

    /** @internal */
    static read(target?: RayIntersection): RayIntersection {
        const hit = reused(target) ?? new RayIntersection(0, VectorOps.zeros());
        return readRay(hit);
    }
}

function readRay<T extends RayIntersection | RayColliderIntersection>(hit: T): T {
    hit.normal = getVector(0, hit.normal);
    hit.timeOfImpact = getNumber(2, 0);
    [hit.featureType, hit.featureId] = feature(1);
    return hit;
}

/** The hit of a ray on a collider. */
export class RayColliderIntersection {
    collider: Collider;
    /** The time at which the ray hits: the point is `ray.pointAt(timeOfImpact)`. */
    timeOfImpact: number;
    /** The normal of the surface. */
    normal: Vector;
    featureType: FeatureType;
    featureId: number | undefined;

    constructor(
        collider: Collider,
        timeOfImpact: number,
        normal: Vector,
        featureType: FeatureType = FeatureType.Unknown,
        featureId?: number,
    ) {
        this.collider = collider;
        this.timeOfImpact = timeOfImpact;
        this.normal = normal;
        this.featureType = featureType;
        this.featureId = featureId;
    }

    /** @internal */
    static read(collider: Collider, target?: RayColliderIntersection): RayColliderIntersection {
        const hit = reused(target) ?? new RayColliderIntersection(collider, 0, VectorOps.zeros());
        hit.collider = collider;
        return readRay(hit);
    }
}

/** The first hit of a ray. */
export class RayColliderHit {
    collider: Collider;
    /** The time at which the ray hits: the point is `ray.pointAt(timeOfImpact)`. */
    timeOfImpact: number;

    constructor(collider: Collider, timeOfImpact: number) {
        this.collider = collider;
        this.timeOfImpact = timeOfImpact;
    }
}

/** The point of a shape that is nearest to another point. */
export class PointProjection {
    point: Vector;
    /** Whether the point is inside the shape. */
    isInside: boolean;

    constructor(point: Vector, isInside: boolean) {
        this.point = point;
        this.isInside = isInside;
    }

    /** @internal */
    static read(isInside: boolean, target?: PointProjection): PointProjection {
        const projection = reused(target) ?? new PointProjection(VectorOps.zeros(), isInside);
        projection.point = getVector(0, projection.point);
        projection.isInside = isInside;
        return projection;
    }
}

/** The point of a collider that is nearest to another point. */
export class PointColliderProjection {
    collider: Collider;
    point: Vector;
    /** Whether the point is inside the collider. */
    isInside: boolean;
    featureType: FeatureType;
    featureId: number | undefined;

    constructor(
        collider: Collider,
        point: Vector,
        isInside: boolean,
        featureType: FeatureType = FeatureType.Unknown,
        featureId?: number,
    ) {
        this.collider = collider;
        this.point = point;
        this.isInside = isInside;
        this.featureType = featureType;
        this.featureId = featureId;
    }

    /** @internal */
    static read(collider: Collider, hasFeature: boolean, target?: PointColliderProjection): PointColliderProjection {
        const projection = reused(target) ?? new PointColliderProjection(collider, VectorOps.zeros(), false);
        projection.collider = collider;
        projection.point = getVector(0, projection.point);
        projection.isInside = getNumber(1, 0) !== 0;
        [projection.featureType, projection.featureId] = hasFeature ? feature(2) : [FeatureType.Unknown, undefined];
        return projection;
    }
}

/** The hit of two shapes that move. */
export class ShapeCastHit {
    /** The time at which the shapes touch. */
    time_of_impact: number;
    /** The contact point on the first shape. */
    witness1: Vector;
    /** The contact point on the second shape. */
    witness2: Vector;
    /** The normal on the first shape. */
    normal1: Vector;
    /** The normal on the second shape. */
    normal2: Vector;

    constructor(time_of_impact: number, witness1: Vector, witness2: Vector, normal1: Vector, normal2: Vector) {
        this.time_of_impact = time_of_impact;
        this.witness1 = witness1;
        this.witness2 = witness2;
        this.normal1 = normal1;
        this.normal2 = normal2;
    }

    /** @internal */
    static read(target?: ShapeCastHit): ShapeCastHit {
        const zero = VectorOps.zeros;
        return readCast(reused(target) ?? new ShapeCastHit(0, zero(), zero(), zero(), zero()));
    }
}

/** The hit of a moving shape on a collider. */
export class ColliderShapeCastHit extends ShapeCastHit {
    collider: Collider;

    constructor(collider: Collider, time_of_impact: number, witness1: Vector, witness2: Vector, normal1: Vector, normal2: Vector) {
        super(time_of_impact, witness1, witness2, normal1, normal2);
        this.collider = collider;
    }

    /** @internal */
    static readOf(collider: Collider, target?: ColliderShapeCastHit): ColliderShapeCastHit {
        const zero = VectorOps.zeros;
        const hit = reused(target) ?? new ColliderShapeCastHit(collider, 0, zero(), zero(), zero(), zero());
        hit.collider = collider;
        return readCast(hit);
    }
}

function readCast<T extends ShapeCastHit>(hit: T): T {
    hit.witness1 = getVector(0, hit.witness1);
    hit.witness2 = getVector(1, hit.witness2);
    hit.normal1 = getVector(2, hit.normal1);
    hit.normal2 = getVector(3, hit.normal2);
    hit.time_of_impact = getNumber(4, 0);
    return hit;
}

/** The contact of two shapes. */
export class ShapeContact {
    /** The distance of the two points. Negative if the shapes overlap. */
    distance: number;
    /** The contact point on the first shape. */
    point1: Vector;
    /** The contact point on the second shape. */
    point2: Vector;
    /** The normal on the first shape. */
    normal1: Vector;
    /** The normal on the second shape. */
    normal2: Vector;

    constructor(dist: number, point1: Vector, point2: Vector, normal1: Vector, normal2: Vector) {
        this.distance = dist;
        this.point1 = point1;
        this.point2 = point2;
        this.normal1 = normal1;
        this.normal2 = normal2;
    }

    /** @internal */
    static read(target?: ShapeContact): ShapeContact {
        const zero = VectorOps.zeros;
        const contact = reused(target) ?? new ShapeContact(0, zero(), zero(), zero(), zero());
        contact.point1 = getVector(0, contact.point1);
        contact.point2 = getVector(1, contact.point2);
        contact.normal1 = getVector(2, contact.normal1);
        contact.normal2 = getVector(3, contact.normal2);
        contact.distance = getNumber(4, 0);
        return contact;
    }
}
