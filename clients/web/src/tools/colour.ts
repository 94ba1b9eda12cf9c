// Converts the contract's colours, which are `#rrggbb` or three linear numbers.
const encode = (linear: number) => (linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055);
const two = (value: number) => Math.round(255 * Math.min(1, Math.max(0, value))).toString(16).padStart(2, "0");

/** Returns either form as "#rrggbb"; white for anything else. */
export function toHex(colour: unknown): string {
  if (typeof colour === "string" && /^#[0-9a-f]{6}$/i.test(colour)) return colour.toLowerCase();
  if (Array.isArray(colour) && colour.length === 3) return "#" + colour.map((part) => two(encode(Number(part)))).join("");
  return "#ffffff";
}

const decode = (encoded: number) => (encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4));

/** Returns either form as linear red, green and blue. */
export function toLinear(colour: unknown): [number, number, number] {
  if (Array.isArray(colour) && colour.length === 3) return [Number(colour[0]), Number(colour[1]), Number(colour[2])];
  const hex = toHex(colour);
  const part = (at: number) => decode(parseInt(hex.slice(at, at + 2), 16) / 255);
  return [part(1), part(3), part(5)];
}

/** All members are in [0, 1]. Grey has hue 0. */
export interface Hsv { hue: number; saturation: number; brightness: number }

export function toHsv(hex: string): Hsv {
  const [r, g, b] = [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255) as [number, number, number];
  const high = Math.max(r, g, b), range = high - Math.min(r, g, b);
  const hue_sextant = range === 0 ? 0 : high === r ? ((g - b) / range + 6) % 6 : high === g ? (b - r) / range + 2 : (r - g) / range + 4;
  return {hue: hue_sextant / 6, saturation: high === 0 ? 0 : range / high, brightness: high};
}

export function fromHsv({hue, saturation, brightness}: Hsv): string {
  const part = (shift: number) => {
    const at = (shift + hue * 6) % 6;
    return brightness * (1 - saturation * Math.max(0, Math.min(at, 4 - at, 1)));
  };
  return "#" + [5, 3, 1].map((shift) => two(part(shift))).join("");
}
