// The difference of two pictures of the same size, pixel by pixel, in sRGB values.

export interface Difference {
  /** A picture of the difference, from dark violet (none) to yellow (`full_scale` and more). */
  map: Blob;
  /** Mean over the pixels that the model covers and over the colour channels; 1 is black against white. */
  mean: number;
  largest: number;
}

export const full_scale = 0.25;
export const ground = 142;  // 8-bit grey behind transparent pixels

// Stops of a colour scale whose lightness rises all along, so that it is readable without colour, too.
const scale = [[13, 8, 42], [84, 15, 109], [187, 55, 84], [249, 140, 10], [252, 255, 164]] as const;

export function colourOf(share: number): [number, number, number] {
  const at = Math.min(1, Math.max(0, share)) * (scale.length - 1);
  const from = scale[Math.min(Math.floor(at), scale.length - 2)]!, to = scale[Math.min(Math.floor(at), scale.length - 2) + 1]!;
  const t = at - Math.min(Math.floor(at), scale.length - 2);
  return [0, 1, 2].map((k) => from[k]! + (to[k]! - from[k]!) * t) as [number, number, number];
}

async function pixelsOf(bytes: Blob): Promise<ImageData> {
  const bitmap = await createImageBitmap(bytes);
  const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d", {willReadFrequently: true})!;
  pen.drawImage(bitmap, 0, 0);
  return pen.getImageData(0, 0, bitmap.width, bitmap.height);
}

/** Compares two pictures, which must be transparent where there is no model. */
export async function differenceOf(one: Blob, other: Blob): Promise<Difference> {
  const [a, b] = await Promise.all([pixelsOf(one), pixelsOf(other)]);
  if (a.width !== b.width || a.height !== b.height) throw new Error("the pictures have different sizes");
  const canvas = new OffscreenCanvas(a.width, a.height);
  const pen = canvas.getContext("2d")!;
  const out = pen.createImageData(a.width, a.height);
  let sum = 0, covered = 0, largest = 0;
  for (let at = 0; at < a.data.length; at += 4) {
    const cover = a.data[at + 3]!, other_cover = b.data[at + 3]!;
    let difference = 0;
    for (let k = 0; k < 3; ++k) {
      const composited = (a.data[at + k]! * cover + ground * (255 - cover)) / 255;
      difference += Math.abs(composited - (b.data[at + k]! * other_cover + ground * (255 - other_cover)) / 255);
    }
    difference /= 3 * 255;
    if (cover || other_cover) { sum += difference; ++covered; }
    largest = Math.max(largest, difference);
    out.data.set([...colourOf(difference / full_scale), 255], at);
  }
  pen.putImageData(out, 0, 0);
  return {map: await canvas.convertToBlob({type: "image/png"}), mean: covered ? sum / covered : 0, largest};
}
