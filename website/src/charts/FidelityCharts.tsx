// Relative errors over the rate of steps: a chart for each law.

import Link from "@docusaurus/Link";
import type { ReactNode } from "react";
import data from "@site/generated/data/fidelity.json";
import Legend from "./Legend";
import LogPlot, { type Curve, write } from "./LogPlot";
import styles from "./charts.module.css";

const BUILDS = [
    { name: "2D f32", colour: "var(--engine-box)" },
    { name: "2D f64", colour: "var(--engine-rapier)" },
    { name: "3D f32", colour: "var(--engine-own)" },
    { name: "3D f64", colour: "var(--engine-double)" },
] as const;

/** Errors (%) below the last digit of the tables. */
const ERROR_MIN = 1e-4;

type Law = (typeof data)[number];

/** A law of a page: several laws may have one title, in different areas. */
function keyOf({ page, title }: Law): string {
    return `${page} ${title}`;
}

function curvesOf(law: Law): Curve[] {
    return BUILDS.map(({ name, colour }) => {
        const points = law.errors
            .filter(({ build, rate }) => build === name && rate !== null)
            .map(({ rate, error }) => ({
                x: Number(rate),
                y: Math.max(error, ERROR_MIN),
                note: `${name}, ${rate} Hz: ${error < ERROR_MIN ? `below ${ERROR_MIN}` : write(error)} %`,
            }));
        return { name, colour, points };
    }).filter(({ points }) => points.length > 0);
}

function Chart({ law }: { readonly law: Law }): ReactNode {
    return (
        <figure className={styles.small}>
            <figcaption>
                <Link to={`/docs/fidelity/${law.page}`}>{law.title}</Link>: {law.quantity}
            </figcaption>
            <LogPlot
                curves={curvesOf(law)}
                label={`${law.title}: error in percent at 30, 60 and 240 steps a second`}
                x="steps a second"
                y="error (%)"
                width={400}
                height={260}
                columns={[30, 60, 240]}
            />
        </figure>
    );
}

export default function FidelityCharts(): ReactNode {
    return (
        <>
            <Legend entries={BUILDS} />
            <div className={styles.multiples}>
                {data.map((law) => (
                    <Chart key={keyOf(law)} law={law} />
                ))}
            </div>
        </>
    );
}
