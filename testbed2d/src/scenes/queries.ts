// Queries: rays, shapes.

import { add, addFloor, addWalls, ORIGIN, stone, vec } from "../kit.ts";
import type { Collider, Context, Scene } from "../rapier.ts";

/** Shapes of three kinds between walls. */
function addMixture(context: Context, count: number): void {
    addFloor(context);
    addWalls(context, 7.5, 5);
    const { RAPIER, random } = context;
    for (let index = 0; index < count; index++) {
        const hull = RAPIER.ColliderDesc.convexHull(stone(context, 0.5)) ?? RAPIER.ColliderDesc.ball(0.4);
        const shape = random.pick([RAPIER.ColliderDesc.ball(0.35), RAPIER.ColliderDesc.cuboid(0.4, 0.3), hull]);
        add(context, vec(random.between(-7, 7), 1 + 0.2 * index), shape);
    }
}

const radar: Scene = {
    id: "radar",
    title: "Radar",
    description: "A turning lamp casts 200 rays, which find the nearest colliders, and their normals.",
    group: "Queries",
    camera: { target: [0, 4.2, 0], height: 11 },
    poster: 140,
    setup(context) {
        addMixture(context, 60);
        const { RAPIER, world } = context;
        const ray = new RAPIER.Ray(vec(0, 7), vec(1, 0));
        let now = 0;
        return {
            update: (time) => {
                now = time;
            },
            draw: (pen) => {
                ray.origin = vec(4.5 * Math.sin(0.5 * now), 7);
                for (let index = 0; index < 200; index++) {
                    const angle = (2 * Math.PI * index) / 200;
                    ray.dir = vec(Math.cos(angle), Math.sin(angle));
                    const hit = world.castRayAndGetNormal(ray, 20, true);
                    if (!hit) continue;
                    const at = ray.pointAt(hit.timeOfImpact);
                    pen.line(ray.origin, at, "yellow");
                    pen.line(at, vec(at.x + 0.3 * hit.normal.x, at.y + 0.3 * hit.normal.y), "red");
                }
            },
        };
    },
};

const sweep: Scene = {
    id: "shape-cast",
    title: "Shape casts",
    description: "A row of boxes is swept downwards, and stops at the first contact.",
    group: "Queries",
    camera: { target: [0, 4, 0], height: 11 },
    poster: 140,
    setup(context) {
        addMixture(context, 60);
        const { RAPIER, world } = context;
        const shape = new RAPIER.Cuboid(0.25, 0.15);
        let shift = 0;
        return {
            update: (time) => {
                shift = 0.5 * Math.sin(time);
            },
            draw: (pen) => {
                for (let index = 0; index < 16; index++) {
                    const from = vec(0.9 * (index - 7.5) + shift, 8);
                    const hit = world.castShape(from, 0, vec(0, -1), shape, 0, 10, true);
                    const y = from.y - (hit?.time_of_impact ?? 10);
                    pen.line(from, vec(from.x, y), "teal");
                    const corners = [vec(from.x - 0.25, y - 0.15), vec(from.x + 0.25, y - 0.15), vec(from.x + 0.25, y + 0.15), vec(from.x - 0.25, y + 0.15)];
                    corners.forEach((corner, side) => pen.line(corner, corners[(side + 1) % 4]!, "orange"));
                    if (hit) pen.cross(hit.witness1, 0.1, "red");
                }
            },
        };
    },
};

const overlap: Scene = {
    id: "overlap",
    title: "Overlap",
    description: "A disc that only queries detect colours everything inside of it.",
    group: "Queries",
    camera: { target: [0, 3, 0], height: 9 },
    poster: 160,
    setup(context) {
        addMixture(context, 90);
        const { RAPIER, world, paint } = context;
        const shape = new RAPIER.Ball(1.5);
        let inside: Collider[] = [];
        let centre = ORIGIN;
        return {
            after: (time) => {
                centre = vec(5 * Math.sin(0.6 * time), 2 + Math.sin(1.1 * time));
                for (const collider of inside) paint(collider, "blue");
                inside = [];
                world.intersectionsWithShape(centre, 0, shape, (collider) => {
                    inside.push(collider);
                    return true;
                }, RAPIER.QueryFilterFlags.ONLY_DYNAMIC);
                for (const collider of inside) paint(collider, "orange");
            },
            draw: (pen) => {
                for (let index = 0; index < 48; index++) {
                    const [a, b] = [index, index + 1].map((step) => (2 * Math.PI * step) / 48);
                    pen.line(vec(centre.x + 1.5 * Math.cos(a!), centre.y + 1.5 * Math.sin(a!)), vec(centre.x + 1.5 * Math.cos(b!), centre.y + 1.5 * Math.sin(b!)), "yellow");
                }
            },
            caption: () => `${inside.length} inside`,
        };
    },
};

export const QUERIES: readonly Scene[] = [radar, sweep, overlap];
