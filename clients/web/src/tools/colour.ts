// Colours of the contract, `#rrggbb` or linear numbers, as a browser's colour field has them.
const encode = (linear: number) => (linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055);
const two = (value: number) => Math.round(255 * Math.min(1, Math.max(0, value))).toString(16).padStart(2, "0");

/** "#rrggbb" of either form; white of anything else. */
export function toHex(colour: unknown): string {
  if (typeof colour === "string" && /^#[0-9a-f]{6}$/i.test(colour)) return colour.toLowerCase();
  if (Array.isArray(colour) && colour.length === 3) return "#" + colour.map((part) => two(encode(Number(part)))).join("");
  return "#ffffff";
}
