import type { ColliderDesc } from "#collider_desc";
import { type Vector, VectorOps } from "#dim";
import type { RigidBody, RigidBodyDesc } from "#rigid_body";
import { World } from "#world";
import type { Collider } from "./collider.js";
import type { RestoredWorld } from "./world.js";

/** A world with the gravity of the earth along -y. */
export class PhysicsWorld extends World {
    /** The gravity is that of the earth along -y, unless another one is given. */
    constructor(gravity?: Vector, restored?: RestoredWorld) {
        const earth = VectorOps.zeros();
        earth.y = -9.81;
        super(gravity ?? earth, restored);
    }

    /** Creates a body with one collider. */
    insert(body: RigidBodyDesc, collider: ColliderDesc): [RigidBody, Collider] {
        const inserted = this.createRigidBody(body);
        try {
            return [inserted, this.createCollider(collider, inserted)];
        } catch (error) {
            this.removeRigidBody(inserted);
            throw error;
        }
    }
}
