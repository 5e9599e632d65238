// A scene that runs in the page: visitors drag bodies, throw balls, pause and begin again.

import { useColorMode } from "@docusaurus/theme-common";
import useBaseUrl from "@docusaurus/useBaseUrl";
import clsx from "clsx";
import { type ReactNode, useEffect, useRef, useState } from "react";
import weights from "@site/generated/data/weights.json";
import { listenToKeys } from "@repository/testbed/src/app/keys";
import { Joystick, type Steered } from "@repository/testbed/src/ui/joystick";
import "@repository/testbed/src/ui/joystick.css";
import type { AnyPlayer, Figures } from "./player";
import type { DimensionName } from "./package";
import styles from "./LiveScene.module.css";

interface LiveSceneProps {
    /** Name of a scene of the testbed. */
    readonly scene: string;
    readonly dimension?: DimensionName;
    /** Whether the scene can be steered, and what its action button does. */
    readonly steering?: Steered;
    /** A description of the scene for screen readers. */
    readonly label: string;
    readonly className?: string;
}

type State = "loading" | "running" | "paused" | "missing" | "failed";

const WEIGHTS: Readonly<Record<DimensionName, number>> | null = weights;

/** The size of an engine as the server sends it, for example "1.3 MB". Empty where the page was built without the packages. */
export function engineSize(dimension: DimensionName): string {
    return WEIGHTS === null ? "" : `${(WEIGHTS[dimension] / 1e6).toFixed(1)} MB`;
}

const MESSAGES: Partial<Record<State, ReactNode>> = {
    loading: "The engine is loading",
    missing: (
        <>
            This page was built without the engine. Build the packages, then start again:
            <code>npm install; ./build_all.sh</code> in <code>rapier3d</code> and <code>rapier2d</code>
        </>
    ),
    failed: "The scene cannot run in this browser. It needs WebGL 2 and WebAssembly.",
};

const UNSTEERED: Steered = {};

function wantsStillness(): boolean {
    return matchMedia("(prefers-reduced-motion: reduce)").matches;
}

/** Starts a player for the canvas when the canvas comes into view for the first time. */
function usePlayer(scene: string, dimension: DimensionName) {
    const canvas = useRef<HTMLCanvasElement>(null);
    const player = useRef<AnyPlayer | null>(null);
    const [state, setState] = useState<State>("loading");
    const [figures, setFigures] = useState<Figures | null>(null);
    const { colorMode } = useColorMode();
    const wanted = useRef({ scene, theme: colorMode });
    wanted.current = { scene, theme: colorMode };
    const fail = (error: unknown): void => {
        console.warn("the scene does not run", error);
        setState("failed");
    };
    const open = (id: string): void => {
        if (player.current === null) return;
        try {
            player.current.open(id);
            setState(player.current.clock.running ? "running" : "paused");
        } catch (error) {
            fail(error);
        }
    };

    useEffect(() => {
        const element = canvas.current;
        if (element === null) return undefined;
        let ended = false;
        let started = false;
        const start = async (): Promise<void> => {
            const { startPlayer } = await import("./package");
            const made = await startPlayer(dimension, { canvas: element, theme: wanted.current.theme, report: setFigures, fail });
            if (ended) {
                made?.dispose();
                return;
            }
            if (made === null) {
                setState("missing");
                return;
            }
            player.current = made;
            made.clock.running = !wantsStillness();
            open(wanted.current.scene);
        };
        const observer = new IntersectionObserver((entries) => {
            const visible = entries.some((entry) => entry.isIntersecting);
            if (player.current !== null) player.current.visible = visible;
            if (!visible || started) return;
            started = true;
            start().catch((error: unknown) => !ended && fail(error));
        });
        observer.observe(element);
        return () => {
            ended = true;
            observer.disconnect();
            player.current?.dispose();
            player.current = null;
        };
    }, []);

    useEffect(() => open(scene), [scene]);
    useEffect(() => player.current?.setTheme(colorMode), [colorMode]);
    return { canvas, player, state, setState, figures, open };
}

/** Keys and, on touch screens, a joystick for scenes that can be steered. */
function useSteering(player: { readonly current: AnyPlayer | null }, ready: boolean, steering: Steered) {
    const frame = useRef<HTMLDivElement>(null);
    useEffect(() => {
        const input = player.current?.input;
        if (!ready || steering.steered !== true || input === undefined || frame.current === null) return undefined;
        listenToKeys(input, new Map(), frame.current);
        const joystick = new Joystick(input);
        joystick.show(steering);
        frame.current.append(joystick.element);
        return () => joystick.element.remove();
    }, [ready, steering]);
    return frame;
}

export default function LiveScene({ scene, dimension = "3d", steering = UNSTEERED, label, className }: LiveSceneProps): ReactNode {
    const { canvas, player, state, setState, figures, open } = usePlayer(scene, dimension);
    const poster = useBaseUrl(`/thumbnails/${dimension}/${scene}.webp`);
    const ready = state === "running" || state === "paused";
    const frame = useSteering(player, ready, steering);
    const toggle = (): void => {
        const clock = player.current?.clock;
        if (clock === undefined) return;
        clock.running = !clock.running;
        setState(clock.running ? "running" : "paused");
    };
    return (
        <div ref={frame} className={clsx(styles.frame, className)} data-live={state}>
            <canvas ref={canvas} className={styles.canvas} role="img" aria-label={label} tabIndex={steering.steered === true ? 0 : undefined} />
            {!ready && (
                <div className={styles.cover}>
                    <img className={styles.poster} src={poster} alt="" />
                    <p className={styles.message}>
                        {MESSAGES[state]}
                        {state === "loading" && `: ${engineSize(dimension)} …`}
                    </p>
                </div>
            )}
            {ready && (
                <div className={styles.bar}>
                    <button type="button" onClick={toggle}>
                        {state === "running" ? "Pause" : "Play"}
                    </button>
                    <button type="button" onClick={() => open(scene)}>
                        Restart
                    </button>
                    <button type="button" onClick={() => player.current?.throwBall()}>
                        Throw a ball
                    </button>
                    {figures !== null && (
                        <span className={styles.figures}>
                            {figures.bodies} bodies, {figures.awake} awake · {figures.step.toFixed(2)} ms a step
                        </span>
                    )}
                </div>
            )}
        </div>
    );
}
