// A scene of the testbed beside the text of a document: its thumbnail and description, and a button that runs it.

import useBaseUrl from "@docusaurus/useBaseUrl";
import { type ReactNode, useState } from "react";
import scenes from "@site/generated/data/scenes.json";
import LiveInPlace from "./LiveInPlace";
import styles from "./SceneCard.module.css";

const SCENES: Readonly<Record<string, { title: string; description: string }>> = scenes;

export default function SceneCard({ scene }: { readonly scene: string }): ReactNode {
    const [live, setLive] = useState(false);
    const thumbnail = useBaseUrl(`/thumbnails/${scene}.webp`);
    const { title, description } = SCENES[scene] ?? {};
    if (title === undefined) throw new RangeError(`the testbed has no scene "${scene}"`);
    if (live) return <LiveInPlace scene={scene} label={`${title}: ${description}`} />;
    return (
        <div className={styles.card}>
            <img src={thumbnail} alt="" width={240} height={150} loading="lazy" />
            <div>
                <p>
                    <strong>{title}.</strong> {description}
                </p>
                <button type="button" aria-label={`Run the scene: ${title}`} onClick={() => setLive(true)}>
                    Run the scene
                </button>
            </div>
        </div>
    );
}
