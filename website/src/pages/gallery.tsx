// The scenes of the browser testbed: a picture each, and the chosen one live.

import Heading from "@theme/Heading";
import Layout from "@theme/Layout";
import useBaseUrl from "@docusaurus/useBaseUrl";
import { type ReactNode, useEffect, useState } from "react";
import { SCENES } from "@repository/testbed3d/src/scenes/index";
import MovingPicture from "@site/src/components/MovingPicture";
import { MOVING } from "@site/src/components/moving";
import LiveScene from "@site/src/live/LiveScene";
import bullets from "@repository/docs/images/bullets.png";
import characters from "@repository/docs/images/characters.png";
import internalEdges from "@repository/docs/images/ghost-contacts.png";
import junkyard from "@repository/docs/images/junkyard.png";
import motors from "@repository/docs/images/motors.png";
import robotArm from "@repository/docs/images/robot_arm.png";
import vehicle from "@repository/docs/images/vehicle.png";
import descriptions from "@site/generated/data/descriptions.json";
import styles from "./gallery.module.css";

type Scene = (typeof SCENES)[number];

const GROUPS = [...new Set(SCENES.map(({ group }) => group))];
const FIRST = SCENES.find(({ id }) => id === "ziggurat") ?? SCENES[0];

/** Still pictures of the native gallery by name of the scene's file. */
const STILL = { junkyard, vehicle, characters, robot_arm: robotArm, motors, bullets, internal_edges: internalEdges };

function keys<T extends object>(record: T): (keyof T)[] {
    return Object.keys(record) as (keyof T)[];
}

function Picture({ name, children }: { readonly name: keyof typeof descriptions; readonly children: ReactNode }): ReactNode {
    return (
        <figure>
            {children}
            <figcaption>{descriptions[name]}</figcaption>
        </figure>
    );
}

function Pictures(): ReactNode {
    return (
        <section>
            <Heading as="h2" id="pictures">
                Pictures of the native gallery
            </Heading>
            <p>
                <code>cargo run --release --bin all_examples3</code> opens a window with these scenes and others.
            </p>
            <div className={styles.pictures}>
                {keys(MOVING).map((name) => (
                    <Picture key={name} name={name}>
                        <MovingPicture picture={MOVING[name]} alt={descriptions[name]} />
                    </Picture>
                ))}
                {keys(STILL).map((name) => (
                    <Picture key={name} name={name}>
                        <img src={STILL[name]} alt={descriptions[name]} loading="lazy" />
                    </Picture>
                ))}
            </div>
        </section>
    );
}

function Thumbnail({
    scene,
    chosen,
    choose,
}: {
    readonly scene: Scene;
    readonly chosen: boolean;
    readonly choose: () => void;
}): ReactNode {
    return (
        <button type="button" className={styles.thumbnail} aria-pressed={chosen} onClick={choose}>
            <img src={useBaseUrl(`/thumbnails/${scene.id}.webp`)} alt="" loading="lazy" />
            <span>{scene.title}</span>
        </button>
    );
}

export default function Gallery(): ReactNode {
    const [scene, setScene] = useState<Scene>(FIRST);
    useEffect(() => {
        const named = SCENES.find(({ id }) => `#${id}` === location.hash);
        if (named !== undefined) setScene(named);
    }, []);
    const choose = (next: Scene): void => {
        setScene(next);
        history.replaceState(null, "", `#${next.id}`);
        scrollTo({ top: 0, behavior: "smooth" });
    };
    return (
        <Layout title="Gallery" description="Scenes that run in the page.">
            <main className="container margin-vert--lg">
                <h1>Gallery</h1>
                <p>{SCENES.length} scenes in 3D run in this page. Drag bodies with the mouse or a finger.</p>
                <LiveScene scene={scene.id} label={`${scene.title}: ${scene.description}`} className={styles.stage} />
                <p className={styles.caption}>
                    <strong>{scene.title}.</strong> {scene.description}
                </p>
                {GROUPS.map((group) => (
                    <section key={group}>
                        <Heading as="h2" id={group.toLowerCase().replace(/\W+/g, "-")}>
                            {group}
                        </Heading>
                        <div className={styles.grid}>
                            {SCENES.filter((candidate) => candidate.group === group).map((candidate) => (
                                <Thumbnail
                                    key={candidate.id}
                                    scene={candidate}
                                    chosen={candidate === scene}
                                    choose={() => choose(candidate)}
                                />
                            ))}
                        </div>
                    </section>
                ))}
                <Pictures />
            </main>
        </Layout>
    );
}
