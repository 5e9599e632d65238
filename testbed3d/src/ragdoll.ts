// A person of eleven capsules, with joints that bend like a person's.

import { rotated, vec, X } from "./kit.ts";
import type { Context, RevoluteImpulseJoint, RigidBody, Rotation, Vector } from "./rapier.ts";

interface Limb {
    body: RigidBody;
    /** Middle of the limb in the standing person's frame. */
    middle: Vector;
}

/** Density of the limbs relative to water. */
const DENSITY = 1;

/** Angular damping of limbs, in place of muscles. */
const LIMPNESS = 1.5;

class Ragdoll {
    readonly limbs: RigidBody[] = [];

    constructor(
        private readonly context: Context,
        private readonly at: Vector,
        private readonly rotation: Rotation,
    ) {}

    /** A capsule between two points of the standing person. */
    limb(from: Vector, to: Vector, radius: number): Limb {
        const { RAPIER, world } = this.context;
        const middle = vec((from.x + to.x) / 2, (from.y + to.y) / 2, (from.z + to.z) / 2);
        const way = vec(to.x - from.x, to.y - from.y, to.z - from.z);
        const length = Math.hypot(way.x, way.y, way.z);
        const place = rotated(this.rotation, middle);
        const body = world.createRigidBody(
            RAPIER.RigidBodyDesc.dynamic()
                .setTranslation(this.at.x + place.x, this.at.y + place.y, this.at.z + place.z)
                .setRotation(this.rotation)
                .setAngularDamping(LIMPNESS),
        );
        const capsule = RAPIER.ColliderDesc.capsule(length / 2, radius).setDensity(DENSITY).setFriction(0.6);
        world.createCollider(capsule.setRotation(fromUp(way, length)), body);
        this.limbs.push(body);
        return { body, middle };
    }

    private data(first: Limb, second: Limb, at: Vector): [Vector, Vector] {
        return [
            vec(at.x - first.middle.x, at.y - first.middle.y, at.z - first.middle.z),
            vec(at.x - second.middle.x, at.y - second.middle.y, at.z - second.middle.z),
        ];
    }

    /** A ball and socket. */
    socket(first: Limb, second: Limb, at: Vector): void {
        const { RAPIER, world } = this.context;
        const data = RAPIER.JointData.spherical(...this.data(first, second, at));
        world.createImpulseJoint(data, first.body, second.body, true).setContactsEnabled(false);
    }

    /** A knee or an elbow, which bends one way. */
    hinge(first: Limb, second: Limb, at: Vector, axis: Vector): void {
        const { RAPIER, world } = this.context;
        const data = RAPIER.JointData.revolute(...this.data(first, second, at), axis);
        data.limitsEnabled = true;
        data.limits = [0, 2.3];
        const joint = world.createImpulseJoint(data, first.body, second.body, true) as RevoluteImpulseJoint;
        joint.setContactsEnabled(false);
    }
}

/** The rotation from the y axis to a direction. */
function fromUp(way: Vector, length: number): Rotation {
    const [x, y, z] = length > 0 ? [way.x / length, way.y / length, way.z / length] : [0, 1, 0];
    if (y < -0.9999) return { x: 1, y: 0, z: 0, w: 0 };
    const w = Math.sqrt((1 + y) / 2);
    return { x: z / (2 * w), y: 0, z: -x / (2 * w), w };
}

/** Adds a person with the pelvis at a place; returns the limbs, the pelvis first. */
export function addRagdoll(context: Context, at: Vector, rotation: Rotation): RigidBody[] {
    const doll = new Ragdoll(context, at, rotation);
    const pelvis = doll.limb(vec(-0.07, 0, 0), vec(0.07, 0, 0), 0.12);
    const chest = doll.limb(vec(-0.09, 0.34, 0), vec(0.09, 0.34, 0), 0.15);
    const head = doll.limb(vec(0, 0.62, 0), vec(0, 0.7, 0), 0.11);
    doll.socket(pelvis, chest, vec(0, 0.16, 0));
    doll.socket(chest, head, vec(0, 0.5, 0));
    for (const side of [-1, 1]) {
        const upper = doll.limb(vec(side * 0.29, 0.42, 0), vec(side * 0.48, 0.42, 0), 0.055);
        const lower = doll.limb(vec(side * 0.57, 0.42, 0), vec(side * 0.78, 0.42, 0), 0.045);
        doll.socket(chest, upper, vec(side * 0.24, 0.42, 0));
        doll.hinge(upper, lower, vec(side * 0.525, 0.42, 0), vec(0, -side, 0));
        const thigh = doll.limb(vec(side * 0.1, -0.19, 0), vec(side * 0.1, -0.44, 0), 0.075);
        const shin = doll.limb(vec(side * 0.1, -0.6, 0), vec(side * 0.1, -0.92, 0), 0.06);
        doll.socket(pelvis, thigh, vec(side * 0.1, -0.1, 0));
        doll.hinge(thigh, shin, vec(side * 0.1, -0.52, 0), X);
    }
    const clothes = context.random.pick(["blue", "teal", "red", "purple", "green"] as const);
    const trousers = context.random.pick(["dark", "grey", "white"] as const);
    doll.limbs.forEach((limb, index) => {
        const skin = index === 2 || index === 4 || index === 8;
        const leg = index === 0 || [5, 6, 9, 10].includes(index);
        context.paint(limb, skin ? "yellow" : leg ? trousers : clothes);
    });
    return doll.limbs;
}
