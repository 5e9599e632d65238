// Thumbnails of scenes. Each leads to the scene's page, and moves under the pointer.

import Link from "@docusaurus/Link";
import useBaseUrl from "@docusaurus/useBaseUrl";
import { type ReactNode, useState } from "react";
import "@repository/testbed/src/ui/moving.css";
import type { DimensionName } from "./package";
import styles from "./SceneGrid.module.css";

export interface SceneEntry {
    readonly dimension: DimensionName;
    readonly id: string;
    readonly title: string;
    readonly description: string;
    readonly group: string;
}

function Thumbnail({ dimension, id, title, description }: SceneEntry): ReactNode {
    const [moves, setMoves] = useState(false);
    const strip = useBaseUrl(`/thumbnails/${dimension}/moving/${id}.webp`);
    // The link of Docusaurus replaces `onMouseEnter` with its own.
    return (
        <div className={styles.cell} onMouseEnter={() => setMoves(true)} onMouseLeave={() => setMoves(false)}>
            <Link className={styles.thumbnail} to={`/gallery/${dimension}/${id}`} title={description}>
                <span className={styles.picture}>
                    <img src={useBaseUrl(`/thumbnails/${dimension}/${id}.webp`)} alt="" width={240} height={150} loading="lazy" />
                    {moves && <span className="moving" style={{ backgroundImage: `url("${strip}")` }} />}
                </span>
                <span className={styles.title}>{title}</span>
            </Link>
        </div>
    );
}

export default function SceneGrid({ scenes }: { readonly scenes: readonly SceneEntry[] }): ReactNode {
    return (
        <div className={styles.grid}>
            {scenes.map((scene) => (
                <Thumbnail key={`${scene.dimension} ${scene.id}`} {...scene} />
            ))}
        </div>
    );
}
