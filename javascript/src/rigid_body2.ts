// The parts of rigid bodies that only 2D has, or that have other arguments there.

import { type AxisFlags, type MassProperties, ROTATIONS, copyVector, lockedBits } from "#dim";
import { RigidBodyDesc as Desc, RigidBodyType } from "./rigid_body.js";

export { RigidBody } from "./rigid_body.js";

/** Describes a rigid body. `World.createRigidBody` makes bodies of it. */
export class RigidBodyDesc extends Desc {
    rotationsEnabled = true;

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
        const [mass, centerOfMass, inertia] = properties;
        this.mass = mass;
        this.centerOfMass = copyVector(centerOfMass, "centerOfMass");
        this.principalAngularInertia = inertia;
        this.massOnly = false;
        this.hasMassProperties = true;
        return this;
    }

    /** Sets the axes along which the body can move. */
    enabledTranslations(...enabled: AxisFlags): this {
        [this.translationsEnabledX, this.translationsEnabledY] = enabled;
        return this;
    }

    /** The same as `enabledTranslations`. */
    restrictTranslations(...enabled: AxisFlags): this {
        return this.enabledTranslations(...enabled);
    }

    /** Locks all translations. */
    lockTranslations(): this {
        return this.enabledTranslations(false, false);
    }

    /** Locks all rotations. */
    lockRotations(): this {
        this.rotationsEnabled = false;
        return this;
    }

    protected override lockedAxes(): number {
        const translations = lockedBits([this.translationsEnabledX, this.translationsEnabledY]);
        return translations | (this.rotationsEnabled ? 0 : ROTATIONS);
    }
}
