// Relative errors over the rate of steps: a chart for each law.

import Link from "@docusaurus/Link";
import type { ReactNode } from "react";
import data from "@site/generated/data/fidelity.json";
import Legend from "./Legend";
import LogPlot, { type Curve, write } from "./LogPlot";
import styles from "./charts.module.css";

const BUILDS = [
    { name: "2D f32", colour: "var(--build-2d-f32)", dashes: "2 4" },
    { name: "2D f64", colour: "var(--build-2d-f64)", dashes: "6 4" },
    { name: "3D f32", colour: "var(--build-3d-f32)", dashes: "12 5" },
    { name: "3D f64", colour: "var(--build-3d-f64)", dashes: "1 0" },
] as const;

type Law = (typeof data)[number];

/** A law of a page: several laws may have one title, in different areas. */
function keyOf({ page, title }: Law): string {
    return `${page} ${title}`;
}

function curvesOf(law: Law): Curve[] {
    return BUILDS.map((build) => {
        const points = law.errors
            .filter(({ build: name, rate }) => name === build.name && rate !== null)
            .map(({ rate, error, resolution }) => ({
                x: Number(rate),
                y: Math.max(error, resolution),
                note: `${build.name}, ${rate} Hz: ${error < resolution ? `below ${write(resolution)}` : write(error)} %`,
            }));
        return { ...build, points };
    }).filter(({ points }) => points.length > 0);
}

/** The rates of a law, for the marks of its axis. */
function ratesOf(law: Law): number[] {
    return [...new Set(law.errors.map(({ rate }) => Number(rate)))].sort((a, b) => a - b);
}

function Chart({ law }: { readonly law: Law }): ReactNode {
    return (
        <figure className={styles.small}>
            <figcaption>
                <Link to={`/docs/fidelity/${law.page}`}>{law.title}</Link>: {law.quantity}
            </figcaption>
            <LogPlot
                curves={curvesOf(law)}
                label={`${law.title}: largest error in percent at ${ratesOf(law).join(", ")} steps a second`}
                x="steps a second"
                y="error (%)"
                width={400}
                height={260}
                columns={ratesOf(law)}
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
