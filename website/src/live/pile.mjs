// A fixed pile of boxes and balls, and the hashes of its world. The build runs it in Node.js, the page in the visitor's browser.

const STEPS = 300;
/** Steps between two hashes. */
const STRIDE = 60;
const SIDE = 8;
const FLOORS = 8;

/** Hashes of the world as hexadecimal numbers, every `STRIDE` steps. `RAPIER` is the initialised package. */
export function hashes(RAPIER) {
    const world = new RAPIER.World({ x: 0, y: -9.81, z: 0 });
    world.createCollider(RAPIER.ColliderDesc.cuboid(20, 1, 20).setTranslation(0, -1, 0));
    for (let index = 0; index < SIDE * SIDE * FLOORS; index += 1) {
        const [column, row, floor] = [index % SIDE, Math.floor(index / SIDE) % SIDE, Math.floor(index / (SIDE * SIDE))];
        const body = RAPIER.RigidBodyDesc.dynamic().setTranslation(
            column * 1.05 + floor * 0.3,
            1 + floor * 1.2,
            row * 1.05 - floor * 0.2,
        );
        const shape = index % 3 === 0 ? RAPIER.ColliderDesc.ball(0.5) : RAPIER.ColliderDesc.cuboid(0.5, 0.4, 0.5);
        world.createCollider(shape, world.createRigidBody(body));
    }
    const found = [];
    for (let step = 1; step <= STEPS; step += 1) {
        world.step();
        if (step % STRIDE === 0) found.push(world.hash().toString(16).padStart(16, "0"));
    }
    world.free();
    return found;
}

/** Number of bodies, and the steps after which hashes are taken. */
export const BODIES = SIDE * SIDE * FLOORS;
export const TAKEN = Array.from({ length: STEPS / STRIDE }, (_, index) => (index + 1) * STRIDE);
