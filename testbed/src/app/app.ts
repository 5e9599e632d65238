// The testbed: scenes, engines, time, and the page.

import { Clock } from "../core/clock.ts";
import type { Dimension } from "../core/dimension.ts";
import type { Engine, EngineId, EngineModule, WorldLike } from "../core/engine.ts";
import type { Input, ParameterValue, SceneDefinition } from "../core/scene.ts";
import { defaultSettings, type Settings } from "../core/settings.ts";
import { defaultParameters, Stage } from "../core/stage.ts";
import { Gallery } from "../ui/gallery.ts";
import { helpSheet } from "../ui/help.ts";
import { Joystick } from "../ui/joystick.ts";
import { Labels } from "../ui/labels.ts";
import { Layout } from "../ui/layout.ts";
import { Panel } from "../ui/panel.ts";
import { Plot } from "../ui/plot.ts";
import { SourceSheet } from "../ui/source.ts";
import { Toast } from "../ui/toast.ts";
import { Transport } from "../ui/transport.ts";
import { Picture } from "../view/picture.ts";
import { THEMES, type ThemeName } from "../view/theme.ts";
import { listenToKeys } from "./keys.ts";
import { applyParameters, changedValues, writeLink, type EngineMode, type Link } from "./link.ts";
import { Pointer } from "./pointer.ts";

export interface AppOptions<R extends EngineModule, W extends WorldLike> {
    readonly dimension: Dimension<R, W>;
    readonly scenes: readonly SceneDefinition<R, W>[];
    readonly engines: ReadonlyMap<EngineId, Engine<R>>;
    /** Why the other engines are not there. */
    readonly missing: ReadonlyMap<EngineId, string>;
    readonly link: Link;
    readonly root: HTMLElement;
    /** Returns the file of a scene and its source. */
    readonly findSource: (id: string) => Promise<{ file: string; source: string }>;
}

/** The scene of an address without one: it keeps moving. */
const FIRST = "washer";

const ENGINE_MODES: readonly EngineMode[] = ["own", "published", "both"];

export class App<R extends EngineModule, W extends WorldLike> {
    readonly clock = new Clock();
    stages: Stage<R, W>[] = [];
    scene: SceneDefinition<R, W>;
    readonly picture: Picture<R, W>;
    private readonly input: Input = { x: 0, y: 0, action: false, used: false };
    private mode: EngineMode;
    private themeName: ThemeName;
    private debug: boolean;
    private settings: Settings;
    private parameters: Record<string, ParameterValue>;
    private snapshots: (Uint8Array | null)[] = [];
    private readonly pointer: Pointer<R, W>;
    private readonly layout: Layout;
    private readonly gallery: Gallery<R, W>;
    private readonly transport: Transport;
    private readonly panel: Panel;
    private readonly plot = new Plot<R, W>();
    private readonly labels = new Labels<R, W>();
    private readonly joystick: Joystick;
    private readonly toast = new Toast();
    private readonly help = helpSheet();
    private readonly source = new SourceSheet();
    private last = performance.now();

    constructor(private readonly options: AppOptions<R, W>) {
        const { link, scenes, dimension } = options;
        this.scene = this.find(link.scene) ?? this.first();
        this.mode = this.allowed(link.engine);
        this.themeName = link.theme ?? storedTheme();
        this.debug = link.debug;
        this.settings = defaultSettings(this.scene.gravity);
        this.parameters = defaultParameters(this.scene);
        this.gallery = new Gallery(scenes, "thumbnails", (id) => this.openScene(id));
        this.transport = new Transport({
            restart: () => this.restart(),
            toggle: () => this.toggle(),
            step: () => this.stepOnce(),
            speed: (value) => this.setSpeed(value),
            throwBall: () => this.pointer.throwBall(),
            debug: () => this.toggleDebug(),
        });
        this.panel = new Panel({
            changed: (live) => {
                if (live) this.writeLink();
                else this.restart();
            },
            takeSnapshot: () => this.takeSnapshot(),
            restoreSnapshot: () => this.restoreSnapshot(),
            reset: () => this.open(this.scene),
        });
        this.joystick = new Joystick(this.input);
        this.layout = new Layout({
            brand: dimension.flat ? "2D" : "3D",
            gallery: this.gallery.element,
            side: [this.plot.element, this.panel.element],
            over: [this.labels.element, this.joystick.element, this.toast.element, this.transport.element],
            help: this.help,
            missing: options.missing,
            chooseEngine: (mode) => this.setMode(mode),
            toggleTheme: () => this.toggleTheme(),
            share: () => void this.share(),
            viewSource: () => void this.viewSource(),
        });
        options.root.append(...this.layout.elements, this.source.element);
        document.documentElement.dataset["theme"] = this.themeName;
        this.picture = new Picture(this.layout.canvas, dimension.flat, THEMES[this.themeName], link.detail);
        this.pointer = new Pointer(this.picture, () => this.stages);
        listenToKeys(this.input, this.shortcuts());
        this.clock.running = !link.paused;
        this.open(this.scene, link);
        this.run(link.steps);
        const { title } = this.scene;
        if (link.scene !== null && link.scene !== this.scene.id) this.toast.show(`There is no scene "${link.scene}". This is ${title}.`);
    }

    private first(): SceneDefinition<R, W> {
        const first = this.find(FIRST) ?? this.options.scenes[0];
        if (!first) throw new Error("the testbed has no scenes");
        return first;
    }

    private find(id: string | null): SceneDefinition<R, W> | undefined {
        return this.options.scenes.find((scene) => scene.id === id);
    }

    /** The requested engines, or the present ones. */
    private allowed(wanted: EngineMode | null): EngineMode {
        const { engines } = this.options;
        const own = engines.has("own");
        if (wanted === "both") return own && engines.has("published") ? "both" : own ? "own" : "published";
        if (wanted !== null && engines.has(wanted)) return wanted;
        return own ? "own" : "published";
    }

    private get chosen(): Engine<R>[] {
        const ids: EngineId[] = this.mode === "both" ? ["own", "published"] : [this.mode];
        return ids.flatMap((id) => this.options.engines.get(id) ?? []);
    }

    openScene(id: string): void {
        const scene = this.find(id);
        if (!scene) return;
        this.open(scene);
        this.layout.closeSheets();
    }

    private open(scene: SceneDefinition<R, W>, link?: Link): void {
        this.scene = scene;
        this.settings = { ...defaultSettings(scene.gravity), ...link?.settings };
        this.parameters = defaultParameters(scene);
        if (link !== undefined) applyParameters(link.parameters, scene.parameters ?? {}, this.parameters);
        this.panel.show(this.settings, scene.parameters ?? {}, this.parameters);
        this.picture.frame(scene.camera);
        this.layout.describe(scene.title, scene.description);
        this.gallery.select(scene.id);
        this.joystick.show(scene);
        this.restart();
    }

    restart(): void {
        this.pointer.forget();
        this.snapshots = [];
        this.input.used = false;
        for (const stage of this.stages) stage.dispose();
        this.stages = this.chosen.flatMap((engine) => this.build(engine) ?? []);
        this.clock.reset();
        this.refresh();
        this.writeLink();
    }

    private writeLink(): void {
        const { scene, settings, parameters } = this;
        const changed = changedValues(settings, defaultSettings(scene.gravity), parameters, defaultParameters(scene));
        writeLink(scene.id, this.mode, changed);
    }

    /** Hands the address to the system's dialog on a phone, and copies it elsewhere. */
    private async share(): Promise<void> {
        this.writeLink();
        const url = location.href;
        try {
            if (matchMedia("(pointer: coarse)").matches && "share" in navigator) {
                await navigator.share({ title: document.title, url });
                return;
            }
            await navigator.clipboard.writeText(url);
            this.toast.show("Copied: the address of this scene with its parameters");
        } catch (error) {
            if (!(error instanceof DOMException && error.name === "AbortError")) this.toast.show("The address above has the scene and its parameters");
        }
    }

    private async viewSource(): Promise<void> {
        try {
            const { file, source } = await this.options.findSource(this.scene.id);
            this.source.show(file, source);
        } catch (error) {
            this.toast.show(`No source: ${String(error)}`);
        }
    }

    /** Builds the scene in an engine. A failure is shown, and other engines run. */
    private build(engine: Engine<R>): Stage<R, W> | null {
        const { settings, parameters, input } = this;
        try {
            return new Stage(this.options.dimension, engine, this.scene, { settings, parameters, input });
        } catch (error) {
            this.toast.show(`${engine.label}: ${String(error)}`);
            console.error(error);
            return null;
        }
    }

    /** Builds the pictures of all stages anew. */
    private refresh(): void {
        this.picture.show(this.stages, THEMES[this.themeName]);
        this.picture.debug = this.debug;
        this.labels.show(this.stages);
        this.plot.show(this.stages);
        this.layout.engine = this.mode;
        this.transport.show(this.clock.running, this.clock.speed, this.debug);
    }

    toggle(): void {
        this.clock.running = !this.clock.running;
        this.transport.show(this.clock.running, this.clock.speed, this.debug);
    }

    stepOnce(): void {
        this.clock.stepOnce();
        this.transport.show(false, this.clock.speed, this.debug);
    }

    private setSpeed(value: number): void {
        this.clock.speed = value;
        this.transport.show(this.clock.running, value, this.debug);
    }

    private toggleDebug(): void {
        this.debug = !this.debug;
        this.picture.debug = this.debug;
        this.transport.show(this.clock.running, this.clock.speed, this.debug);
    }

    setMode(mode: EngineMode): void {
        this.mode = this.allowed(mode);
        this.restart();
    }

    private toggleTheme(): void {
        this.themeName = this.themeName === "dark" ? "light" : "dark";
        document.documentElement.dataset["theme"] = this.themeName;
        localStorage.setItem("theme", this.themeName);
        this.refresh();
    }

    private takeSnapshot(): void {
        this.pointer.forget();
        try {
            this.snapshots = this.stages.map((stage) => stage.takeSnapshot());
        } catch (error) {
            this.toast.show(`No snapshot: ${String(error)}`);
            console.error(error);
            return;
        }
        const sizes = this.snapshots.map((snapshot) => `${((snapshot?.length ?? 0) / 1024).toFixed(0)} kB`);
        this.toast.show(`Snapshot taken: ${sizes.join(" and ")}`);
    }

    private restoreSnapshot(): void {
        if (this.snapshots.length === 0) {
            this.toast.show("There is no snapshot yet");
            return;
        }
        this.pointer.forget();
        const scripted = this.stages.some(({ run }) => run.update !== undefined || run.after !== undefined);
        this.stages.forEach((stage, index) => {
            const snapshot = this.snapshots[index];
            if (snapshot) stage.restore(snapshot);
        });
        this.refresh();
        this.toast.show(scripted ? "Restored. The scene's script ended with the old world." : "Restored");
    }

    private neighbour(way: 1 | -1): void {
        const { scenes } = this.options;
        const index = scenes.indexOf(this.scene) + way;
        const scene = scenes[(index + scenes.length) % scenes.length];
        if (scene) this.open(scene);
    }

    private nextMode(): void {
        const index = ENGINE_MODES.indexOf(this.mode);
        this.setMode(ENGINE_MODES[(index + 1) % ENGINE_MODES.length] ?? "own");
    }

    private shortcuts(): Map<string, () => void> {
        return new Map([
            ["p", () => this.toggle()],
            ["n", () => this.stepOnce()],
            ["r", () => this.restart()],
            ["s", () => this.setSpeed(this.transport.nextSpeed())],
            [" ", () => this.pointer.throwBall()],
            ["d", () => this.toggleDebug()],
            ["c", () => this.picture.frame(this.scene.camera)],
            ["e", () => this.nextMode()],
            ["t", () => this.takeSnapshot()],
            ["b", () => this.restoreSnapshot()],
            ["[", () => this.neighbour(-1)],
            ["]", () => this.neighbour(1)],
            ["/", () => this.layout.openGallery(this.gallery.search)],
            ["l", () => this.toggleTheme()],
            ["?", () => this.help.showModal()],
            ["escape", () => this.layout.closeSheets()],
        ]);
    }

    /** One step of every stage. */
    private advance(shown: boolean): void {
        for (const stage of this.stages) {
            stage.advance();
            stage.awake.push(stage.countAwake());
        }
        if (shown) for (const view of this.picture.views) view.capture();
    }

    /** Runs steps at once, without pictures in between. */
    run(steps: number): void {
        this.follow();
        for (let step = 0; step < steps; step++) this.advance(step >= steps - 2);
    }

    /** Moves the camera with the point that the scene names. */
    private follow(): void {
        this.picture.rig.follow(this.stages[0]?.run.follow?.() ?? null);
    }

    private frame(now: number): void {
        const timestep = 1 / this.settings.rate;
        const steps = this.clock.take((now - this.last) / 1000, timestep);
        this.last = now;
        for (let step = 0; step < steps; step++) this.advance(step >= steps - 2);
        this.follow();
        this.picture.render(this.clock.fraction(timestep));
        this.labels.update(now, this.picture.viewports());
        this.plot.update(now);
    }

    /** Draws frames until a frame fails; the message of the failure is shown. */
    start(): void {
        const next = (now: number): void => {
            try {
                this.frame(now);
            } catch (error) {
                this.toast.show(`The scene stopped: ${String(error)}`);
                console.error(error);
                this.clock.running = false;
                this.transport.show(false, this.clock.speed, this.debug);
            }
            requestAnimationFrame(next);
        };
        requestAnimationFrame(next);
    }
}

function storedTheme(): ThemeName {
    const stored = localStorage.getItem("theme");
    if (stored === "dark" || stored === "light") return stored;
    return matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark";
}
