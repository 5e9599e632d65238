// The picture of one stage: instances that follow its colliders.

import { Color, Fog, Matrix4, Quaternion, Scene, Vector3, type Material } from "three";
import { POSE_SIZE } from "../core/dimension.ts";
import { enumNames, type BodyLike, type ColliderLike, type EngineModule, type Touching, type WorldLike } from "../core/engine.ts";
import type { Paint, Pen, Point } from "../core/scene.ts";
import type { Stage } from "../core/stage.ts";
import { Batch } from "./batch.ts";
import type { Sphere } from "./light.ts";
import { Lines } from "./lines.ts";
import { flatMaterial, solidMaterial, type Surface } from "./materials.ts";
import type { Part } from "./parts.ts";
import { parts2 } from "./parts2.ts";
import { parts3 } from "./parts3.ts";
import type { Theme } from "./theme.ts";

interface Instance {
    readonly part: Part;
    readonly batch: Batch;
    index: number;
}

interface Visual {
    readonly collider: ColliderLike;
    readonly body: BodyLike | null;
    readonly color: Color;
    readonly previous: Float32Array;
    readonly current: Float32Array;
    instances: Instance[];
    /** The shape's size at the time of the instances: scripts can change it. */
    size: number;
    surface: Surface | null;
    /** Radius of a sphere around the collider's origin that contains the instances. */
    radius: number;
    asleep: boolean;
    enabled: boolean;
    /** Whether the instances have the settled pose. */
    placed: boolean;
    /** Whether the pose did not change in the last two captures. */
    settled: boolean;
    seen: number;
}

/** Depth of the surfaces in 2D: ground behind bodies behind sensors. */
const DEPTHS: Record<Surface, number> = { ground: 0, solid: 1, glass: 2 };
const POINT_DEPTH = 5;
const OPEN: ReadonlySet<string> = new Set(["TriMesh", "HeightField", "Triangle", "HalfSpace"]);

export class StageView<R extends EngineModule, W extends WorldLike> {
    readonly scene = new Scene();
    debug = false;
    private readonly visuals = new Map<number, Visual>();
    private readonly batches = new Map<string, Batch>();
    private readonly materials = new Map<string, Material>();
    private readonly names: ReadonlyMap<number, string>;
    private readonly order = new Map<number, number>();
    private readonly pen: Lines;
    private readonly overlay: Lines;
    private readonly contacts: Lines;
    private generation: number;
    private captures = 0;
    private readonly matrix = new Matrix4();
    private readonly local = new Matrix4();
    private readonly position = new Vector3();
    private readonly rotation = new Quaternion();
    private readonly goal = new Quaternion();
    private readonly unit = new Vector3(1, 1, 1);
    private readonly scale = new Vector3();

    constructor(
        readonly stage: Stage<R, W>,
        private readonly theme: Theme,
    ) {
        this.names = enumNames(stage.engine.module.ShapeType);
        this.generation = stage.generation;
        this.pen = new Lines(this.scene, false);
        this.overlay = new Lines(this.scene, true);
        this.contacts = new Lines(this.scene, true, true);
        this.scene.background = theme.sky;
        if (!stage.dimension.flat) this.scene.fog = new Fog(theme.sky, 60, 160);
        this.capture();
    }

    private get flat(): boolean {
        return this.stage.dimension.flat;
    }

    /** Reads the poses of all moving colliders; the last two captures are the ends of the interpolation. */
    capture(): void {
        if (this.generation !== this.stage.generation) this.clear();
        this.generation = this.stage.generation;
        this.captures += 1;
        this.stage.world.forEachCollider((collider) => {
            const visual = this.visuals.get(collider.handle) ?? this.create(collider);
            visual.seen = this.captures;
            this.read(visual);
        });
        this.repaint();
        for (const [handle, visual] of this.visuals) {
            if (visual.seen === this.captures) continue;
            for (const instance of visual.instances) instance.batch.remove(instance.index);
            this.visuals.delete(handle);
        }
    }

    private read(visual: Visual): void {
        const { previous, current, body } = visual;
        const asleep = body !== null && body.isDynamic() && body.isSleeping();
        const still = asleep || body === null || body.isFixed();
        if (still && visual.settled && visual.asleep === asleep && this.captures % 16 !== 0) return;
        previous.set(current);
        this.stage.dimension.readPose(visual.collider, current);
        visual.settled = still && current.every((value, index) => value === previous[index]);
        visual.placed = false;
        visual.enabled = visual.collider.isEnabled();
        const size = sizeOf(visual.collider);
        if (size !== visual.size) this.rebuild(visual, size);
        if (asleep !== visual.asleep) {
            visual.asleep = asleep;
            this.colour(visual);
        }
    }

    private create(collider: ColliderLike): Visual {
        const body = collider.parent();
        const pose = new Float32Array(POSE_SIZE);
        this.stage.dimension.readPose(collider, pose);
        const visual: Visual = {
            collider,
            body,
            color: new Color(),
            previous: pose,
            current: pose.slice(),
            instances: [],
            size: NaN,
            surface: null,
            radius: 0,
            asleep: false,
            enabled: collider.isEnabled(),
            placed: false,
            settled: false,
            seen: 0,
        };
        this.visuals.set(collider.handle, visual);
        this.rebuild(visual, sizeOf(collider));
        return visual;
    }

    private rebuild(visual: Visual, size: number): void {
        for (const instance of visual.instances) instance.batch.remove(instance.index);
        visual.size = size;
        const { shape } = visual.collider;
        const parts = (this.flat ? parts2 : parts3)(this.names.get(shape.type) ?? "", shape, this.names);
        const surface = this.surfaceOf(visual.collider, visual.body);
        visual.surface = surface;
        visual.placed = false;
        visual.instances = surface === null ? [] : parts.map((part) => this.instance(part, surface));
        visual.radius = Math.max(0, ...visual.instances.map(({ part, batch }) => radiusOf(part, batch)));
        this.colour(visual);
    }

    private instance(part: Part, surface: Surface): Instance {
        const batch = this.batch(part, surface);
        const instance: Instance = { part, batch, index: -1 };
        instance.index = batch.add((index) => {
            instance.index = index;
        });
        return instance;
    }

    private batch(part: Part, surface: Surface): Batch {
        const key = `${surface} ${part.key}`;
        const known = this.batches.get(key);
        if (known) return known;
        const casts = !this.flat && surface !== "glass";
        const batch = new Batch(this.scene, part.build(), this.material(surface, part.box === true), casts, DEPTHS[surface]);
        this.batches.set(key, batch);
        return batch;
    }

    private material(surface: Surface, box: boolean): Material {
        const key = `${surface} ${box}`;
        const known = this.materials.get(key);
        if (known) return known;
        const material = this.flat ? flatMaterial(this.theme, surface) : solidMaterial(this.theme, surface, box);
        this.materials.set(key, material);
        return material;
    }

    private paintOf(collider: ColliderLike): Paint | undefined {
        return this.stage.paints.get(collider.handle);
    }

    private surfaceOf(collider: ColliderLike, body: BodyLike | null): Surface | null {
        const paint = this.paintOf(collider);
        if (paint === "hidden") return null;
        if (paint === "glass" || collider.isSensor()) return "glass";
        // Open meshes are visible from both sides, which the material of solids is not.
        if (paint === "ground" || OPEN.has(this.names.get(collider.shape.type) ?? "")) return "ground";
        return paint === undefined && (body === null || body.isFixed()) ? "ground" : "solid";
    }

    private toneOf(collider: ColliderLike, body: BodyLike | null): Color {
        const { paints, cycle } = this.theme;
        const paint = this.paintOf(collider);
        if (paint !== undefined) return paints[paint];
        if (collider.isSensor()) return paints.yellow;
        if (body === null || body.isFixed()) return paints.ground;
        if (body.isKinematic()) return paints.pink;
        const order = this.order.get(body.handle) ?? this.order.size;
        this.order.set(body.handle, order);
        return cycle[order % cycle.length] ?? paints.blue;
    }

    private colour(visual: Visual): void {
        const color = this.toneOf(visual.collider, visual.body);
        visual.color.copy(color);
        const shown = visual.asleep ? visual.color.clone().lerp(this.theme.asleep, 0.35) : visual.color;
        for (const { batch, index } of visual.instances) batch.setColor(index, shown);
    }

    /** Shows the colours that scripts changed. */
    private repaint(): void {
        for (const handle of this.stage.repainted) {
            const visual = this.visuals.get(handle);
            if (visual) this.rebuild(visual, visual.size);
        }
        this.stage.repainted.clear();
    }

    /** Moves all instances to the pose at a fraction of the last step. */
    update(fraction: number): void {
        for (const visual of this.visuals.values()) {
            if (visual.settled && visual.placed) continue;
            this.place(visual, fraction);
            visual.placed = true;
        }
        for (const batch of this.batches.values()) batch.touch();
        this.drawLines();
    }

    private place(visual: Visual, fraction: number): void {
        const [a, b] = [visual.previous, visual.current];
        const blend = (index: number): number => a[index]! + (b[index]! - a[index]!) * fraction;
        this.position.set(blend(0), blend(1), blend(2));
        this.rotation.set(a[3]!, a[4]!, a[5]!, a[6]!).slerp(this.goal.set(b[3]!, b[4]!, b[5]!, b[6]!), fraction);
        for (const { part, batch, index } of visual.instances) {
            this.matrix.compose(this.position, this.rotation, this.unit);
            if (part.offset) this.matrix.multiply(part.offset);
            this.local.makeScale(...part.scale);
            if (!visual.enabled) this.matrix.scale(this.scale.set(0, 0, 0));
            this.matrix.multiply(this.local);
            if (this.flat) this.matrix.elements[14] = DEPTHS[visual.surface ?? "solid"];
            batch.setMatrix(index, this.matrix);
        }
    }

    /**
     * Spheres around all that casts shadows in a view of this reach, or null where large meshes do. Larger floors and walls
     * are left out.
     */
    casters(reach: number): Sphere[] | null {
        const spheres: Sphere[] = [];
        for (const { surface, enabled, radius, current, collider } of this.visuals.values()) {
            if (surface === null || surface === "glass" || !enabled) continue;
            if (radius < reach) {
                spheres.push([current[0]!, current[1]!, current[2]!, radius]);
                continue;
            }
            const name = this.names.get(collider.shape.type) ?? "";
            if (name !== "HalfSpace" && OPEN.has(name)) return null;
        }
        return spheres;
    }

    private drawLines(): void {
        this.pen.clear();
        this.stage.run.draw?.(this.scenePen());
        const { spring } = this.stage;
        if (spring) this.pen.line(spaced(spring.anchor(), this.flat), spaced(spring.target(), this.flat), this.theme.paints.orange);
        this.pen.flush();
        this.overlay.clear();
        this.contacts.clear();
        if (this.debug) {
            this.drawDebug();
            this.drawContacts();
        }
        this.overlay.flush();
        this.contacts.flush();
    }

    private scenePen(): Pen {
        const tone = (paint: Paint): Color => this.theme.paints[paint];
        const line = (from: Point, to: Point, paint: Paint): void =>
            this.pen.line(spaced(from, this.flat), spaced(to, this.flat), tone(paint));
        return {
            line,
            cross: (at, size, paint) => {
                line({ ...at, x: at.x - size }, { ...at, x: at.x + size }, paint);
                line({ ...at, y: at.y - size }, { ...at, y: at.y + size }, paint);
                const z = at.z ?? 0;
                if (!this.flat) line({ ...at, z: z - size }, { ...at, z: z + size }, paint);
            },
        };
    }

    private drawDebug(): void {
        const { vertices, colors } = this.stage.world.debugRender();
        const width = this.flat ? 2 : 3;
        const count = vertices.length / width;
        for (let index = 0; index < count; index++) {
            const [at, tone] = [index * width, index * 4];
            const z = this.flat ? POINT_DEPTH : vertices[at + 2]!;
            const [r, g, b] = [colors[tone]! * this.theme.debug, colors[tone + 1]! * this.theme.debug, colors[tone + 2]! * this.theme.debug];
            this.overlay.point(vertices[at]!, vertices[at + 1]!, z, r, g, b);
        }
    }

    /** A dot at each contact of the last step. */
    private drawContacts(): void {
        const { world } = this.stage;
        const { r, g, b } = this.theme.paints.red;
        const touching = world as unknown as Touching;
        world.forEachCollider((collider) => {
            touching.contactPairsWith(collider, (other) => {
                // Each pair has two sides.
                if (other.handle < collider.handle) return;
                touching.contactPair(collider, other, (manifold) => {
                    for (let index = 0; index < manifold.numSolverContacts(); index++) {
                        const point = manifold.solverContactPoint(index);
                        if (point) this.contacts.point(...spaced(point, this.flat), r, g, b);
                    }
                });
            });
        });
    }

    private clear(): void {
        for (const batch of this.batches.values()) batch.dispose();
        this.batches.clear();
        this.visuals.clear();
        this.order.clear();
    }

    dispose(): void {
        this.clear();
        for (const material of this.materials.values()) material.dispose();
        this.pen.dispose();
        this.overlay.dispose();
        this.contacts.dispose();
    }
}

function spaced(point: Point, flat: boolean): [number, number, number] {
    return [point.x, point.y, flat ? POINT_DEPTH : (point.z ?? 0)];
}

/** The radius of a part about its collider's origin. */
function radiusOf({ scale, offset }: Part, { geometry }: Batch): number {
    if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
    const { center, radius } = geometry.boundingSphere!;
    const away = offset ? new Vector3().setFromMatrixPosition(offset).length() : 0;
    return away + (center.length() + radius) * Math.max(...scale);
}

/** A number that differs when setters of a collider changed its size. */
function sizeOf(collider: ColliderLike): number {
    const { type, radius = 0, halfHeight = 0, halfExtents } = collider.shape as Sized;
    const half = halfExtents ? halfExtents.x + 3.1 * halfExtents.y + 7.3 * (halfExtents.z ?? 0) : 0;
    return type + 0.37 * radius + 0.71 * halfHeight + half;
}

interface Sized {
    type: number;
    radius?: number;
    halfHeight?: number;
    halfExtents?: { x: number; y: number; z?: number };
}
