// Fast bodies, queries, events, ground and stress.

import { add, addFixed, addFloor, addWalls, ORIGIN, stone, vec } from "../kit.ts";
import type { Collider, Context, RigidBody, Scene } from "../rapier.ts";

const bullets: Scene = {
    id: "bullets",
    title: "Bullets",
    description: "Balls at 400 m/s hit a thin wall: green ones have continuous detection, red ones do not.",
    group: "Fast bodies",
    camera: { target: [0, 3.2, 0], height: 9 },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        addFixed(context, vec(2, 2.5), RAPIER.ColliderDesc.cuboid(0.03, 2.5));
        const shots: { body: RigidBody; careful: boolean }[] = [];
        const check = (): boolean => shots.filter(({ careful }) => careful).every(({ body }) => body.translation().x < 2.5);
        return {
            update: (_time, step) => {
                if (step % 8 !== 0 || shots.length >= 60) return;
                const careful = shots.length % 2 === 0;
                const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(-6, 1 + 0.35 * (shots.length % 9));
                const body = world.createRigidBody(description.setLinvel(400, 0).setCcdEnabled(careful));
                world.createCollider(RAPIER.ColliderDesc.ball(0.12).setDensity(5), body);
                paint(body, careful ? "green" : "red");
                shots.push({ body, careful });
            },
            claims: [{ text: "No green ball passes the wall", after: 300, check }],
        };
    },
};

const rattle: Scene = {
    id: "rattle",
    title: "Rattle",
    description: "Fast elastic balls stay inside a box of thin lines.",
    group: "Fast bodies",
    camera: { target: [0, 0, 0], height: 8 },
    gravity: 0,
    setup(context) {
        const { RAPIER, world, random } = context;
        const outline = new Float32Array([-4, -3, 4, -3, 4, 3, -4, 3, -4, -3]);
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.polyline(outline).setRestitution(1));
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.ball(0.8).setRestitution(1));
        const balls = Array.from({ length: 40 }, () => {
            const side = random.below(2) === 0 ? -1 : 1;
            const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(side * random.between(1.2, 3.6), random.between(-2.6, 2.6));
            const body = world.createRigidBody(description.setLinvel(random.between(-60, 60), random.between(-60, 60)).setCcdEnabled(true));
            world.createCollider(RAPIER.ColliderDesc.ball(0.14).setRestitution(1).setFriction(0), body);
            return body;
        });
        const check = (): boolean => balls.every((ball) => Math.abs(ball.translation().x) < 4.1 && Math.abs(ball.translation().y) < 3.1);
        return { claims: [{ text: "No ball leaves the box", after: 300, check }] };
    },
};

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
    description: "A disc that only queries know colours everything inside of it.",
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

const sensors: Scene = {
    id: "sensors",
    title: "Sensors",
    description: "Balls change their colour while they are inside of a sensor.",
    group: "Events and sensors",
    camera: { target: [0, 3.4, 0], height: 10 },
    poster: 260,
    setup(context) {
        addFloor(context);
        addWalls(context, 7, 4);
        const { RAPIER, world, paint, random } = context;
        const events = new RAPIER.EventQueue(true);
        for (let peg = 0; peg < 11; peg++) addFixed(context, vec(1.2 * (peg - 5), 1 + 0.6 * (peg % 2)), RAPIER.ColliderDesc.ball(0.2));
        const zones = new Set([-3.5, 0, 3.5].map((x) => {
            const shape = RAPIER.ColliderDesc.cuboid(1.1, 0.8).setSensor(true).setTranslation(x, 3.6);
            return world.createCollider(shape.setActiveEvents(RAPIER.ActiveEvents.COLLISION_EVENTS)).handle;
        }));
        let entries = 0;
        return {
            events,
            update: (_time, step) => {
                if (step % 12 === 0 && step < 1200) paint(add(context, vec(random.between(-6, 6), 8), RAPIER.ColliderDesc.ball(0.25)), "blue");
            },
            after: () =>
                events.drainCollisionEvents((first, second, started) => {
                    const collider = world.getCollider(zones.has(first) ? second : first);
                    if (collider) paint(collider, started ? "orange" : "blue");
                    if (started) entries += 1;
                }),
            caption: () => `${entries} entries`,
            claims: [{ text: "Balls have entered sensors", after: 240, check: () => entries > 3 }],
        };
    },
};

const forces: Scene = {
    id: "contact-forces",
    title: "Contact forces",
    description: "Boxes light up by the force that acts on them at an impact.",
    group: "Events and sensors",
    camera: { target: [0, 3.4, 0], height: 9.5 },
    poster: 90,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const events = new RAPIER.EventQueue(true);
        for (let index = 0; index < 30; index++) {
            const shape = RAPIER.ColliderDesc.cuboid(0.4, 0.4).setActiveEvents(RAPIER.ActiveEvents.CONTACT_FORCE_EVENTS);
            paint(add(context, vec(0.82 * ((index % 6) - 2.5), 0.4 + 0.8 * Math.floor(index / 6)), shape.setContactForceEventThreshold(20)), "blue");
        }
        const heavy = add(context, vec(0.3, 9), RAPIER.ColliderDesc.ball(0.8).setDensity(6));
        paint(heavy, "white");
        let most = 0;
        return {
            events,
            after: () =>
                events.drainContactForceEvents((event) => {
                    const force = event.maxForceMagnitude();
                    most = Math.max(most, force);
                    for (const handle of [event.collider1(), event.collider2()]) {
                        const collider = world.getCollider(handle);
                        const body = collider?.parent();
                        if (!collider || !body?.isDynamic() || body.handle === heavy.handle) continue;
                        paint(collider, force > 800 ? "red" : force > 200 ? "orange" : force > 60 ? "yellow" : "teal");
                    }
                }),
            caption: () => `largest force ${most.toFixed(0)} N`,
            claims: [{ text: "The impact is reported", after: 150, check: () => most > 300 }],
        };
    },
};

const hooks: Scene = {
    id: "one-way",
    title: "One-way floors",
    description: "A hook lets balls pass the floors upwards, and holds them from falling back.",
    group: "Events and sensors",
    camera: { target: [0, 4, 0], height: 10.5 },
    poster: 200,
    setup(context) {
        addFloor(context);
        addWalls(context, 5, 8);
        const { RAPIER, paint, random } = context;
        const floors = new Map([2, 4, 6].map((y) => {
            const shape = RAPIER.ColliderDesc.cuboid(5, 0.08).setActiveHooks(RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS);
            const floor = addFixed(context, vec(0, y), shape);
            paint(floor, "teal");
            return [floor.collider(0).handle, y] as const;
        }));
        const balls = Array.from({ length: 30 }, () => {
            const ball = add(context, vec(random.between(-4.5, 4.5), 0.4), RAPIER.ColliderDesc.ball(0.25));
            ball.setLinvel(vec(0, random.between(6, 13)), true);
            return ball;
        });
        // Bodies cannot be read during a step: the hook decides by what was read before it.
        const above = new Map<number, Set<number>>();
        const reached = (): number => balls.filter((ball) => ball.translation().y > 1.9).length;
        return {
            hooks: {
                filterContactPair: (first, second, body1, body2) => {
                    const floor = floors.has(first) ? first : second;
                    const body = floors.has(first) ? body2 : body1;
                    return above.get(floor)?.has(body) ? RAPIER.SolverFlags.COMPUTE_IMPULSE : null;
                },
                filterIntersectionPair: () => true,
            },
            // The published package calls hooks in steps with an event queue alone.
            events: new RAPIER.EventQueue(true),
            update: () => {
                for (const [floor, y] of floors) {
                    const known = above.get(floor) ?? new Set<number>();
                    for (const ball of balls) {
                        const at = ball.translation();
                        if (at.y > y + 0.3 && ball.linvel().y < 1) known.add(ball.handle);
                        if (at.y < y - 0.2) known.delete(ball.handle);
                    }
                    above.set(floor, known);
                }
            },
            caption: () => `${reached()} balls upstairs`,
            claims: [{ text: "Balls stay upstairs", after: 300, check: () => reached() > 8 }],
        };
    },
};

/** Bodies of several shapes that fall from a height. */
function addRain(context: Context, count: number, spread: number, height: number): RigidBody[] {
    const { RAPIER, random } = context;
    return Array.from({ length: count }, (_, index) => {
        const shapes = [RAPIER.ColliderDesc.ball(0.25), RAPIER.ColliderDesc.cuboid(0.25, 0.25), RAPIER.ColliderDesc.capsule(0.2, 0.15)];
        return add(context, vec(random.between(-spread, spread), height + 0.15 * index), random.pick(shapes));
    });
}

function onGround(bodies: readonly RigidBody[], after: number) {
    const check = (): boolean | string => {
        const lost = bodies.filter((body) => body.translation().y < -4).length;
        return lost === 0 || `${lost} bodies fell through`;
    };
    return { text: "No body falls through the ground", after, check };
}

const landscape: Scene = {
    id: "heightfield",
    title: "Landscape",
    description: "Shapes roll into the valleys of a height field.",
    group: "Meshes and landscapes",
    camera: { target: [0, 1.6, 0], height: 10 },
    poster: 240,
    setup(context) {
        const heights = Float32Array.from({ length: 101 }, (_, index) => {
            const x = 0.24 * (index - 50);
            return 0.9 * Math.cos(1.1 * x) + 0.25 * Math.sin(3.1 * x) + 0.05 * x * x;
        });
        addFixed(context, ORIGIN, context.RAPIER.ColliderDesc.heightfield(heights, vec(24, 1)));
        return { claims: [onGround(addRain(context, 120, 6, 4), 300)] };
    },
};

const polyline: Scene = {
    id: "polyline",
    title: "Polyline",
    description: "Balls run down slides of line segments.",
    group: "Meshes and landscapes",
    camera: { target: [0, 4, 0], height: 11 },
    poster: 240,
    setup(context) {
        addFloor(context);
        addWalls(context, 8, 2);
        const { RAPIER, world, paint } = context;
        for (const [side, y] of [[1, 6], [-1, 4], [1, 2]] as const) {
            const points: number[] = [];
            for (let index = 0; index <= 40; index++) {
                const u = index / 40;
                const curl = u > 0.88 ? 3.6 * (u - 0.88) : 0;
                points.push(side * (6 - 10.5 * u), y + 1.9 * (1 - u) ** 1.4 + curl + (index === 0 ? 0.4 : 0));
            }
            addFixed(context, ORIGIN, RAPIER.ColliderDesc.polyline(new Float32Array(points)).setFriction(0.2));
        }
        const balls: RigidBody[] = [];
        return {
            update: (_time, step) => {
                if (step % 14 !== 0 || balls.length >= 70) return;
                const ball = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(5.4, 8.8).setCcdEnabled(true));
                world.createCollider(RAPIER.ColliderDesc.ball(0.22).setRestitution(0.2), ball);
                paint(ball, (["blue", "orange", "green", "red", "yellow"] as const)[balls.length % 5] ?? "blue");
                balls.push(ball);
            },
            claims: [onGround(balls, 400)],
        };
    },
};

const voxels: Scene = {
    id: "voxels",
    title: "Voxels",
    description: "A cave of squares is one collider, and balls roll over it without bumps at the seams.",
    group: "Meshes and landscapes",
    camera: { target: [0, 3.2, 0], height: 10 },
    poster: 240,
    setup(context) {
        const { RAPIER } = context;
        const cells: number[] = [];
        for (let x = -18; x < 18; x++) {
            const top = Math.round(3 + 2.2 * Math.sin(0.35 * x) + Math.max(0, Math.abs(x) - 12));
            for (let y = -4; y <= top; y++) {
                const cave = Math.hypot(x - 3, 1.4 * (y - 1)) < 2.6;
                if (!cave) cells.push(x, y);
            }
        }
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.voxels(new Int32Array(cells), vec(0.5, 0.5)));
        return { claims: [onGround(addRain(context, 90, 5, 6), 300)] };
    },
};

const mesh: Scene = {
    id: "gears",
    title: "Gears of triangles",
    description: "Two meshes with teeth turn into each other and grind balls.",
    group: "Meshes and landscapes",
    camera: { target: [0, 3.4, 0], height: 10 },
    poster: 150,
    setup(context) {
        addFloor(context);
        addWalls(context, 5.2, 6);
        const { RAPIER, world, paint } = context;
        const teeth = 12;
        const vertices: number[] = [0, 0];
        const indices: number[] = [];
        for (let corner = 0; corner < 4 * teeth; corner++) {
            const angle = (2 * Math.PI * corner) / (4 * teeth);
            const radius = corner % 4 < 2 ? 1.95 : 1.5;
            vertices.push(radius * Math.cos(angle), radius * Math.sin(angle));
            indices.push(0, corner + 1, ((corner + 1) % (4 * teeth)) + 1);
        }
        for (const side of [-1, 1]) {
            const gear = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setTranslation(1.9 * side, 2.6).setAngvel(-0.7 * side));
            gear.setRotation(side > 0 ? Math.PI / teeth + 0.12 : 0.12, true);
            world.createCollider(RAPIER.ColliderDesc.trimesh(new Float32Array(vertices), new Uint32Array(indices)), gear);
            paint(gear, side < 0 ? "teal" : "purple");
        }
        addRain(context, 90, 4.5, 6);
    },
};

const rain: Scene = {
    id: "thousand-boxes",
    title: "A thousand boxes",
    description: "A block of a thousand boxes falls and spreads.",
    group: "Stress tests",
    camera: { target: [0, 10, 0], height: 30 },
    poster: 200,
    parameters: { count: { label: "Boxes", value: 1000, min: 100, max: 8000, step: 100 } },
    setup(context) {
        addFloor(context, 150);
        for (let index = 0; index < context.parameter<number>("count"); index++) {
            const [x, y] = [index % 25, Math.floor(index / 25)];
            add(context, vec(1.15 * (x - 12) + 0.2 * (y % 3), 1 + 1.1 * y), context.RAPIER.ColliderDesc.cuboid(0.45, 0.45));
        }
    },
};

const grid: Scene = {
    id: "joint-grid",
    title: "Grid of joints",
    description: "Six hundred and twenty-five balls hang in a sheet of 1,200 joints.",
    group: "Stress tests",
    camera: { target: [0, 6, 0], height: 16 },
    poster: 120,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const side = 25;
        const bodies: RigidBody[][] = [];
        for (let row = 0; row < side; row++) {
            bodies.push([]);
            for (let column = 0; column < side; column++) {
                const fixed = row === 0 && column % 8 === 0;
                const description = fixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic();
                const body = world.createRigidBody(description.setTranslation(0.45 * (column - 12), 12.5 - 0.45 * row));
                world.createCollider(RAPIER.ColliderDesc.ball(0.15), body);
                paint(body, fixed ? "white" : (row + column) % 2 === 0 ? "teal" : "blue");
                bodies[row]?.push(body);
                const [above, left] = [bodies[row - 1]?.[column], bodies[row]?.[column - 1]];
                if (above) world.createImpulseJoint(RAPIER.JointData.revolute(ORIGIN, vec(0, 0.45)), above, body, true);
                if (left) world.createImpulseJoint(RAPIER.JointData.revolute(vec(0.45, 0), ORIGIN), left, body, true);
            }
        }
        const ball = add(context, vec(-11, 7), RAPIER.ColliderDesc.ball(1).setDensity(3));
        ball.setLinvel(vec(11, 4), true);
        paint(ball, "orange");
    },
};

const pyramids: Scene = {
    id: "many-pyramids",
    title: "Many pyramids",
    description: "Twenty pyramids of 45 boxes stand, and fall asleep.",
    group: "Stress tests",
    camera: { target: [0, 11, 0], height: 30 },
    poster: 60,
    setup(context) {
        addFloor(context);
        const tops: [RigidBody, number][] = [];
        for (let pyramid = 0; pyramid < 20; pyramid++) {
            const [x, y] = [8.6 * ((pyramid % 5) - 2), 6 * Math.floor(pyramid / 5)];
            if (y > 0) addFixed(context, vec(x, y - 0.1), context.RAPIER.ColliderDesc.cuboid(4, 0.1));
            for (let row = 0; row < 9; row++) {
                for (let column = 0; column < 9 - row; column++) {
                    const at = vec(x + 0.62 * (column - (8 - row) / 2), y + 0.3 + 0.6 * row);
                    const box = add(context, at, context.RAPIER.ColliderDesc.cuboid(0.3, 0.3));
                    if (row === 8) tops.push([box, at.y]);
                }
            }
        }
        const check = (): boolean => tops.every(([box, y]) => Math.abs(box.translation().y - y) < 0.3);
        return { claims: [{ text: "All pyramids stand after 3 s", after: 180, check }] };
    },
};

export const FAST: readonly Scene[] = [bullets, rattle];
export const QUERIES: readonly Scene[] = [radar, sweep, overlap];
export const EVENTS: readonly Scene[] = [sensors, forces, hooks];
export const GROUND: readonly Scene[] = [landscape, polyline, voxels, mesh];
export const STRESS: readonly Scene[] = [rain, grid, pyramids];
