import {
    type MassProperties,
    type Rotation,
    SHAPE_TYPES,
    ShapeType,
    type Vector,
    type VoxelArguments,
    type VoxelAndShift,
    type VoxelShift,
    getRotation,
    getVector,
    putMassProperties,
    putRotation,
    putVector,
    splitLast,
} from "#dim";
import type { RigidBody } from "#rigid_body";
import { integer, real, requireClass, requireLimits } from "./arguments.js";
import type { ActiveCollisionTypes, ActiveEvents, ActiveHooks, CoefficientCombineRule, InteractionGroups } from "./enums.js";
import { RapierError } from "./error.js";
import {
    ColliderShapeCastHit,
    PointProjection,
    type Ray,
    RayIntersection,
    ShapeCastHit,
    ShapeContact,
    putRay,
} from "./geometry_results.js";
import { getNumber, integersCopy, putIntegers, raw, realsCopy } from "./raw.js";
import type { RealArray } from "#real";
import { Code, SIZES, type Shape, putPose, putSizes, read, useShape } from "./shape.js";
import type { World } from "./world.js";

/** Identifies a collider of a world: slot and generation as the bits of a double. */
export type ColliderHandle = number;

/** The settings that are numbers, in the order of crates/wasm/src/collider.rs. */
const Setting = {
    friction: 0,
    restitution: 1,
    frictionRule: 2,
    restitutionRule: 3,
    collisionGroups: 4,
    solverGroups: 5,
    activeEvents: 6,
    activeHooks: 7,
    activeCollisionTypes: 8,
    forceThreshold: 9,
    contactSkin: 10,
    sensor: 11,
    enabled: 12,
    density: 13,
    mass: 14,
    volume: 15,
} as const;

/** A collider of a world. */
export class Collider {
    /** The world of the collider. */
    readonly world: World;
    /** Identifies the collider in its world. */
    readonly handle: ColliderHandle;
    private cachedShape: Shape | undefined;
    private readonly owner: RigidBody | null;

    /** @internal Worlds make colliders: `World.createCollider`. */
    constructor(world: World, handle: ColliderHandle, parent: RigidBody | null) {
        this.world = world;
        this.handle = handle;
        this.owner = parent;
    }

    /** Returns whether the collider is still in its world. */
    isValid(): boolean {
        return this.world.isAlive() && raw.colliders_contain(this.world.id, this.handle) !== 0;
    }

    /** The body of the collider. */
    parent(): RigidBody | null {
        return this.owner;
    }

    private setting(setting: number): number {
        return raw.collider_setting(this.world.id, this.handle, setting);
    }

    private setSetting(setting: number, value: number): void {
        raw.collider_set_setting(this.world.id, this.handle, setting, value);
    }

    // ---- Position ----

    /** The translation in world space. With a target, no object is created. */
    translation(target?: Vector): Vector {
        raw.collider_translation(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The rotation in world space. With a target, no object is created. */
    rotation(target?: Rotation): Rotation {
        raw.collider_rotation(this.world.id, this.handle);
        return getRotation(0, target);
    }

    /** The translation in the frame of the body, or null without one. */
    translationWrtParent(target?: Vector): Vector | null {
        return raw.collider_local_pose(this.world.id, this.handle) ? getVector(0, target) : null;
    }

    /** The rotation in the frame of the body, or null without one. */
    rotationWrtParent(target?: Rotation): Rotation | null {
        return raw.collider_local_pose(this.world.id, this.handle) ? getRotation(1, target) : null;
    }

    /** Moves the collider. With a body, the next step moves it back to the body. */
    setTranslation(tra: Vector): void {
        putVector(0, tra, "translation");
        raw.collider_set_translation(this.world.id, this.handle);
    }

    /** Sets the translation in the frame of the body. */
    setTranslationWrtParent(tra: Vector): void {
        putVector(0, tra, "translation");
        raw.collider_set_local_translation(this.world.id, this.handle);
    }

    /** Rotates the collider. With a body, the next step moves it back to the body. */
    setRotation(rot: Rotation): void {
        putRotation(0, rot, "rotation");
        raw.collider_set_rotation(this.world.id, this.handle);
    }

    /** Sets the rotation in the frame of the body. */
    setRotationWrtParent(rot: Rotation): void {
        putRotation(0, rot, "rotation");
        raw.collider_set_local_rotation(this.world.id, this.handle);
    }

    // ---- Settings ----

    /** Returns whether the collider is a sensor. */
    isSensor(): boolean {
        return this.setting(Setting.sensor) !== 0;
    }

    /** Makes the collider a sensor, or a solid. */
    setSensor(isSensor: boolean): void {
        this.setSetting(Setting.sensor, +isSensor);
    }

    /** Enables or disables the collider. */
    setEnabled(enabled: boolean): void {
        this.setSetting(Setting.enabled, +enabled);
    }

    /** Returns whether the collider is enabled. */
    isEnabled(): boolean {
        return this.setting(Setting.enabled) !== 0;
    }

    /** The coefficient of restitution. */
    restitution(): number {
        return this.setting(Setting.restitution);
    }

    /** Sets the coefficient of restitution. */
    setRestitution(restitution: number): void {
        this.setSetting(Setting.restitution, real(restitution, "restitution"));
    }

    /** The coefficient of friction. */
    friction(): number {
        return this.setting(Setting.friction);
    }

    /** Sets the coefficient of friction. */
    setFriction(friction: number): void {
        this.setSetting(Setting.friction, real(friction, "friction"));
    }

    /** The combine rule of friction. */
    frictionCombineRule(): CoefficientCombineRule {
        return this.setting(Setting.frictionRule);
    }

    /** Sets the combine rule of friction. */
    setFrictionCombineRule(rule: CoefficientCombineRule): void {
        this.setSetting(Setting.frictionRule, integer(rule, "frictionCombineRule"));
    }

    /** The combine rule of restitution. */
    restitutionCombineRule(): CoefficientCombineRule {
        return this.setting(Setting.restitutionRule);
    }

    /** Sets the combine rule of restitution. */
    setRestitutionCombineRule(rule: CoefficientCombineRule): void {
        this.setSetting(Setting.restitutionRule, integer(rule, "restitutionCombineRule"));
    }

    /** The interaction groups that filter collision pairs. */
    collisionGroups(): InteractionGroups {
        return this.setting(Setting.collisionGroups);
    }

    /** Sets the interaction groups that filter collision pairs. */
    setCollisionGroups(groups: InteractionGroups): void {
        this.setSetting(Setting.collisionGroups, integer(groups, "collisionGroups") >>> 0);
    }

    /** The interaction groups that filter contact forces. */
    solverGroups(): InteractionGroups {
        return this.setting(Setting.solverGroups);
    }

    /** Sets the interaction groups that filter contact forces. */
    setSolverGroups(groups: InteractionGroups): void {
        this.setSetting(Setting.solverGroups, integer(groups, "solverGroups") >>> 0);
    }

    /** The distance that the collider keeps from others. */
    contactSkin(): number {
        return this.setting(Setting.contactSkin);
    }

    /** Sets the distance that the collider keeps from others. */
    setContactSkin(thickness: number): void {
        this.setSetting(Setting.contactSkin, real(thickness, "contactSkin"));
    }

    /** The hooks of the collider. */
    activeHooks(): ActiveHooks {
        return this.setting(Setting.activeHooks);
    }

    /** Sets the hooks of the collider. */
    setActiveHooks(activeHooks: ActiveHooks): void {
        this.setSetting(Setting.activeHooks, integer(activeHooks, "activeHooks"));
    }

    /** The events of the collider. */
    activeEvents(): ActiveEvents {
        return this.setting(Setting.activeEvents);
    }

    /** Sets the events of the collider. */
    setActiveEvents(activeEvents: ActiveEvents): void {
        this.setSetting(Setting.activeEvents, integer(activeEvents, "activeEvents"));
    }

    /** Pairs of body types that collide. */
    activeCollisionTypes(): ActiveCollisionTypes {
        return this.setting(Setting.activeCollisionTypes);
    }

    /** Sets the pairs of body types that collide. */
    setActiveCollisionTypes(activeCollisionTypes: ActiveCollisionTypes): void {
        this.setSetting(Setting.activeCollisionTypes, integer(activeCollisionTypes, "activeCollisionTypes"));
    }

    /** The total force from which contact force events are sent. */
    contactForceEventThreshold(): number {
        return this.setting(Setting.forceThreshold);
    }

    /** Sets the total force from which contact force events are sent. */
    setContactForceEventThreshold(threshold: number): void {
        this.setSetting(Setting.forceThreshold, real(threshold, "contactForceEventThreshold"));
    }

    // ---- Mass ----

    /** The density. */
    density(): number {
        return this.setting(Setting.density);
    }

    /** Sets the density, from which mass and inertia follow. */
    setDensity(density: number): void {
        this.setSetting(Setting.density, real(density, "density"));
    }

    /** The mass. */
    mass(): number {
        return this.setting(Setting.mass);
    }

    /** Sets the mass, from which the inertia follows. */
    setMass(mass: number): void {
        this.setSetting(Setting.mass, real(mass, "mass"));
    }

    /** The volume (the area in 2D). */
    volume(): number {
        return this.setting(Setting.volume);
    }

    /** Sets mass, centre of mass and inertia, whatever the shape. */
    setMassProperties(...properties: MassProperties): void {
        putMassProperties(0, properties);
        raw.collider_set_mass_properties(this.world.id, this.handle, properties[0]);
    }

    // ---- Queries ----

    /** Returns whether a point is inside the collider. */
    containsPoint(point: Vector): boolean {
        putVector(0, point, "point");
        return raw.subject_contains_point(this.world.id, this.handle) !== 0;
    }

    /** The point of the collider that is nearest to a point. */
    projectPoint(point: Vector, solid: boolean, target?: PointProjection): PointProjection | null {
        putVector(0, point, "point");
        return PointProjection.read(raw.subject_project_point(this.world.id, this.handle, +solid) !== 0, target);
    }

    /** Returns whether a ray hits the collider. */
    intersectsRay(ray: Ray, maxToi: number): boolean {
        putRay(ray);
        return raw.subject_intersects_ray(this.world.id, this.handle, real(maxToi, "maxToi")) !== 0;
    }

    /** The time at which a ray hits the collider, or -1. */
    castRay(ray: Ray, maxToi: number, solid: boolean): number {
        putRay(ray);
        return raw.subject_cast_ray(this.world.id, this.handle, real(maxToi, "maxToi"), +solid);
    }

    /** The hit of a ray on the collider, or null. */
    castRayAndGetNormal(ray: Ray, maxToi: number, solid: boolean, target?: RayIntersection): RayIntersection | null {
        putRay(ray);
        return raw.subject_cast_ray_and_get_normal(this.world.id, this.handle, real(maxToi, "maxToi"), +solid) ? RayIntersection.read(target) : null;
    }

    /** The hit of the collider and a shape, both moving, or null. */
    castShape(
        collider1Vel: Vector,
        shape2: Shape,
        shape2Pos: Vector,
        shape2Rot: Rotation,
        shape2Vel: Vector,
        targetDistance: number,
        maxToi: number,
        stopAtPenetration: boolean,
        target?: ShapeCastHit,
    ): ShapeCastHit | null {
        requireLimits(targetDistance, maxToi);
        return useShape(shape2, "shape2", (other) => {
            putPose(10, shape2Pos, shape2Rot, ["shape2Pos", "shape2Rot"]);
            putVector(0, collider1Vel, "collider1Vel");
            putVector(1, shape2Vel, "shape2Vel");
            const { world, handle } = this;
            const hits = raw.subjects_cast(world.id, handle, 0, other, targetDistance, maxToi, +stopAtPenetration);
            return hits ? ShapeCastHit.read(target) : null;
        });
    }

    /** The hit of the collider and another one, both moving, or null. */
    castCollider(
        collider1Vel: Vector,
        collider2: Collider,
        collider2Vel: Vector,
        targetDistance: number,
        maxToi: number,
        stopAtPenetration: boolean,
        target?: ColliderShapeCastHit,
    ): ColliderShapeCastHit | null {
        requireLimits(targetDistance, maxToi);
        requireClass(collider2, Collider, "collider2", "a Collider");
        putVector(0, collider1Vel, "collider1Vel");
        putVector(1, collider2Vel, "collider2Vel");
        const [one, other] = [this.world.id, collider2.world.id];
        const hits = raw.subjects_cast(one, this.handle, other, collider2.handle, targetDistance, maxToi, +stopAtPenetration);
        return hits ? ColliderShapeCastHit.readOf(collider2, target) : null;
    }

    /** Returns whether the collider and a shape touch. */
    intersectsShape(shape2: Shape, shapePos2: Vector, shapeRot2: Rotation): boolean {
        return useShape(shape2, "shape2", (other) => {
            putPose(10, shapePos2, shapeRot2, ["shapePos2", "shapeRot2"]);
            return raw.subjects_intersect(this.world.id, this.handle, 0, other) !== 0;
        });
    }

    /** The contact of the collider and a shape, or null if they are farther apart than the prediction. */
    contactShape(
        shape2: Shape,
        shape2Pos: Vector,
        shape2Rot: Rotation,
        prediction: number,
        target?: ShapeContact,
    ): ShapeContact | null {
        return useShape(shape2, "shape2", (other) => {
            putPose(10, shape2Pos, shape2Rot, ["shape2Pos", "shape2Rot"]);
            return raw.subjects_contact(this.world.id, this.handle, 0, other, real(prediction, "prediction")) ? ShapeContact.read(target) : null;
        });
    }

    /** The contact of the collider and another one, or null if they are farther apart than the prediction. */
    contactCollider(collider2: Collider, prediction: number, target?: ShapeContact): ShapeContact | null {
        requireClass(collider2, Collider, "collider2", "a Collider");
        const other = collider2.world.id;
        const near = raw.subjects_contact(this.world.id, this.handle, other, collider2.handle, real(prediction, "prediction"));
        return near ? ShapeContact.read(target) : null;
    }

    // ---- Shape ----

    private describe(): number {
        return raw.collider_describe(this.world.id, this.handle);
    }

    /** A description of the shape. Changes of it do not change the collider. */
    get shape(): Shape {
        this.cachedShape ??= read(this.describe());
        return this.cachedShape;
    }

    /** Clears the cached description of the shape: the next access reads it again. */
    clearShapeCache(): void {
        this.cachedShape = undefined;
    }

    /** Replaces the shape. */
    setShape(shape: Shape): void {
        useShape(shape, "shape", (number) => raw.collider_set_shape(this.world.id, this.handle, number));
        this.cachedShape = undefined;
    }

    /** The kind of the shape. */
    shapeType(): ShapeType {
        const code = this.describe();
        const type = SHAPE_TYPES[code];
        if (type === undefined) {
            throw new RapierError("WrongShape", `the shape of kind ${code} has no ShapeType`);
        }
        return type;
    }

    /** A number of the shape, if it has it. */
    private size(component: number, codes: readonly number[], name: string): number {
        const code = this.describe();
        if (!codes.includes(code)) {
            throw this.wrongShape(code, name);
        }
        return getNumber(SIZES, component);
    }

    private wrongShape(code: number, name: string): RapierError {
        const type = SHAPE_TYPES[code];
        const shape = type === undefined ? `shape of kind ${code}` : ShapeType[type];
        return new RapierError("WrongShape", `a ${shape} has no ${name}`);
    }

    /** Rebuilds the shape after a change of its numbers. */
    private remake(codes: readonly number[], name: string, change: () => void): void {
        const code = this.describe();
        if (!codes.includes(code)) {
            throw this.wrongShape(code, name);
        }
        if (!BORDERED.includes(code)) {
            putSizes(getNumber(SIZES, 0), getNumber(SIZES, 1));
        }
        change();
        const number = raw.shape_new(code, 0, 0);
        try {
            raw.collider_set_shape(this.world.id, this.handle, number);
        } finally {
            raw.shape_free(number);
        }
        this.cachedShape = undefined;
    }

    /** Half the sides of a box, or null for other shapes. */
    halfExtents(target?: Vector): Vector | null {
        return BOXES.includes(this.describe()) ? getVector(0, target) : null;
    }

    /** Sets half the sides of a box. */
    setHalfExtents(newHalfExtents: Vector): void {
        this.remake(BOXES, "half extents", () => putVector(0, newHalfExtents, "halfExtents"));
    }

    /** The radius of a ball, capsule, cylinder or cone. */
    radius(): number {
        return this.size(0, ROUND, "radius");
    }

    /** Sets the radius of a ball, capsule, cylinder or cone. */
    setRadius(newRadius: number): void {
        this.remake(ROUND, "radius", () => putSizes(real(newRadius, "radius"), getNumber(SIZES, 1), getNumber(SIZES, 2)));
    }

    /** The radius of a round border. */
    roundRadius(): number {
        return this.size(2, BORDERED, "round border");
    }

    /** Sets the radius of a round border. */
    setRoundRadius(newBorderRadius: number): void {
        if (this.describe() === Code.roundConvex) {
            const shape = this.shape as Shape & { borderRadius: number };
            shape.borderRadius = newBorderRadius;
            this.setShape(shape);
            return;
        }
        this.remake(BORDERED, "round border", () => putSizes(getNumber(SIZES, 0), getNumber(SIZES, 1), real(newBorderRadius, "borderRadius")));
    }

    /** Half the height of a capsule, cylinder or cone. */
    halfHeight(): number {
        return this.size(1, TALL, "half height");
    }

    /** Sets half the height of a capsule, cylinder or cone. */
    setHalfHeight(newHalfheight: number): void {
        this.remake(TALL, "half height", () => putSizes(getNumber(SIZES, 0), real(newHalfheight, "halfHeight"), getNumber(SIZES, 2)));
    }

    /** The vertices of a mesh, polyline, convex shape, triangle or segment. */
    vertices(): RealArray {
        const code = this.describe();
        if (!LISTED.includes(code)) {
            throw this.wrongShape(code, "vertices");
        }
        return realsCopy();
    }

    /** The indices of a mesh, polyline or convex polyhedron. */
    indices(): Uint32Array | undefined {
        const code = this.describe();
        const has = LISTED.includes(code);
        const indices = has ? integersCopy() : undefined;
        return indices?.length ? indices : undefined;
    }

    /** The heights of a height field. */
    heightfieldHeights(): RealArray {
        this.size(0, [Code.heightfield], "heights");
        return realsCopy();
    }

    /** The size of a height field, or null for other shapes. */
    heightfieldScale(target?: Vector): Vector | null {
        return this.describe() === Code.heightfield ? getVector(0, target) : null;
    }

    /** The rows of cells of a height field. */
    heightfieldNRows(): number {
        this.size(0, [Code.heightfield], "rows");
        return integersCopy()[0] ?? 0;
    }

    /** The columns of cells of a height field. */
    heightfieldNCols(): number {
        this.size(0, [Code.heightfield], "columns");
        return integersCopy()[1] ?? realsCopy().length - 1;
    }

    /** Fills or empties a voxel. */
    setVoxel(...voxel: VoxelArguments): void {
        const [cell, filled] = splitLast<number, boolean>(voxel as readonly [...number[], boolean]);
        putIntegers([...cell.map((coordinate) => integer(coordinate, "a coordinate")), +filled], "the voxel");
        raw.collider_set_voxel(this.world.id, this.handle);
        this.cachedShape = undefined;
    }

    /**
     * Reports a change to neighbouring voxels of another collider, so that no internal edges are between
     * them.
     */
    propagateVoxelChange(voxels2: Collider, ...coordinates: VoxelAndShift): void {
        putIntegers(coordinates.map((part) => integer(part, "a coordinate")), "the coordinates");
        raw.collider_propagate_voxel(this.world.id, this.handle, this.world.handleOf(voxels2, "collider", "voxels2"));
    }

    /** Joins the voxels of two colliders, so that no internal edges are between them. */
    combineVoxelStates(voxels2: Collider, ...shift: VoxelShift): void {
        putIntegers(shift.map((part) => integer(part, "the shift")), "the shift");
        raw.collider_combine_voxels(this.world.id, this.handle, this.world.handleOf(voxels2, "collider", "voxels2"));
    }
}

const BOXES: readonly number[] = [Code.cuboid, Code.roundCuboid];
const TALL: readonly number[] = [Code.capsule, Code.cylinder, Code.cone, Code.roundCylinder, Code.roundCone];
const ROUND: readonly number[] = [Code.ball, ...TALL];
const BORDERED: readonly number[] = [Code.roundCuboid, Code.roundTriangle, Code.roundCylinder, Code.roundCone, Code.roundConvex];
const LISTED: readonly number[] = [Code.trimesh, Code.polyline, Code.convex, Code.roundConvex];
