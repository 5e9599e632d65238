// A moving picture with a button that pauses it. The picture stands still where the system reduces motion.

import { type ReactNode, useEffect, useState } from "react";
import styles from "./MovingPicture.module.css";
import type { Moving } from "./moving";

const STILLNESS = "(prefers-reduced-motion: reduce)";

interface MovingPictureProps {
    readonly picture: Moving;
    readonly alt: string;
}

export default function MovingPicture({ picture, alt }: MovingPictureProps): ReactNode {
    const [moves, setMoves] = useState<boolean | null>(null);
    useEffect(() => setMoves(!matchMedia(STILLNESS).matches), []);
    return (
        <div className={styles.frame}>
            <picture>
                {/* The setting is unknown on the server: the browser chooses until the page is active. */}
                {moves === null && <source media={STILLNESS} srcSet={picture.still} />}
                <img src={moves === false ? picture.still : picture.moving} alt={alt} loading="lazy" />
            </picture>
            {moves !== null && (
                <button
                    type="button"
                    className="picture-button"
                    aria-label={`${moves ? "Pause" : "Play"}: ${alt}`}
                    onClick={() => setMoves(!moves)}
                >
                    {moves ? "Pause" : "Play"}
                </button>
            )}
        </div>
    );
}
