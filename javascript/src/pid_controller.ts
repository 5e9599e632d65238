import {
    type AngVector,
    type PidAxesMask,
    type Rotation,
    type Vector,
    getAngular,
    getVector,
    putAngular,
    putRotation,
    putVector,
} from "#dim";
import type { RigidBody } from "#rigid_body";
import { integer, real } from "./arguments.js";
import { Owner } from "./owner.js";
import { raw } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import type { World } from "./world.js";

/** The gains, in the order of crates/wasm/src/controller.rs. */
const Gain = { proportional: 0, integral: 1, derivative: 2 } as const;

/** Keeps a body at a pose by corrections of its velocity. */
export class PidController extends Owner {
    /** @internal */
    readonly world: World;

    /** @internal Worlds make controllers: `World.createPidController`. */
    constructor(world: World, kp: number, ki: number, kd: number, axes: PidAxesMask) {
        super(raw.pid_new(real(kp, "kp"), real(ki, "ki"), real(kd, "kd"), integer(axes, "axes")), (id) => raw.pid_free(id));
        this.world = world;
    }

    /** Sets the proportional gain of some axes. */
    setKp(kp: number, axes: PidAxesMask): void {
        raw.pid_set_gain(this.id, Gain.proportional, real(kp, "kp"), integer(axes, "axes"));
    }

    /** Sets the integral gain of some axes. */
    setKi(ki: number, axes: PidAxesMask): void {
        raw.pid_set_gain(this.id, Gain.integral, real(ki, "ki"), integer(axes, "axes"));
    }

    /** Sets the derivative gain of some axes. */
    setKd(kd: number, axes: PidAxesMask): void {
        raw.pid_set_gain(this.id, Gain.derivative, real(kd, "kd"), integer(axes, "axes"));
    }

    /** Sets the axes that are corrected. */
    setAxes(axes: PidAxesMask): void {
        raw.pid_set_axes(this.id, integer(axes, "axes"));
    }

    /** Resets the integrals. */
    resetIntegrals(): void {
        raw.pid_reset(this.id);
    }

    private linear(body: RigidBody | RigidBodyHandle, position: Vector, velocity: Vector, apply: number): void {
        const handle = this.world.handleOf(body, "rigid body", "body");
        putVector(0, position, "targetPosition");
        putVector(1, velocity, "targetLinvel");
        raw.pid_linear(this.id, this.world.id, handle, apply);
    }

    private angular(body: RigidBody | RigidBodyHandle, rotation: Rotation, velocity: AngVector, apply: number): void {
        const handle = this.world.handleOf(body, "rigid body", "body");
        putRotation(0, rotation, "targetRotation");
        putAngular(1, velocity, "targetAngVel");
        raw.pid_angular(this.id, this.world.id, handle, apply);
    }

    /** Corrects the linear velocity of a body. */
    applyLinearCorrection(body: RigidBody | RigidBodyHandle, targetPosition: Vector, targetLinvel: Vector): void {
        this.linear(body, targetPosition, targetLinvel, 1);
    }

    /** Corrects the angular velocity of a body. */
    applyAngularCorrection(body: RigidBody | RigidBodyHandle, targetRotation: Rotation, targetAngVel: AngVector): void {
        this.angular(body, targetRotation, targetAngVel, 1);
    }

    /** The correction of the linear velocity of a body. */
    linearCorrection(body: RigidBody | RigidBodyHandle, targetPosition: Vector, targetLinvel: Vector, target?: Vector): Vector {
        this.linear(body, targetPosition, targetLinvel, 0);
        return getVector(0, target);
    }

    /** The correction of the angular velocity of a body. */
    angularCorrection(body: RigidBody | RigidBodyHandle, targetRotation: Rotation, targetAngVel: AngVector, target?: AngVector): AngVector {
        this.angular(body, targetRotation, targetAngVel, 0);
        return getAngular(0, target);
    }
}
