// A live scene that replaces the button which started it.

import { type ReactNode, useEffect, useRef } from "react";
import LiveScene from "./LiveScene";
import styles from "./LiveInPlace.module.css";

interface LiveInPlaceProps {
    readonly scene: string;
    readonly label: string;
}

export default function LiveInPlace({ scene, label }: LiveInPlaceProps): ReactNode {
    const group = useRef<HTMLDivElement>(null);
    // The pressed button has vanished: the scene takes its focus.
    useEffect(() => group.current?.focus({ preventScroll: true }), []);
    return (
        <div ref={group} role="group" aria-label="Live scene" tabIndex={-1}>
            <LiveScene scene={scene} label={label} className={styles.live} />
        </div>
    );
}
