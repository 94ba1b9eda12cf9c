// Procedural brush alphas; this module is loaded when one is chosen.

const side = 64;  // pixels

/** Returns value noise in [0, 1] on a grid of `across` by `down` cells, smoothly interpolated and periodic; deterministic. */
function cells(across: number, down: number): (x: number, y: number) => number {
  const at = (i: number, j: number) => { const s = Math.sin(12.9898 * (i % across) + 78.233 * (j % down) + 0.5) * 43758.5453; return s - Math.floor(s); };
  return (x, y) => {
    const [i, j] = [Math.floor(x * across), Math.floor(y * down)];
    const [u, v] = [x * across - i, y * down - j].map((t) => t * t * (3 - 2 * t)) as [number, number];
    return (at(i, j) * (1 - u) + at(i + 1, j) * u) * (1 - v) + (at(i, j + 1) * (1 - u) + at(i + 1, j + 1) * u) * v;
  };
}
const contrast = (value: number) => Math.min(1, Math.max(0, 3 * (value - 0.5) + 0.5));

const drawn: Record<string, (x: number, y: number) => number> = {
  Streaks: ((noise) => (x: number) => contrast(noise(x, 0)))(cells(14, 1)),
  Grain: ((noise) => (x: number, y: number) => contrast(noise(x, y)))(cells(12, 12)),
  Patches: ((noise) => (x: number, y: number) => contrast(noise(x, y)))(cells(5, 5)),
};

/** Returns an alpha as a PNG. */
export async function pictureOf(name: string): Promise<Blob> {
  const value = drawn[name]!;
  const canvas = new OffscreenCanvas(side, side), context = canvas.getContext("2d")!;
  const image = context.createImageData(side, side);
  for (let k = 0; k < side * side; ++k) {
    const grey = Math.round(255 * value((k % side + 0.5) / side, (Math.floor(k / side) + 0.5) / side));
    image.data.set([grey, grey, grey, 255], 4 * k);
  }
  context.putImageData(image, 0, 0);
  return canvas.convertToBlob({type: "image/png"});
}
