// A picture of a document. Where the testbed has the scene, a button runs it in place of the picture.

import { type ComponentProps, type ReactNode, useEffect, useRef, useState } from "react";
import LiveScene from "./LiveScene";
import styles from "./ScenePicture.module.css";

/** Scenes of the testbed by name of a picture in docs/images. */
const SCENES: Readonly<Record<string, string>> = {
    bullets: "bullets",
    characters: "character",
    joints: "joints",
    motors: "motors",
    robot_arm: "robot-arm",
    strider: "walker",
    vehicle: "car",
};

/** The name of a picture, from its address in the build. */
function sceneOf(address = ""): string | undefined {
    const name = /([\w]+)-[0-9a-f]{8,}\.png$/.exec(address)?.[1] ?? "";
    return Object.hasOwn(SCENES, name) ? SCENES[name] : undefined;
}

export default function ScenePicture(props: ComponentProps<"img">): ReactNode {
    const [live, setLive] = useState(false);
    const player = useRef<HTMLDivElement>(null);
    // The pressed button vanishes: the scene in its place takes the focus.
    useEffect(() => player.current?.focus({ preventScroll: true }), [live]);
    const scene = sceneOf(props.src);
    const picture = <img loading="lazy" decoding="async" {...props} alt={props.alt ?? ""} />;
    if (scene === undefined) return picture;
    if (live)
        return (
            <div ref={player} role="group" aria-label="Live scene" tabIndex={-1}>
                <LiveScene scene={scene} label={props.alt ?? scene} className={styles.live} />
            </div>
        );
    return (
        <div className={styles.picture}>
            {picture}
            <button type="button" className="picture-button" onClick={() => setLive(true)}>
                Run a scene like this
            </button>
        </div>
    );
}
