// The canvas: one viewport for each engine, with a common camera.

import {
    Color,
    Fog,
    LineBasicMaterial,
    LineSegments,
    BufferGeometry,
    Float32BufferAttribute,
    NoToneMapping,
    PCFShadowMap,
    Vector3,
    WebGLRenderer,
} from "three";
import { POSE_SIZE } from "../core/dimension.ts";
import type { EngineModule, WorldLike } from "../core/engine.ts";
import type { Camera } from "../core/scene.ts";
import type { Stage } from "../core/stage.ts";
import { Sky, Sun } from "./light.ts";
import { Rig } from "./rig.ts";
import { StageView } from "./stage-view.ts";
import type { Theme } from "./theme.ts";

/** A viewport in pixels of the page, from the canvas's left top corner. */
export interface Viewport {
    left: number;
    top: number;
    width: number;
    height: number;
}

/** A place in a viewport, in the range -1 to 1. */
export interface Place {
    index: number;
    x: number;
    y: number;
}

interface Shown<R extends EngineModule, W extends WorldLike> {
    view: StageView<R, W>;
    sun: Sun | null;
}

/** Fraction of bodies at each side that photographs may leave out. */
const OUTLIERS = 0.03;
/** Smallest gap before such a body, as a fraction of the extent of all other bodies. */
const OUTLIER_GAP = 0.2;
/** Half of the smallest part that photographs show, and its margin around the centres of bodies, in halves of the viewport. */
const HALF_MIN = 0.3;
const MARGIN = 0.16;
/** Pixels between two viewports. */
const GAP = 2;

export class Picture<R extends EngineModule, W extends WorldLike> {
    readonly rig: Rig;
    private readonly renderer: WebGLRenderer;
    private shown: Shown<R, W>[] = [];
    private debugging = false;
    private readonly papers = new Map<Theme, LineSegments>();
    private readonly skies = new Map<Theme, Sky>();

    constructor(
        readonly canvas: HTMLCanvasElement,
        readonly flat: boolean,
        private theme: Theme,
        detail: "high" | "low",
    ) {
        this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: detail === "low" });
        this.renderer.toneMapping = NoToneMapping;
        this.renderer.shadowMap.enabled = !flat;
        this.renderer.shadowMap.type = PCFShadowMap;
        this.renderer.autoClear = false;
        this.renderer.setPixelRatio(Math.min(detail === "low" ? 1 : 2, window.devicePixelRatio));
        this.rig = new Rig(canvas, flat);
    }

    set debug(shown: boolean) {
        this.debugging = shown;
        for (const { view } of this.shown) view.debug = shown;
    }

    get views(): readonly StageView<R, W>[] {
        return this.shown.map(({ view }) => view);
    }

    frame(camera: Camera): void {
        this.rig.frame(camera);
    }

    /** Shows these stages side by side. */
    show(stages: readonly Stage<R, W>[], theme: Theme): void {
        this.theme = theme;
        for (const { view, sun } of this.shown) {
            view.dispose();
            sun?.dispose();
        }
        this.shown = stages.map((stage) => {
            const view = new StageView(stage, theme);
            view.debug = this.debugging;
            if (this.flat) view.scene.add(this.paper(theme));
            return { view, sun: this.flat ? null : this.light(view) };
        });
    }

    /** Squared paper, drawn once for each theme. */
    private paper(theme: Theme): LineSegments {
        const known = this.papers.get(theme);
        const paper = known ?? createPaper(theme);
        this.papers.set(theme, paper);
        return known ? paper.clone() : paper;
    }

    private light(view: StageView<R, W>): Sun {
        const sky = this.skies.get(this.theme) ?? new Sky(this.theme);
        this.skies.set(this.theme, sky);
        sky.light(view.scene);
        return new Sun(view.scene, this.theme);
    }

    /** The viewports of all views: side by side, or on top of each other where the page is narrow. */
    viewports(): Viewport[] {
        const [w, h] = [Math.max(1, this.canvas.clientWidth), Math.max(1, this.canvas.clientHeight)];
        const count = Math.max(1, this.shown.length);
        return Array.from({ length: count }, (_, index) => {
            const gap = index < count - 1 ? GAP : 0;
            return w < h
                ? { left: 0, top: (h / count) * index, width: w, height: h / count - gap }
                : { left: (w / count) * index, top: 0, width: w / count - gap, height: h };
        });
    }

    /** The place of a pointer, or null outside of all viewports. */
    locate(clientX: number, clientY: number): Place | null {
        const box = this.canvas.getBoundingClientRect();
        const [px, py] = [clientX - box.left, clientY - box.top];
        const index = this.viewports().findIndex(
            ({ left, top, width, height }) => px >= left && px < left + width && py >= top && py < top + height,
        );
        const found = this.viewports()[index];
        if (found === undefined) return null;
        return { index, x: (2 * (px - found.left)) / found.width - 1, y: 1 - (2 * (py - found.top)) / found.height };
    }

    render(fraction: number): void {
        this.resize();
        this.rig.update();
        this.renderer.setScissorTest(false);
        this.renderer.setClearColor(this.theme.grid);
        this.renderer.clear();
        this.renderer.setScissorTest(true);
        const total = this.canvas.clientHeight;
        this.viewports().forEach(({ left, top, width, height }, index) => {
            const shown = this.shown[index];
            if (!shown) return;
            shown.view.update(fraction);
            if (shown.sun) this.aim(shown.view, shown.sun);
            this.rig.fit(width, height);
            this.renderer.setViewport(left, total - top - height, width, height);
            this.renderer.setScissor(left, total - top - height, width, height);
            this.renderer.render(shown.view.scene, this.rig.camera);
        });
    }

    private resize(): void {
        const { clientWidth, clientHeight } = this.canvas;
        const ratio = this.renderer.getPixelRatio();
        const fits =
            this.canvas.width === Math.floor(clientWidth * ratio) && this.canvas.height === Math.floor(clientHeight * ratio);
        if (!fits) this.renderer.setSize(clientWidth, clientHeight, false);
    }

    /** Shadows and fog follow the camera: they are as large as the visible part of the scene. */
    private aim(view: StageView<R, W>, sun: Sun): void {
        const { reach, around, controls } = this.rig;
        sun.aim(controls.target, reach, around, view.casters(reach));
        const { fog } = view.scene;
        if (fog instanceof Fog) {
            fog.near = 2.2 * reach;
            fog.far = 7 * reach;
        }
    }

    /** Frees the canvas: pages that show several pictures have few WebGL contexts. */
    dispose(): void {
        this.show([], this.theme);
        for (const sky of this.skies.values()) sky.dispose();
        this.rig.controls.dispose();
        this.renderer.dispose();
        this.renderer.forceContextLoss();
    }

    /** The part of the first viewport with nearly all moving bodies, in the range -1 to 1, or null without bodies. */
    private busyPart(): { x: number; y: number; half: number } | null {
        const stage = this.shown[0]?.view.stage;
        const places: Vector3[] = [];
        const pose = new Float32Array(POSE_SIZE);
        stage?.world.forEachRigidBody((body) => {
            if (body.isFixed() || body.numColliders() === 0) return;
            stage.dimension.readPose(body.collider(0), pose);
            const place = new Vector3(pose[0], pose[1], pose[2]).project(this.rig.camera);
            if (Math.abs(place.x) < 1 && Math.abs(place.y) < 1) places.push(place);
        });
        if (places.length === 0) return null;
        const range = (values: number[]): [number, number] => {
            values.sort((a, b) => a - b);
            const at = (index: number): number => values[index] ?? 0;
            let first = Math.round(OUTLIERS * (values.length - 1));
            let last = Math.round((1 - OUTLIERS) * (values.length - 1));
            // The top of a pyramid has few bodies. Without a gap, the picture includes the top.
            const gap = OUTLIER_GAP * (at(last) - at(first));
            while (first > 0 && at(first) - at(first - 1) <= gap) first -= 1;
            while (last < values.length - 1 && at(last + 1) - at(last) <= gap) last += 1;
            return [at(first), at(last)];
        };
        const [left, right] = range(places.map(({ x }) => x));
        const [bottom, top] = range(places.map(({ y }) => y));
        const half = Math.min(1, Math.max(HALF_MIN, MARGIN + Math.max(right - left, top - bottom) / 2));
        return { x: (left + right) / 2, y: (bottom + top) / 2, half };
    }

    /** Draws pictures of the busy part side by side. `next` runs between two of them. Returns a data URL. */
    photograph(type: string, quality: number, width: number, height: number, count = 1, next = (): void => {}): string {
        const target = document.createElement("canvas");
        target.width = width * count;
        target.height = height;
        const context = target.getContext("2d");
        if (!context) throw new Error("no 2D canvas for the photograph");
        context.imageSmoothingQuality = "high";
        this.render(1);
        const { x, y, half } = this.busyPart() ?? { x: 0, y: 0, half: 1 };
        for (let index = 0; index < count; index++) {
            if (index > 0) next();
            this.render(1);
            const { width: w, height: h } = this.canvas;
            const scale = Math.min(w / width, h / height) * half;
            const [sw, sh] = [width * scale, height * scale];
            const [sx, sy] = [((1 + x) * w - sw) / 2, ((1 - y) * h - sh) / 2];
            context.drawImage(this.canvas, Math.max(0, Math.min(w - sw, sx)), Math.max(0, Math.min(h - sh, sy)), sw, sh, index * width, 0, width, height);
        }
        return target.toDataURL(type, quality);
    }
}

/** Squared paper for the background of 2D scenes. */
function createPaper(theme: Theme): LineSegments {
    const [reach, positions, colors] = [120, [] as number[], [] as number[]];
    for (let at = -reach; at <= reach; at++) {
        const tone = new Color().lerpColors(theme.sky, theme.grid, at % 5 === 0 ? 0.32 : 0.12);
        positions.push(at, -reach, -5, at, reach, -5, -reach, at, -5, reach, at, -5);
        for (let corner = 0; corner < 4; corner++) colors.push(tone.r, tone.g, tone.b);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
    geometry.setAttribute("color", new Float32BufferAttribute(colors, 3));
    const grid = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
    grid.renderOrder = -1;
    return grid;
}
