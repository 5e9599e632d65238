// The first page: the engine at work, how fast it is, how to get it.

import Link from "@docusaurus/Link";
import Layout from "@theme/Layout";
import { type ReactNode, useState } from "react";
import Choice from "@site/src/charts/Choice";
import LeadChart from "@site/src/charts/LeadChart";
import { CONDITIONS, MACHINE, PEERS } from "@site/src/charts/contests";
import Install from "@site/src/components/Install";
import MovingPicture from "@site/src/components/MovingPicture";
import { MOVING } from "@site/src/components/moving";
import LiveScene from "@site/src/live/LiveScene";
import descriptions from "@site/generated/data/descriptions.json";
import styles from "./index.module.css";

const SCENES = [
    ["pile", "Pile"],
    ["wrecking-ball", "Wrecking ball"],
    ["ragdoll-heap", "Ragdolls"],
    ["bridge", "Bridge"],
    ["cards", "Card house"],
] as const;

const PICTURES = ["vehicle", "wrecking_ball", "ragdoll_stairs"] as const;

const PROMISES = [
    {
        title: "The same bits everywhere",
        text: "Any number of threads, with SIMD or without: x86-64, aarch64 and WebAssembly compute equal results.",
        link: "/docs/guide/determinism",
    },
    {
        title: "Ground without ghosts",
        text: "Bodies slide over meshes, tiles and height fields as over a plane, by default.",
        link: "/docs/guide/smooth-ground",
    },
    {
        title: "Sleep is free",
        text: "No loop of a step visits sleeping bodies or fixed scenery.",
        link: "/docs/guide/sleeping",
    },
    {
        title: "No value panics",
        text: "A NaN position or a mesh index out of range is refused with a message that names it.",
        link: "/docs/guide/getting-started#invalid-values",
    },
    {
        title: "Worlds as bytes",
        text: "Snapshots, deltas and recordings continue bit for bit. Damaged data is refused.",
        link: "/docs/guide/saving",
    },
    {
        title: "Heavy loads on light chains",
        text: "Joints that hold something are solved exactly; multibodies have reduced coordinates.",
        link: "/docs/guide/joints",
    },
];

function Hero(): ReactNode {
    const [scene, setScene] = useState<(typeof SCENES)[number][0]>("pile");
    return (
        <header className={styles.hero}>
            <div className={styles.words}>
                <h1>Rapier</h1>
                <p className={styles.sentence}>
                    Rigid-body physics for games, tools and robots, written in Rust: fast, robust, and the same bits on
                    x86-64, ARM, RISC-V and WebAssembly.
                </p>
                <div className={styles.buttons}>
                    <Link className="button button--primary button--lg" to="/docs/guide/getting-started">
                        Get started
                    </Link>
                    <Link className="button button--outline button--primary button--lg" to="/gallery">
                        Gallery
                    </Link>
                </div>
                <Choice label="Scene" options={SCENES} value={scene} choose={setScene} />
                <p className={styles.hint}>The scene is live: drag a body, or drag the background to rotate the camera.</p>
            </div>
            <LiveScene scene={scene} label={`A live scene of the engine: ${scene}`} className={styles.stage} />
        </header>
    );
}

export default function Home(): ReactNode {
    return (
        <Layout description="Rigid-body physics for games, tools and robots, written in Rust.">
            <main className={styles.page}>
                <Hero />
                <section className={styles.install}>
                    <h2>Install</h2>
                    <Install />
                </section>
                <section className={styles.promises}>
                    {PROMISES.map(({ title, text, link }) => (
                        <Link key={title} to={link}>
                            <h2>{title}</h2>
                            <p>{text}</p>
                        </Link>
                    ))}
                </section>
                <section className={styles.pictures}>
                    {PICTURES.map((name) => (
                        <figure key={name}>
                            <MovingPicture picture={MOVING[name]} alt={descriptions[name]} />
                            <figcaption>{descriptions[name]}</figcaption>
                        </figure>
                    ))}
                </section>
                <section className={styles.section}>
                    <h2>Beside its peers</h2>
                    <p>
                        Time of the fastest peer divided by this engine's time. Peers: {PEERS.join(", ")}. {MACHINE} {CONDITIONS}{" "}
                        <Link to="/benchmarks">All figures</Link>
                    </p>
                    <div className={styles.charts}>
                        <LeadChart dimension="3d" />
                        <LeadChart dimension="2d" />
                    </div>
                </section>
            </main>
        </Layout>
    );
}
