// A scene that runs in the page: visitors drag bodies, throw balls, pause and begin again.

import { useColorMode } from "@docusaurus/theme-common";
import useBaseUrl from "@docusaurus/useBaseUrl";
import clsx from "clsx";
import { type ReactNode, useEffect, useRef, useState } from "react";
import type { Figures, Player } from "./player";
import styles from "./LiveScene.module.css";

interface LiveSceneProps {
    /** Name of a scene of the 3D testbed. */
    readonly scene: string;
    /** A description of the scene for screen readers. */
    readonly label: string;
    readonly className?: string;
}

type State = "loading" | "running" | "paused" | "missing" | "failed";

const MESSAGES: Partial<Record<State, ReactNode>> = {
    loading: "The engine is loading …",
    missing: (
        <>
            This page was built without the engine. Build the package, then start again:
            <code>cd rapier3d; npm install; ./build_all.sh</code>
        </>
    ),
    failed: "The scene cannot run in this browser. It needs WebGL 2 and WebAssembly.",
};

function wantsStillness(): boolean {
    return matchMedia("(prefers-reduced-motion: reduce)").matches;
}

/** Starts a player for the canvas when the canvas comes into view for the first time. */
function usePlayer(scene: string) {
    const canvas = useRef<HTMLCanvasElement>(null);
    const player = useRef<Player | null>(null);
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
            const [{ Player }, { loadPackage }] = await Promise.all([import("./player"), import("./package")]);
            const engine = await loadPackage();
            if (ended) return;
            if (engine === null) {
                setState("missing");
                return;
            }
            const made = new Player(engine, { canvas: element, theme: wanted.current.theme, report: setFigures, fail });
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

export default function LiveScene({ scene, label, className }: LiveSceneProps): ReactNode {
    const { canvas, player, state, setState, figures, open } = usePlayer(scene);
    const poster = useBaseUrl(`/thumbnails/${scene}.webp`);
    const ready = state === "running" || state === "paused";
    const toggle = (): void => {
        const clock = player.current?.clock;
        if (clock === undefined) return;
        clock.running = !clock.running;
        setState(clock.running ? "running" : "paused");
    };
    return (
        <div className={clsx(styles.frame, className)} data-live={state}>
            <canvas ref={canvas} className={styles.canvas} role="img" aria-label={label} />
            {!ready && (
                <div className={styles.cover}>
                    <img className={styles.poster} src={poster} alt="" />
                    <p className={styles.message}>{MESSAGES[state]}</p>
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
