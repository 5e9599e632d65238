// Time of a step over the number of bodies, on logarithmic axes.

import { type ReactNode, useState } from "react";
import data from "@site/generated/data/growth.json";
import Choice from "./Choice";
import { colour } from "./engines";
import Legend from "./Legend";
import LogPlot, { type Curve, write } from "./LogPlot";
import styles from "./charts.module.css";

/** The worlds whose horizontal axis is the number of bodies. */
const WORLDS = data.filter(({ title }) => /^(Bodies that are awake|Fixed bodies|Sleeping bodies)/.test(title));

function curvesOf(rows: (typeof WORLDS)[number]["rows"]): Curve[] {
    const engines = [...new Set(rows.map(({ engine }) => engine))];
    return engines.map((engine) => ({
        name: engine,
        colour: colour(engine),
        points: rows.flatMap((row) =>
            row.engine !== engine || row.bodies === null || row.time === null
                ? []
                : [{ x: row.bodies, y: row.time, note: `${engine}, ${write(row.bodies)} bodies: ${write(row.time)} ms` }],
        ),
    }));
}

export default function GrowthChart(): ReactNode {
    const [title, setTitle] = useState(WORLDS[0].title);
    const world = WORLDS.find((candidate) => candidate.title === title) ?? WORLDS[0];
    const curves = curvesOf(world.rows);
    return (
        <>
            <div className={styles.choices}>
                <Choice
                    label="World"
                    options={WORLDS.map((each) => [each.title, each.title] as const)}
                    value={title}
                    choose={setTitle}
                />
            </div>
            <p>{world.note}</p>
            <Legend entries={curves} />
            <LogPlot curves={curves} label="Milliseconds per step over the number of bodies" x="bodies" y="ms per step" />
        </>
    );
}
