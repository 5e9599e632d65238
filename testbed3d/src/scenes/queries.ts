// Queries: rays, shapes, points.

import { add, addFixed, addFloor, addPit, ORIGIN, turn, UPRIGHT, vec, X, Y } from "../kit.ts";
import type { Collider, Context, Scene, Vector } from "../rapier.ts";

const group = "Queries";

/** Shapes of many kinds, on the floor in a ring. */
function addMixture(context: Context, count: number, spread: number): void {
    const { RAPIER, random } = context;
    for (let index = 0; index < count; index++) {
        const at = vec(random.between(-spread, spread), 0.6 + 0.4 * (index % 5), random.between(-spread, spread));
        const shapes = [
            RAPIER.ColliderDesc.ball(0.4),
            RAPIER.ColliderDesc.cuboid(0.4, 0.3, 0.5),
            RAPIER.ColliderDesc.capsule(0.3, 0.25),
            RAPIER.ColliderDesc.cylinder(0.35, 0.35),
            RAPIER.ColliderDesc.cone(0.45, 0.4),
        ];
        add(context, at, random.pick(shapes), turn(X, random.between(0, 3)));
    }
}

const radar: Scene = {
    id: "radar",
    title: "Radar",
    description: "A turning mast casts 240 rays, which find the nearest colliders, and their normals.",
    group,
    camera: { eye: [9, 9, 12], target: [0, 0.6, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        addPit(context, 7, 1.2);
        addMixture(context, 50, 6);
        const mast = addFixed(context, vec(0, 0.7, 0), RAPIER.ColliderDesc.cylinder(0.7, 0.2));
        const ray = new RAPIER.Ray(vec(0, 0.5, 0), X);
        let turned = 0;
        return {
            update: (time) => {
                turned = 0.5 * time;
            },
            draw: (pen) => {
                for (let index = 0; index < 240; index++) {
                    const angle = turned + (2 * Math.PI * index) / 240;
                    ray.dir = vec(Math.cos(angle), 0, Math.sin(angle));
                    const hit = world.castRayAndGetNormal(ray, 12, true, undefined, undefined, undefined, mast);
                    if (!hit) continue;
                    const at = ray.pointAt(hit.timeOfImpact);
                    pen.line(ray.origin, at, index === 0 ? "red" : "green");
                    const end = vec(at.x + 0.4 * hit.normal.x, at.y + 0.4 * hit.normal.y, at.z + 0.4 * hit.normal.z);
                    pen.line(at, end, "yellow");
                }
            },
        };
    },
};

const sweep: Scene = {
    id: "shape-cast",
    title: "Shape casts",
    description: "A row of boxes is swept downwards, and stops at the first contact.",
    group,
    camera: { eye: [7, 7, 12], target: [0, 1.5, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        addPit(context, 5, 1.6);
        addMixture(context, 70, 4.5);
        const shape = new RAPIER.Cuboid(0.3, 0.15, 0.3);
        const down = vec(0, -1, 0);
        let shift = 0;
        const outline = (at: Vector): Vector[] =>
            [-1, 1].flatMap((x) => [-1, 1].flatMap((z) => [vec(at.x + 0.3 * x, at.y - 0.15, at.z + 0.3 * z)]));
        return {
            update: (time) => {
                shift = 3.5 * Math.sin(0.6 * time);
            },
            draw: (pen) => {
                for (let index = 0; index < 11; index++) {
                    const from = vec(0.85 * (index - 5), 5, shift);
                    const hit = world.castShape(from, UPRIGHT, down, shape, 0, 10, true);
                    const at = vec(from.x, from.y - (hit?.time_of_impact ?? 10), from.z);
                    pen.line(from, at, "blue");
                    const [a, b, c, d] = outline(at);
                    if (!a || !b || !c || !d) continue;
                    for (const [one, other] of [[a, b], [b, d], [d, c], [c, a]] as const) {
                        pen.line(one, other, "orange");
                        pen.line({ ...one, y: one.y + 0.3 }, { ...other, y: other.y + 0.3 }, "orange");
                        pen.line(one, { ...one, y: one.y + 0.3 }, "orange");
                    }
                    if (hit) pen.cross(hit.witness1, 0.12, "yellow");
                }
            },
        };
    },
};

const nearest: Scene = {
    id: "projections",
    title: "Nearest points",
    description: "A cloud of points finds the nearest point of any collider.",
    group,
    camera: { eye: [6, 6, 9], target: [0, 1.2, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const shapes = [
            RAPIER.ColliderDesc.ball(0.7),
            RAPIER.ColliderDesc.cuboid(0.6, 0.6, 0.6),
            RAPIER.ColliderDesc.cylinder(0.6, 0.5),
            RAPIER.ColliderDesc.capsule(0.5, 0.4),
            RAPIER.ColliderDesc.cone(0.7, 0.6),
        ];
        shapes.forEach((shape, index) => {
            const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setTranslation(2 * (index - 2), 1.5, 0));
            body.setAngvel(vec(0.4, 0.5, 0.3 * index), true);
            world.createCollider(shape, body);
            paint(body, (["blue", "teal", "orange", "purple", "red"] as const)[index] ?? "blue");
        });
        let now = 0;
        return {
            update: (time) => {
                now = time;
            },
            draw: (pen) => {
                for (let index = 0; index < 80; index++) {
                    const angle = (2 * Math.PI * index) / 80 + 0.3 * now;
                    const point = vec(5.2 * Math.cos(angle), 1.7 + 1.2 * Math.sin(3 * angle + now), 1.9 * Math.sin(angle));
                    const found = world.projectPoint(point, true);
                    if (!found) continue;
                    pen.cross(point, 0.05, "yellow");
                    pen.line(point, found.point, "white");
                }
            },
        };
    },
};

const overlap: Scene = {
    id: "overlap",
    title: "Overlap",
    description: "A ball that only queries detect colours everything inside of it.",
    group,
    camera: { eye: [7, 8, 11], target: [0, 0.8, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        addPit(context, 5, 1.5);
        addMixture(context, 90, 4.5);
        const shape = new RAPIER.Ball(1.6);
        let inside: Collider[] = [];
        let centre = ORIGIN;
        return {
            after: (time) => {
                centre = vec(3 * Math.cos(0.7 * time), 0.8, 3 * Math.sin(0.9 * time));
                for (const collider of inside) paint(collider, "blue");
                inside = [];
                world.intersectionsWithShape(centre, UPRIGHT, shape, (collider) => {
                    inside.push(collider);
                    return true;
                }, RAPIER.QueryFilterFlags.ONLY_DYNAMIC);
                for (const collider of inside) paint(collider, "orange");
            },
            draw: (pen) => {
                for (const axis of [X, Y]) {
                    for (let index = 0; index < 40; index++) {
                        const point = (step: number): Vector => {
                            const angle = (2 * Math.PI * step) / 40;
                            const [c, s] = [1.6 * Math.cos(angle), 1.6 * Math.sin(angle)];
                            return axis === X ? vec(centre.x, centre.y + c, centre.z + s) : vec(centre.x + c, centre.y, centre.z + s);
                        };
                        pen.line(point(index), point(index + 1), "yellow");
                    }
                }
            },
            caption: () => `${inside.length} inside`,
        };
    },
};

export const QUERIES: readonly Scene[] = [radar, sweep, nearest, overlap];
