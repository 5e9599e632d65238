// Thumbnails of scenes. Each leads to the scene's page, and moves under the pointer.

import Link from "@docusaurus/Link";
import useBaseUrl from "@docusaurus/useBaseUrl";
import type { ReactNode } from "react";
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
    return (
        <Link className={styles.thumbnail} to={`/gallery/${dimension}/${id}`} title={description}>
            <img src={useBaseUrl(`/thumbnails/${dimension}/${id}.webp`)} alt="" width={240} height={150} loading="lazy" />
            <span>{title}</span>
        </Link>
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
