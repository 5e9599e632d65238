// A picture of a document. Where the testbed has the scene, a button runs it in place of the picture.

import MDXImg from "@theme/MDXComponents/Img";
import { type ComponentProps, type ReactNode, useState } from "react";
import LiveInPlace from "./LiveInPlace";
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
    const scene = sceneOf(props.src);
    const picture = <MDXImg {...props} alt={props.alt ?? ""} />;
    if (scene === undefined) return picture;
    if (live) return <LiveInPlace scene={scene} label={props.alt ?? scene} />;
    return (
        <div className={styles.picture}>
            {picture}
            <button type="button" className="picture-button" onClick={() => setLive(true)}>
                Run a scene like this
            </button>
        </div>
    );
}
