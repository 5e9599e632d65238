// Worlds in 3D: they have vehicles.

import type { RigidBody } from "#rigid_body";
import type { RigidBodyHandle } from "./rigid_body.js";
import { DynamicRayCastVehicleController } from "./vehicle_controller.js";
import { World as Base } from "./world.js";

/** A simulation: bodies, colliders, joints, and the state of the step. */
export class World extends Base {
    /** The vehicles of the world. */
    vehicleControllers = new Set<DynamicRayCastVehicleController>();

    /** Creates a vehicle of a body. */
    createVehicleController(chassis: RigidBody | RigidBodyHandle): DynamicRayCastVehicleController {
        const controller = new DynamicRayCastVehicleController(this, chassis);
        this.vehicleControllers.add(controller);
        return controller;
    }

    /** Removes a vehicle, and frees it. Its body stays. A vehicle that was removed before is ignored. */
    removeVehicleController(controller: DynamicRayCastVehicleController): void {
        this.removeController(this.vehicleControllers, controller, DynamicRayCastVehicleController);
    }

    override free(): void {
        this.vehicleControllers.forEach((controller) => controller.free());
        this.vehicleControllers.clear();
        super.free();
    }
}
