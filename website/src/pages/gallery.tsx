// The scenes of the browser testbeds: a picture each, and one live.

import Link from "@docusaurus/Link";
import { useHistory, useLocation } from "@docusaurus/router";
import Heading from "@theme/Heading";
import Layout from "@theme/Layout";
import { type ReactNode, useEffect, useState } from "react";
import Choice from "@site/src/charts/Choice";
import MovingPicture from "@site/src/components/MovingPicture";
import { MOVING } from "@site/src/components/moving";
import LiveScene, { engineSize } from "@site/src/live/LiveScene";
import type { DimensionName } from "@site/src/live/package";
import SceneGrid, { type SceneEntry } from "@site/src/live/SceneGrid";
import bullets from "@repository/docs/images/bullets.png";
import characters from "@repository/docs/images/characters.png";
import internalEdges from "@repository/docs/images/ghost-contacts.png";
import junkyard from "@repository/docs/images/junkyard.png";
import motors from "@repository/docs/images/motors.png";
import robotArm from "@repository/docs/images/robot_arm.png";
import scenes from "@site/generated/data/scenes.json";
import descriptions from "@site/generated/data/descriptions.json";
import styles from "./gallery.module.css";

const SCENES = scenes as readonly SceneEntry[];
const DIMENSIONS = [
    ["3d", "3D"],
    ["2d", "2D"],
] as const;

/** The scene that runs above the thumbnails: one that keeps moving. */
function first(dimension: DimensionName): SceneEntry {
    const found = SCENES.find((scene) => scene.dimension === dimension && scene.id === "washer");
    if (found === undefined) throw new RangeError("the testbed has no scene washer");
    return found;
}

const FIRST = { "3d": first("3d"), "2d": first("2d") };

/** Still pictures of the native gallery by name of the scene's file. */
const STILL = { junkyard, characters, robot_arm: robotArm, motors, bullets, internal_edges: internalEdges };

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

function Groups({ dimension }: { readonly dimension: DimensionName }): ReactNode {
    const shown = SCENES.filter((scene) => scene.dimension === dimension);
    return [...new Set(shown.map(({ group }) => group))].map((group) => (
        <section key={group}>
            <Heading as="h2" id={group.toLowerCase().replace(/\W+/g, "-")}>
                {group}
            </Heading>
            <SceneGrid scenes={shown.filter((scene) => scene.group === group)} />
        </section>
    ));
}

/** Earlier addresses name scenes behind the number sign. */
function useEarlierAddress(): void {
    const history = useHistory();
    const { hash } = useLocation();
    useEffect(() => {
        const named = SCENES.find(({ dimension, id }) => dimension === "3d" && `#${id}` === hash);
        if (named !== undefined) history.replace(`/gallery/3d/${named.id}`);
    }, [hash]);
}

export default function Gallery(): ReactNode {
    const [dimension, setDimension] = useState<DimensionName>("3d");
    useEarlierAddress();
    const { id, title, description } = FIRST[dimension];
    const count = (name: DimensionName): number => SCENES.filter((scene) => scene.dimension === name).length;
    return (
        <Layout title="Gallery" description="Scenes in 3D and 2D that run in the page.">
            <main className="container margin-vert--lg">
                <h1>Gallery</h1>
                <p>
                    {count("3d")} scenes in 3D and {count("2d")} in 2D run in the page. Drag bodies with the mouse or a finger. The
                    engine is loaded once: {engineSize("3d")} in 3D, {engineSize("2d")} in 2D.
                </p>
                <Choice label="Dimension" options={DIMENSIONS} value={dimension} choose={setDimension} />
                <LiveScene
                    key={dimension}
                    scene={id}
                    dimension={dimension}
                    label={`${title}: ${description}`}
                    className={styles.stage}
                />
                <p className={styles.caption}>
                    <Link to={`/gallery/${dimension}/${id}`}>{title}</Link>. {description}
                </p>
                <Groups dimension={dimension} />
                <Pictures />
            </main>
        </Layout>
    );
}
