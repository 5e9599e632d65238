// A scene of the testbed beside the text of a document: its thumbnail and description, and a button that runs it.

import useBaseUrl from "@docusaurus/useBaseUrl";
import { type ReactNode, useState } from "react";
import scenes from "@site/generated/data/scenes.json";
import LiveInPlace from "./LiveInPlace";
import styles from "./SceneCard.module.css";


export default function SceneCard({ scene }: { readonly scene: string }): ReactNode {
    const [live, setLive] = useState(false);
    const thumbnail = useBaseUrl(`/thumbnails/3d/${scene}.webp`);
    const found = scenes.find(({ dimension, id }) => dimension === "3d" && id === scene);
    if (found === undefined) throw new RangeError(`the testbed has no scene "${scene}"`);
    const { title, description } = found;
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
