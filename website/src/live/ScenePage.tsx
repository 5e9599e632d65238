// The page of one scene: the scene live, its address to share, its source, and its neighbours in the gallery.

import Link from "@docusaurus/Link";
import { PageMetadata } from "@docusaurus/theme-common";
import CodeBlock from "@theme/CodeBlock";
import Layout from "@theme/Layout";
import { type ReactNode, useState } from "react";
import scenes from "@site/generated/data/scenes.json";
import LiveScene from "./LiveScene";
import SceneGrid, { type SceneEntry } from "./SceneGrid";
import styles from "./ScenePage.module.css";

export interface SceneData extends SceneEntry {
    readonly steered: boolean;
    readonly action?: string;
    /** Path of the source in the repository. */
    readonly file: string;
    readonly source: string;
}

/** Hands the page's address to the system's dialog, or copies it. */
function Share({ title }: { readonly title: string }): ReactNode {
    const [text, setText] = useState("Share");
    const share = async (): Promise<void> => {
        const url = location.origin + location.pathname;
        if (matchMedia("(pointer: coarse)").matches && "share" in navigator) await navigator.share({ title, url });
        else {
            await navigator.clipboard.writeText(url);
            setText("Address copied");
        }
    };
    const start = (): void => void share().catch((error: Error) => error.name !== "AbortError" && setText("Copy the address above"));
    return (
        <button type="button" className="button button--secondary" onClick={start}>
            {text}
        </button>
    );
}

export default function ScenePage({ scene }: { readonly scene: SceneData }): ReactNode {
    const { dimension, id, title, description, group, file, source, steered } = scene;
    const entries = scenes as readonly SceneEntry[];
    const neighbours = entries.filter((other) => other.dimension === dimension && other.group === group && other.id !== id);
    return (
        <Layout title={`${title}, ${dimension.toUpperCase()}`} description={description}>
            <PageMetadata image={`thumbnails/${dimension}/${id}.webp`} />
            <main className="container margin-vert--lg">
                <p className={styles.path}>
                    <Link to="/gallery">Gallery</Link> · {dimension.toUpperCase()} · {group}
                </p>
                <div className={styles.head}>
                    <h1>{title}</h1>
                    <Share title={title} />
                </div>
                <p>
                    {description}
                    {steered && " The keys act after a click into the scene; a touch screen has a joystick."}
                </p>
                <LiveScene
                    key={`${dimension} ${id}`}
                    scene={id}
                    dimension={dimension}
                    steering={scene}
                    label={`${title}: ${description}`}
                    className={styles.stage}
                />
                <h2>Source</h2>
                <p>The scene receives the package as <code>RAPIER</code>. Functions such as <code>addFloor</code> are in <code>kit.ts</code> beside it.</p>
                <CodeBlock language="typescript" title={file} className={styles.source}>
                    {source}
                </CodeBlock>
                {neighbours.length > 0 && <h2>{group}</h2>}
                <SceneGrid scenes={neighbours} />
            </main>
        </Layout>
    );
}

