// The parts of rigid bodies that only 3D has, or that have other arguments there.

import {
    type AxisFlags,
    type AxisFlagsAndWakeUp,
    type MassProperties,
    ROTATIONS,
    ROTATION_SHIFT,
    type Rotation,
    RotationOps,
    TRANSLATIONS,
    copyRotation,
    copyVector,
    getRotation,
    lockedBits,
    splitLast,
} from "#dim";
import { raw } from "./raw.js";
import { RigidBodyDesc as Desc, RigidBody as Body, RigidBodyType } from "./rigid_body.js";

/** A rigid body of a world. */
export class RigidBody extends Body {
    /** Sets the axes about which the body can rotate. */
    setEnabledRotations(...flags: AxisFlagsAndWakeUp): void {
        const [enabled, wakeUp] = splitLast<boolean, boolean>(flags);
        const locked = lockedBits(enabled as AxisFlags) << ROTATION_SHIFT;
        raw.body_set_locked_axes(this.world.id, this.handle, ROTATIONS, locked, +wakeUp);
    }

    /** The same as `setEnabledRotations`. */
    restrictRotations(...flags: AxisFlagsAndWakeUp): void {
        this.setEnabledRotations(...flags);
    }

    /** The frame of the principal inertia. */
    principalInertiaLocalFrame(target?: Rotation): Rotation {
        raw.body_principal_inertia_frame(this.world.id, this.handle);
        return getRotation(0, target);
    }
}

/** Describes a rigid body. `World.createRigidBody` makes bodies of it. */
export class RigidBodyDesc extends Desc {
    angularInertiaLocalFrame: Rotation = RotationOps.identity();
    translationsEnabledZ = true;
    rotationsEnabledX = true;
    rotationsEnabledY = true;
    rotationsEnabledZ = true;

    /** A body that forces move. */
    static dynamic(): RigidBodyDesc {
        return new RigidBodyDesc(RigidBodyType.Dynamic);
    }

    /** A body whose next pose the program sets. */
    static kinematicPositionBased(): RigidBodyDesc {
        return new RigidBodyDesc(RigidBodyType.KinematicPositionBased);
    }

    /** A body whose velocity the program sets. */
    static kinematicVelocityBased(): RigidBodyDesc {
        return new RigidBodyDesc(RigidBodyType.KinematicVelocityBased);
    }

    /** A body that does not move. */
    static fixed(): RigidBodyDesc {
        return new RigidBodyDesc(RigidBodyType.Fixed);
    }

    /** @deprecated Use `dynamic`. */
    static newDynamic(): RigidBodyDesc {
        return RigidBodyDesc.dynamic();
    }

    /** @deprecated Use `kinematicPositionBased`. */
    static newKinematicPositionBased(): RigidBodyDesc {
        return RigidBodyDesc.kinematicPositionBased();
    }

    /** @deprecated Use `kinematicVelocityBased`. */
    static newKinematicVelocityBased(): RigidBodyDesc {
        return RigidBodyDesc.kinematicVelocityBased();
    }

    /** @deprecated Use `fixed`. */
    static newStatic(): RigidBodyDesc {
        return RigidBodyDesc.fixed();
    }

    /** Sets the mass properties that are added to those of the colliders. */
    setAdditionalMassProperties(...properties: MassProperties): this {
        const [mass, centerOfMass, inertia, frame] = properties;
        this.mass = mass;
        this.centerOfMass = copyVector(centerOfMass, "centerOfMass");
        this.principalAngularInertia = copyVector(inertia, "principalAngularInertia");
        this.angularInertiaLocalFrame = copyRotation(frame, "angularInertiaLocalFrame");
        this.massOnly = false;
        this.hasMassProperties = true;
        return this;
    }

    /** Sets the axes along which the body can move. */
    enabledTranslations(...enabled: AxisFlags): this {
        [this.translationsEnabledX, this.translationsEnabledY, this.translationsEnabledZ] = enabled;
        return this;
    }

    /** The same as `enabledTranslations`. */
    restrictTranslations(...enabled: AxisFlags): this {
        return this.enabledTranslations(...enabled);
    }

    /** Locks all translations. */
    lockTranslations(): this {
        return this.enabledTranslations(false, false, false);
    }

    /** Sets the axes about which the body can rotate. */
    enabledRotations(...enabled: AxisFlags): this {
        [this.rotationsEnabledX, this.rotationsEnabledY, this.rotationsEnabledZ] = enabled;
        return this;
    }

    /** The same as `enabledRotations`. */
    restrictRotations(...enabled: AxisFlags): this {
        return this.enabledRotations(...enabled);
    }

    /** Locks all rotations. */
    lockRotations(): this {
        return this.enabledRotations(false, false, false);
    }

    protected override lockedAxes(): number {
        const translations = lockedBits([this.translationsEnabledX, this.translationsEnabledY, this.translationsEnabledZ]);
        const rotations = lockedBits([this.rotationsEnabledX, this.rotationsEnabledY, this.rotationsEnabledZ]);
        return (translations & TRANSLATIONS) | (rotations << ROTATION_SHIFT);
    }

    protected override massProperties(): MassProperties {
        return [this.mass, this.centerOfMass, this.principalAngularInertia, this.angularInertiaLocalFrame];
    }
}
