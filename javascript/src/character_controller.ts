import { type Vector, VectorOps, getVector, putVector } from "#dim";
import { integer, real, requireFunction } from "./arguments.js";
import type { Collider, ColliderHandle } from "./collider.js";
import type { InteractionGroups, QueryFilterFlags } from "./enums.js";
import { Owner } from "./owner.js";
import { run } from "./query.js";
import { getNumber, raw } from "./raw.js";
import type { World } from "./world.js";

/** The settings, in the order of crates/wasm/src/controller.rs. */
const Setting = {
    offset: 0,
    slide: 1,
    autostepHeight: 2,
    autostepWidth: 3,
    autostepDynamic: 4,
    climbAngle: 5,
    slideAngle: 6,
    snap: 7,
    nudge: 8,
} as const;

/** Collision of a character during its movement. */
export class CharacterCollision {
    /** The collider that was hit. */
    collider: Collider | null = null;
    /** The movement before the collision. */
    translationDeltaApplied: Vector = VectorOps.zeros();
    /** The remaining movement at the collision. */
    translationDeltaRemaining: Vector = VectorOps.zeros();
    /** The fraction of the movement before the collision. */
    toi = 0;
    /** The contact point on the collider. */
    witness1: Vector = VectorOps.zeros();
    /** The contact point on the character. */
    witness2: Vector = VectorOps.zeros();
    /** The normal on the collider. */
    normal1: Vector = VectorOps.zeros();
    /** The normal on the character. */
    normal2: Vector = VectorOps.zeros();
}

/** The number, or null for NaN. */
function orNull(value: number): number | null {
    return Number.isNaN(value) ? null : value;
}

/** Moves a character: it slides along walls, climbs steps and stands on slopes. */
export class KinematicCharacterController extends Owner {
    /** @internal */
    readonly world: World;
    private pushes = false;
    private mass: number | null = null;

    /** @internal Worlds make controllers: `World.createCharacterController`. */
    constructor(world: World, offset: number) {
        super(raw.character_new(real(offset, "offset")), (id) => raw.character_free(id));
        this.world = world;
    }

    private get(setting: number): number {
        return raw.character_setting(this.id, setting);
    }

    private set(setting: number, name: string, value: number): void {
        raw.character_set_setting(this.id, setting, real(value, name));
    }

    /** The direction up. */
    up(): Vector {
        raw.character_up(this.id);
        return getVector(0);
    }

    /** Sets the direction up. */
    setUp(vector: Vector): void {
        putVector(0, vector, "up");
        raw.character_set_up(this.id);
    }

    /** Returns whether the character pushes dynamic bodies. */
    applyImpulsesToDynamicBodies(): boolean {
        return this.pushes;
    }

    /** Sets whether the character pushes dynamic bodies. */
    setApplyImpulsesToDynamicBodies(enabled: boolean): void {
        this.pushes = enabled;
    }

    /** The mass with which the character pushes. Null: the mass of its body. */
    characterMass(): number | null {
        return this.mass;
    }

    /** Sets the mass with which the character pushes. Null: the mass of its body. */
    setCharacterMass(mass: number | null): void {
        this.mass = mass === null || mass === undefined ? null : real(mass, "mass");
    }

    /** The gap between the character and obstacles. */
    offset(): number {
        return this.get(Setting.offset);
    }

    /** Sets the gap between the character and obstacles. */
    setOffset(value: number): void {
        this.set(Setting.offset, "offset", value);
    }

    /** The largest difference between a gap and the offset. */
    normalNudgeFactor(): number {
        return this.get(Setting.nudge);
    }

    /** Sets the largest difference between a gap and the offset. */
    setNormalNudgeFactor(value: number): void {
        this.set(Setting.nudge, "normalNudgeFactor", value);
    }

    /** Returns whether the character slides along obstacles. */
    slideEnabled(): boolean {
        return this.get(Setting.slide) !== 0;
    }

    /** Sets whether the character slides along obstacles. */
    setSlideEnabled(enabled: boolean): void {
        this.set(Setting.slide, "slideEnabled", +enabled);
    }

    /** The highest step that the character climbs, or null. */
    autostepMaxHeight(): number | null {
        return orNull(this.get(Setting.autostepHeight));
    }

    /** The narrowest step that the character climbs, or null. */
    autostepMinWidth(): number | null {
        return orNull(this.get(Setting.autostepWidth));
    }

    /** Returns whether the character climbs dynamic bodies. Null if it climbs no steps. */
    autostepIncludesDynamicBodies(): boolean | null {
        const value = orNull(this.get(Setting.autostepDynamic));
        return value === null ? null : value !== 0;
    }

    /** Returns whether the character climbs steps. */
    autostepEnabled(): boolean {
        return this.autostepMaxHeight() !== null;
    }

    /** Enables the climbing of steps. */
    enableAutostep(maxHeight: number, minWidth: number, includeDynamicBodies: boolean): void {
        raw.character_set_autostep(this.id, real(maxHeight, "maxHeight"), real(minWidth, "minWidth"), +includeDynamicBodies);
    }

    /** Disables the climbing of steps. */
    disableAutostep(): void {
        raw.character_clear_autostep(this.id);
    }

    /** The steepest slope that the character climbs, in radians. */
    maxSlopeClimbAngle(): number {
        return this.get(Setting.climbAngle);
    }

    /** Sets the steepest slope that the character climbs, in radians. */
    setMaxSlopeClimbAngle(angle: number): void {
        this.set(Setting.climbAngle, "maxSlopeClimbAngle", angle);
    }

    /** The least steep slope on which the character slides down, in radians. */
    minSlopeSlideAngle(): number {
        return this.get(Setting.slideAngle);
    }

    /** Sets the least steep slope on which the character slides down, in radians. */
    setMinSlopeSlideAngle(angle: number): void {
        this.set(Setting.slideAngle, "minSlopeSlideAngle", angle);
    }

    /** The distance below the feet within which the character snaps to the ground, or null. */
    snapToGroundDistance(): number | null {
        return orNull(this.get(Setting.snap));
    }

    /** Enables snapping to the ground. */
    enableSnapToGround(distance: number): void {
        this.set(Setting.snap, "distance", distance);
    }

    /** Disables snapping to the ground. */
    disableSnapToGround(): void {
        raw.character_clear_snap(this.id);
    }

    /** Returns whether the character snaps to the ground. */
    snapToGroundEnabled(): boolean {
        return this.snapToGroundDistance() !== null;
    }

    /**
     * Computes the movement of a collider. The results are read with `computedMovement` and its companions.
     */
    computeColliderMovement(
        collider: Collider | ColliderHandle,
        desiredTranslationDelta: Vector,
        filterFlags?: QueryFilterFlags,
        filterGroups?: InteractionGroups,
        filterPredicate?: (collider: Collider) => boolean,
    ): void {
        const { world } = this;
        const handle = world.handleOf(collider, "collider", "collider");
        const own = world.colliders.get(handle);
        const mass = this.pushes ? (this.mass ?? own?.parent()?.mass() ?? own?.mass() ?? NaN) : NaN;
        if (filterPredicate) {
            requireFunction(filterPredicate, "filterPredicate");
        }
        const accept = filterPredicate && ((other: ColliderHandle) => filterPredicate(world.colliders.get(other)!));
        putVector(0, desiredTranslationDelta, "desiredTranslationDelta");
        run([filterFlags, filterGroups, undefined, undefined, accept], () =>
            raw.character_move(this.id, world.id, handle, mass),
        );
    }

    /** The computed movement. */
    computedMovement(target?: Vector): Vector {
        raw.character_movement(this.id);
        return getVector(0, target);
    }

    /** Returns whether the character is grounded at the end of the computed movement. */
    computedGrounded(): boolean {
        return raw.character_movement(this.id) !== 0;
    }

    /** The number of collisions of the computed movement. */
    numComputedCollisions(): number {
        return raw.character_collisions(this.id);
    }

    /** A collision of the computed movement, by its index. */
    computedCollision(i: number, out?: CharacterCollision): CharacterCollision | null {
        const handle = raw.character_collision(this.id, integer(i, "i"));
        if (Number.isNaN(handle)) {
            return null;
        }
        const collision = out ?? new CharacterCollision();
        getVector(0, collision.translationDeltaApplied);
        getVector(1, collision.translationDeltaRemaining);
        getVector(2, collision.witness1);
        getVector(3, collision.witness2);
        getVector(4, collision.normal1);
        getVector(5, collision.normal2);
        collision.toi = getNumber(6, 0);
        collision.collider = this.world.colliders.get(handle);
        return collision;
    }
}
