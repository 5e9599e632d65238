// First frames of animated PNGs: the default image without the chunks of the animation.

/** Length of a PNG's signature in bytes. */
const SIGNATURE = 8;
/** Bytes of a chunk beside its data: length, type, checksum. */
const CHUNK = 12;
const ANIMATION = new Set(["acTL", "fcTL", "fdAT"]);

/** Returns the first frame of an animated PNG as a PNG. */
export function firstFrame(png) {
    const kept = [png.subarray(0, SIGNATURE)];
    for (let start = SIGNATURE; start < png.length; ) {
        const end = start + CHUNK + png.readUInt32BE(start);
        if (!ANIMATION.has(png.toString("latin1", start + 4, start + 8))) kept.push(png.subarray(start, end));
        start = end;
    }
    return Buffer.concat(kept);
}
