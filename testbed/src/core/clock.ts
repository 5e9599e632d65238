// Turns the time of frames into whole steps.

/** Steps of one frame at most: a slow scene slows down instead of freezing the page. */
const STEPS_MAX = 4;

export class Clock {
    running = true;
    /** Simulated seconds per second. */
    speed = 1;
    private pending = 0;
    private requested = 0;

    /** Requests one step, also while the clock is paused. */
    stepOnce(): void {
        this.running = false;
        this.requested += 1;
    }

    reset(): void {
        this.pending = 0;
        this.requested = 0;
    }

    /** The number of steps for a frame of `seconds`. */
    take(seconds: number, timestep: number): number {
        if (!this.running) {
            const steps = this.requested;
            this.requested = 0;
            this.pending = timestep;
            return steps;
        }
        // A display at 59.9 Hz would skip a step now and then without this tolerance.
        this.pending += Math.min(seconds, 0.25) * this.speed;
        const steps = Math.min(STEPS_MAX, Math.floor(this.pending / timestep + 0.02));
        this.pending = steps === STEPS_MAX ? 0 : Math.max(0, this.pending - steps * timestep);
        return steps;
    }

    /** The fraction of the last step that the picture shows, for interpolation. */
    fraction(timestep: number): number {
        if (this.speed >= 1 || !this.running) return 1;
        return Math.min(1, this.pending / timestep);
    }
}
