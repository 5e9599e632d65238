// Dragging bodies with a spring, and throwing balls.

import type { Vec, EngineModule, WorldLike } from "../core/engine.ts";
import type { Stage } from "../core/stage.ts";
import type { Picture, Place } from "../view/picture.ts";

/** Speed of a thrown ball in visible sizes per second, and its radius in visible sizes. */
const THROW_SPEED = { solid: 1.6, flat: 1.5 };
const THROW_RADIUS = { solid: 0.016, flat: 0.02 };

export class Pointer<R extends EngineModule, W extends WorldLike> {
    /** The last place of the pointer, for throws by key. */
    private place: Place = { index: 0, x: 0, y: 0 };
    private held: { stage: Stage<R, W>; point: Vec } | null = null;

    constructor(
        private readonly picture: Picture<R, W>,
        private readonly stages: () => readonly Stage<R, W>[],
    ) {
        const { canvas } = picture;
        // The orbit of the camera listens to the same events: it is switched off while a body is held.
        canvas.addEventListener("pointerdown", (event) => this.down(event), { capture: true });
        canvas.addEventListener("pointermove", (event) => this.move(event));
        for (const name of ["pointerup", "pointercancel"] as const) {
            canvas.addEventListener(name, () => this.up());
        }
        canvas.addEventListener("dblclick", (event) => {
            this.track(event);
            this.throwBall();
        });
    }

    private track(event: MouseEvent): boolean {
        const place = this.picture.locate(event.clientX, event.clientY);
        if (place === null) return false;
        this.place = place;
        return true;
    }

    private hit(place: Place): { stage: Stage<R, W>; point: Vec; grab: () => void } | null {
        const stage = this.stages()[place.index];
        if (!stage) return null;
        const ray = this.picture.rig.ray(place.x, place.y);
        const visible = (handle: number): boolean => !["glass", "hidden"].includes(stage.paints.get(handle) ?? "");
        const { module } = stage.engine;
        const hit = stage.dimension.pick(module, stage.world, ray.origin, ray.direction, visible);
        if (hit === null) return null;
        const grab = (): void => {
            stage.release();
            stage.spring = stage.dimension.createSpring(module, stage.world, hit);
        };
        return { stage, point: { ...hit.point }, grab };
    }

    private down(event: PointerEvent): void {
        if (event.button !== 0 || !event.isPrimary || !this.track(event)) return;
        const found = this.hit(this.place);
        if (found === null) return;
        found.grab();
        this.held = { stage: found.stage, point: found.point };
        this.picture.rig.controls.enabled = false;
        this.picture.canvas.setPointerCapture(event.pointerId);
        this.picture.canvas.style.cursor = "grabbing";
    }

    private move(event: PointerEvent): void {
        if (!event.isPrimary || !this.track(event)) return;
        if (this.held === null) {
            if (event.buttons === 0) this.picture.canvas.style.cursor = this.hit(this.place) ? "grab" : "";
            return;
        }
        const { rig } = this.picture;
        const target = rig.atDepthOf(rig.ray(this.place.x, this.place.y), this.held.point);
        this.held.point = target;
        this.held.stage.spring?.move(target);
    }

    private up(): void {
        if (this.held === null) return;
        this.held.stage.release();
        this.held = null;
        this.picture.rig.controls.enabled = true;
        this.picture.canvas.style.cursor = "";
    }

    /** Releases the body at the pointer, before its world ends. */
    forget(): void {
        this.held = null;
        this.picture.rig.controls.enabled = true;
    }

    /** Throws a ball at the pointer, the same in each engine. */
    throwBall(): void {
        const { rig, flat } = this.picture;
        const { origin, direction } = rig.ray(this.place.x, this.place.y);
        const reach = rig.reach;
        const kind = flat ? "flat" : "solid";
        const speed = THROW_SPEED[kind] * reach;
        // In 2D the ball comes from the upper left; in 3D from the eye.
        const way = flat ? { x: 0.8, y: -0.6, z: 0 } : { ...direction };
        const from = flat
            ? { x: origin.x - 0.35 * reach, y: origin.y + 0.26 * reach, z: 0 }
            : { x: origin.x + way.x * 0.1 * reach, y: origin.y + way.y * 0.1 * reach, z: origin.z + way.z * 0.1 * reach };
        const velocity = { x: way.x * speed, y: way.y * speed, z: way.z * speed };
        for (const stage of this.stages()) {
            const ball = stage.dimension.throwBall(stage.engine.module, stage.world, from, velocity, THROW_RADIUS[kind] * reach);
            stage.paintCollider(ball.collider(0).handle, "white");
        }
    }
}
