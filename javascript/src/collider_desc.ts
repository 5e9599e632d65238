// The parts of descriptions of colliders that both dimensions have. collider_shapes.ts and those of the
// dimensions add constructors.

import {
    type AngVector,
    type Components,
    type MassProperties,
    type Rotation,
    RotationOps,
    type Vector,
    VectorOps,
    copyAngular,
    copyRotation,
    copyVector,
    putMassProperties,
    putRotation,
    putVector,
    vectorOf,
    zeroAngular,
} from "#dim";
import { integer, real, requireList } from "./arguments.js";
import {
    ActiveCollisionTypes,
    ActiveEvents,
    ActiveHooks,
    CoefficientCombineRule,
    type InteractionGroups,
    MassPropsMode,
} from "./enums.js";
import { putIntegers, putNumber, raw } from "./raw.js";
import { type Shape, useShape } from "./shape.js";

/** The settings that are whole numbers, in the order of crates/wasm/src/collider.rs. */
const SETTINGS = [
    "frictionCombineRule",
    "restitutionCombineRule",
    "collisionGroups",
    "solverGroups",
    "activeEvents",
    "activeHooks",
    "activeCollisionTypes",
] as const;

/** Describes a collider. `World.createCollider` makes colliders of it. */
export class ColliderDescBase {
    enabled = true;
    shape: Shape;
    massPropsMode = MassPropsMode.Density;
    mass = 0;
    centerOfMass: Vector = VectorOps.zeros();
    principalAngularInertia: AngVector = zeroAngular();
    density = 1;
    friction = 0.5;
    restitution = 0;
    rotation: Rotation = RotationOps.identity();
    translation: Vector = VectorOps.zeros();
    isSensor = false;
    collisionGroups: InteractionGroups = 0xffff_ffff;
    solverGroups: InteractionGroups = 0xffff_ffff;
    frictionCombineRule = CoefficientCombineRule.Average;
    restitutionCombineRule = CoefficientCombineRule.Average;
    activeEvents = ActiveEvents.NONE;
    activeHooks = ActiveHooks.NONE;
    activeCollisionTypes = ActiveCollisionTypes.DEFAULT;
    contactForceEventThreshold = 0;
    contactSkin = 0;

    constructor(shape: Shape) {
        this.shape = shape;
    }

    setTranslation(...components: Components): this {
        this.translation = vectorOf(components);
        return this;
    }

    setRotation(rot: Rotation): this {
        this.rotation = copyRotation(rot, "rotation");
        return this;
    }

    setSensor(sensor: boolean): this {
        this.isSensor = sensor;
        return this;
    }

    setEnabled(enabled: boolean): this {
        this.enabled = enabled;
        return this;
    }

    setContactSkin(thickness: number): this {
        this.contactSkin = thickness;
        return this;
    }

    /** Sets the density, from which mass and inertia follow. */
    setDensity(density: number): this {
        this.massPropsMode = MassPropsMode.Density;
        this.density = density;
        return this;
    }

    /** Sets the mass, from which the inertia follows. */
    setMass(mass: number): this {
        this.massPropsMode = MassPropsMode.Mass;
        this.mass = mass;
        return this;
    }

    /** Sets mass, centre of mass and inertia, whatever the shape. */
    setMassProperties(...properties: MassProperties): this {
        this.massPropsMode = MassPropsMode.MassProps;
        const [mass, centerOfMass, inertia] = properties;
        this.mass = mass;
        this.centerOfMass = copyVector(centerOfMass, "centerOfMass");
        this.principalAngularInertia = copyAngular(inertia, "principalAngularInertia");
        return this;
    }

    setRestitution(restitution: number): this {
        this.restitution = restitution;
        return this;
    }

    setFriction(friction: number): this {
        this.friction = friction;
        return this;
    }

    setFrictionCombineRule(rule: CoefficientCombineRule): this {
        this.frictionCombineRule = rule;
        return this;
    }

    setRestitutionCombineRule(rule: CoefficientCombineRule): this {
        this.restitutionCombineRule = rule;
        return this;
    }

    setCollisionGroups(groups: InteractionGroups): this {
        this.collisionGroups = groups;
        return this;
    }

    setSolverGroups(groups: InteractionGroups): this {
        this.solverGroups = groups;
        return this;
    }

    setActiveHooks(activeHooks: ActiveHooks): this {
        this.activeHooks = activeHooks;
        return this;
    }

    setActiveEvents(activeEvents: ActiveEvents): this {
        this.activeEvents = activeEvents;
        return this;
    }

    setActiveCollisionTypes(activeCollisionTypes: ActiveCollisionTypes): this {
        this.activeCollisionTypes = activeCollisionTypes;
        return this;
    }

    setContactForceEventThreshold(threshold: number): this {
        this.contactForceEventThreshold = threshold;
        return this;
    }

    /** The mass properties as arguments. */
    protected massProperties(): MassProperties {
        return [this.mass, this.centerOfMass, this.principalAngularInertia] as unknown as MassProperties;
    }

    /** @internal Creates the collider. Returns its handle. */
    create(world: number, parent: number): number {
        return useShape(this.shape, "shape", (shape) => {
            putVector(0, this.translation, "translation");
            putRotation(1, this.rotation, "rotation");
            putMassProperties(2, this.massProperties());
            putNumber(5, 0, real(this.friction, "friction"));
            putNumber(5, 1, real(this.restitution, "restitution"));
            putNumber(5, 2, real(this.contactForceEventThreshold, "contactForceEventThreshold"));
            putNumber(5, 3, real(this.contactSkin, "contactSkin"));
            putNumber(6, 0, real(this.density, "density"));
            putNumber(6, 1, this.mass);
            putIntegers(SETTINGS.map((name) => integer(this[name], name)), "the settings");
            return raw.collider_create(world, shape, parent, integer(this.massPropsMode, "massPropsMode"), +this.isSensor, +this.enabled);
        });
    }
}

/** A shape of points, as descriptions of hulls have it. */
interface ShapeOfPoints extends Shape {
    readonly vertices: ArrayLike<number>;
    readonly indices?: ArrayLike<number> | null;
}

/** The result of work, or null if a shape cannot be made of the points. */
export function orNull<T>(shape: ShapeOfPoints, make: (shape: Shape) => T): T | null {
    requireList(shape.vertices, "points");
    requireList(shape.indices ?? [], "indices");
    if ("borderRadius" in shape) {
        real(shape.borderRadius as number, "borderRadius");
    }
    try {
        shape.use(() => undefined);
    } catch {
        return null;
    }
    return make(shape);
}
