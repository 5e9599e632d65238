// Finds pictures of a page that are squashed, cut, empty or of one colour.

/** Relative difference of aspect ratios that the eye does not notice. */
const RATIO_TOLERANCE = 0.03;
/** Pixels by which a picture may leave its frame: rounding. */
const CUT_TOLERANCE = 2;
/** Time for lazy pictures (ms): the gallery has 120, and other pages load beside it. */
const LOADING_TIME = 60_000;

/** Runs in the page. Returns a message for each faulty picture. */
async function faults({ ratioTolerance, cutTolerance, loadingTime }) {
    const loaded = (image) => {
        image.loading = "eager";
        const late = new Promise((resolve) => setTimeout(resolve, loadingTime));
        return image.complete ? null : Promise.race([late, new Promise((resolve) => (image.onload = image.onerror = resolve))]);
    };
    const isPlain = (image) => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [24, 24];
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0, 24, 24);
        return new Set(new Uint32Array(context.getImageData(0, 0, 24, 24).data.buffer)).size < 4;
    };
    /** Pixels outside of the nearest frame that hides them. A frame that scrolls hides nothing. */
    const cut = (image, box) => {
        for (let frame = image.parentElement; frame !== null; frame = frame.parentElement) {
            const { overflowX } = getComputedStyle(frame);
            if (overflowX === "visible") continue;
            const { left, right } = frame.getBoundingClientRect();
            return overflowX === "hidden" || overflowX === "clip" ? Math.max(left - box.left, box.right - right) : 0;
        }
        return 0;
    };
    const fault = (image) => {
        const { naturalWidth, naturalHeight } = image;
        if (naturalWidth === 0) return "is empty";
        const box = image.getBoundingClientRect();
        const { objectFit, paddingLeft, paddingTop, filter } = getComputedStyle(image);
        // Invisible in this theme, or the blurred cover of a scene that loads.
        if (box.width === 0 || filter.includes("blur")) return null;
        const [width, height] = [image.clientWidth - 2 * parseFloat(paddingLeft), image.clientHeight - 2 * parseFloat(paddingTop)];
        const ratio = width / height / (naturalWidth / naturalHeight);
        if (Math.abs(ratio - 1) > ratioTolerance && objectFit !== "contain")
            return `${objectFit === "cover" ? "is cut" : "is squashed"}: ${width.toFixed()}×${height.toFixed()} of ${naturalWidth}×${naturalHeight}`;
        if (cut(image, box) > cutTolerance) return `is cut by ${cut(image, box).toFixed()} pixels`;
        return isPlain(image) ? "has one colour" : null;
    };
    const images = [...document.images];
    await Promise.all(images.map(loaded));
    return images.flatMap((image) => {
        const found = fault(image);
        return found === null ? [] : [`the picture ${image.currentSrc || image.src} ${found}`];
    });
}

export async function checkPictures(page, fail) {
    const limits = { ratioTolerance: RATIO_TOLERANCE, cutTolerance: CUT_TOLERANCE, loadingTime: LOADING_TIME };
    for (const message of await page.evaluate(faults, limits)) fail(message);
}
