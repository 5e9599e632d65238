// Vehicles on rays. Only 3D has them.

import { type Vector, getVector, putVector } from "#dim";
import type { RigidBody } from "#rigid_body";
import { integer, real, requireFunction } from "./arguments.js";
import type { Collider } from "./collider.js";
import type { InteractionGroups, QueryFilterFlags } from "./enums.js";
import { Owner } from "./owner.js";
import { putFilter } from "./query.js";
import { putIntegers, raw } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import type { World } from "./world.js";

/** A car whose wheels are rays. */
export class DynamicRayCastVehicleController extends Owner {
    /** @internal */
    readonly world: World;
    private readonly body: RigidBody;

    /** @internal Worlds make controllers: `World.createVehicleController`. */
    constructor(world: World, chassis: RigidBody | RigidBodyHandle) {
        const handle = world.handleOf(chassis, "rigid body", "chassis");
        super(raw.vehicle_new(world.id, handle), (id) => raw.vehicle_free(id));
        this.world = world;
        this.body = world.bodies.get(handle)!;
    }

    /**
     * Finds the ground under the wheels, and changes the velocity of the chassis. To be called before each
     * step.
     */
    updateVehicle(
        dt: number,
        filterFlags?: QueryFilterFlags,
        filterGroups?: InteractionGroups,
        filterPredicate?: (collider: Collider) => boolean,
    ): void {
        if (filterPredicate) {
            requireFunction(filterPredicate, "filterPredicate");
        }
        // The vehicle changes the world while it searches for the ground, so the predicate is called before.
        const leftOut = filterPredicate ? this.world.colliders.getAll().filter((collider) => filterPredicate(collider) === false) : [];
        const handles = Float64Array.from(leftOut, (collider) => collider.handle);
        putIntegers(new Uint32Array(handles.buffer), "the colliders");
        putFilter([filterFlags, filterGroups]);
        raw.vehicle_update(this.id, this.world.id, real(dt, "dt"));
    }

    /** The speed along the forward axis. */
    currentVehicleSpeed(): number {
        return raw.vehicle_speed(this.id);
    }

    /** The body of the vehicle. */
    chassis(): RigidBody {
        return this.body;
    }

    /** The axis of the chassis that points up: 0, 1 or 2. */
    get indexUpAxis(): number {
        return raw.vehicle_axis(this.id, 0);
    }

    set indexUpAxis(axis: number) {
        raw.vehicle_set_axis(this.id, 0, integer(axis, "indexUpAxis"));
    }

    /** The axis of the chassis that points forward: 0, 1 or 2. */
    get indexForwardAxis(): number {
        return raw.vehicle_axis(this.id, 1);
    }

    set indexForwardAxis(axis: number) {
        raw.vehicle_set_axis(this.id, 1, integer(axis, "indexForwardAxis"));
    }

    /** Sets the axis of the chassis that points forward: the name of the published packages. */
    set setIndexForwardAxis(axis: number) {
        this.indexForwardAxis = axis;
    }

    /** Adds a wheel. */
    addWheel(chassisConnectionCs: Vector, directionCs: Vector, axleCs: Vector, suspensionRestLength: number, radius: number): void {
        putVector(0, chassisConnectionCs, "chassisConnectionCs");
        putVector(1, directionCs, "directionCs");
        putVector(2, axleCs, "axleCs");
        raw.vehicle_add_wheel(this.id, real(suspensionRestLength, "suspensionRestLength"), real(radius, "radius"));
    }

    /** The number of wheels. */
    numWheels(): number {
        return raw.vehicle_wheels(this.id);
    }

    private get(i: number, what: number): number | null {
        const value = raw.wheel_get(this.id, integer(i, "i"), what);
        return Number.isNaN(value) ? null : value;
    }

    private vector(i: number, what: number, target?: Vector): Vector | null {
        return raw.wheel_vector(this.id, integer(i, "i"), what) ? getVector(0, target) : null;
    }

    private setVector(i: number, what: number, value: Vector): void {
        putVector(0, value, ["wheelChassisConnectionPointCs", "wheelDirectionCs", "wheelAxleCs"][what]!);
        raw.wheel_set_vector(this.id, integer(i, "i"), what);
    }

    /**
     * The point where the suspension is fixed to the chassis, in its frame. Null if there is no such wheel.
     */
    wheelChassisConnectionPointCs(i: number, target?: Vector): Vector | null {
        return this.vector(i, 0, target);
    }

    /** Sets the point where the suspension is fixed to the chassis, in its frame. */
    setWheelChassisConnectionPointCs(i: number, value: Vector): void {
        this.setVector(i, 0, value);
    }

    /** The direction of the suspension, in the frame of the chassis. Null if there is no such wheel. */
    wheelDirectionCs(i: number, target?: Vector): Vector | null {
        return this.vector(i, 1, target);
    }

    /** Sets the direction of the suspension, in the frame of the chassis. */
    setWheelDirectionCs(i: number, value: Vector): void {
        this.setVector(i, 1, value);
    }

    /** The axle, in the frame of the chassis. Null if there is no such wheel. */
    wheelAxleCs(i: number, target?: Vector): Vector | null {
        return this.vector(i, 2, target);
    }

    /** Sets the axle, in the frame of the chassis. */
    setWheelAxleCs(i: number, value: Vector): void {
        this.setVector(i, 2, value);
    }

    /** The normal of the ground under the wheel. Null if there is no such wheel. */
    wheelContactNormal(i: number, target?: Vector): Vector | null {
        return this.vector(i, 3, target);
    }

    /** The point where the wheel touches the ground. Null if there is no such wheel. */
    wheelContactPoint(i: number, target?: Vector): Vector | null {
        return this.vector(i, 4, target);
    }

    /** The point where the suspension is fixed, in world space. Null if there is no such wheel. */
    wheelHardPoint(i: number, target?: Vector): Vector | null {
        return this.vector(i, 5, target);
    }

    /** The length of the suspension without load. Null if there is no such wheel. */
    wheelSuspensionRestLength(i: number): number | null {
        return this.get(i, 0);
    }

    /** Sets the length of the suspension without load. */
    setWheelSuspensionRestLength(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 0, real(value, "wheelSuspensionRestLength"));
    }

    /** The largest travel of the suspension from its length without load. Null if there is no such wheel. */
    wheelMaxSuspensionTravel(i: number): number | null {
        return this.get(i, 1);
    }

    /** Sets the largest travel of the suspension from its length without load. */
    setWheelMaxSuspensionTravel(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 1, real(value, "wheelMaxSuspensionTravel"));
    }

    /** The radius. Null if there is no such wheel. */
    wheelRadius(i: number): number | null {
        return this.get(i, 2);
    }

    /** Sets the radius. */
    setWheelRadius(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 2, real(value, "wheelRadius"));
    }

    /** The stiffness of the suspension. Null if there is no such wheel. */
    wheelSuspensionStiffness(i: number): number | null {
        return this.get(i, 3);
    }

    /** Sets the stiffness of the suspension. */
    setWheelSuspensionStiffness(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 3, real(value, "wheelSuspensionStiffness"));
    }

    /** The damping of the suspension while it is compressed. Null if there is no such wheel. */
    wheelSuspensionCompression(i: number): number | null {
        return this.get(i, 4);
    }

    /** Sets the damping of the suspension while it is compressed. */
    setWheelSuspensionCompression(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 4, real(value, "wheelSuspensionCompression"));
    }

    /** The damping of the suspension while it relaxes. Null if there is no such wheel. */
    wheelSuspensionRelaxation(i: number): number | null {
        return this.get(i, 5);
    }

    /** Sets the damping of the suspension while it relaxes. */
    setWheelSuspensionRelaxation(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 5, real(value, "wheelSuspensionRelaxation"));
    }

    /** The largest force of the suspension. Null if there is no such wheel. */
    wheelMaxSuspensionForce(i: number): number | null {
        return this.get(i, 6);
    }

    /** Sets the largest force of the suspension. */
    setWheelMaxSuspensionForce(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 6, real(value, "wheelMaxSuspensionForce"));
    }

    /** The impulse of the brake. Null if there is no such wheel. */
    wheelBrake(i: number): number | null {
        return this.get(i, 7);
    }

    /** Sets the impulse of the brake. */
    setWheelBrake(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 7, real(value, "wheelBrake"));
    }

    /** The steering angle in radians. Null if there is no such wheel. */
    wheelSteering(i: number): number | null {
        return this.get(i, 8);
    }

    /** Sets the steering angle in radians. */
    setWheelSteering(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 8, real(value, "wheelSteering"));
    }

    /** The force of the engine. Null if there is no such wheel. */
    wheelEngineForce(i: number): number | null {
        return this.get(i, 9);
    }

    /** Sets the force of the engine. */
    setWheelEngineForce(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 9, real(value, "wheelEngineForce"));
    }

    /** The friction of the tyre. Null if there is no such wheel. */
    wheelFrictionSlip(i: number): number | null {
        return this.get(i, 10);
    }

    /** Sets the friction of the tyre. */
    setWheelFrictionSlip(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 10, real(value, "wheelFrictionSlip"));
    }

    /** The fraction of the sideways velocity that the tyre removes. Null if there is no such wheel. */
    wheelSideFrictionStiffness(i: number): number | null {
        return this.get(i, 11);
    }

    /** Sets the fraction of the sideways velocity that the tyre removes. */
    setWheelSideFrictionStiffness(i: number, value: number): void {
        raw.wheel_set(this.id, integer(i, "i"), 11, real(value, "wheelSideFrictionStiffness"));
    }

    /** The angle by which the wheel has turned. Null if there is no such wheel. */
    wheelRotation(i: number): number | null {
        return this.get(i, 12);
    }

    /** The impulse along the wheel in the last update. Null if there is no such wheel. */
    wheelForwardImpulse(i: number): number | null {
        return this.get(i, 13);
    }

    /** The impulse across the wheel in the last update. Null if there is no such wheel. */
    wheelSideImpulse(i: number): number | null {
        return this.get(i, 14);
    }

    /** The force of the suspension in the last update. Null if there is no such wheel. */
    wheelSuspensionForce(i: number): number | null {
        return this.get(i, 15);
    }

    /** The length of the suspension. Null if there is no such wheel. */
    wheelSuspensionLength(i: number): number | null {
        return this.get(i, 16);
    }

    /** Returns whether the wheel is on the ground. */
    wheelIsInContact(i: number): boolean {
        return raw.wheel_is_in_contact(this.id, integer(i, "i")) !== 0;
    }

    /** The collider under the wheel, or null. */
    wheelGroundObject(i: number): Collider | null {
        return this.world.colliders.get(raw.wheel_ground(this.id, integer(i, "i")));
    }
}
