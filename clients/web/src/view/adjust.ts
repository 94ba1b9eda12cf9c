// Radius and strength set in the picture: a key is held and the pointer goes sideways.
import {signal} from "@preact/signals";
import {brush, brushScale, setBrush} from "../tools/state";

export type Adjusted = "radius" | "strength";
/** What the held key sets; null while none is held. */
export const adjusting = signal<Adjusted | null>(null);

const full_strength = 240;  // pixels from none to all
const min_pixels = 3;

/** From the moment that the key went down until it is up. The ring stays where the pointer was then. */
export class Adjustment {
  private readonly value: number;
  private readonly start: number;
  private readonly scale: number;

  /** `at` is the pointer, `units_per_pixel` the model's unit that a pixel covers there. */
  constructor(private readonly what: Adjusted, readonly at: [number, number], units_per_pixel: number) {
    this.value = Number(brush.value[what]);
    this.scale = brushScale(units_per_pixel);
    this.start = at[0];
  }

  move(x: number) {
    const by = x - this.start;
    const number = this.what === "radius" ? Math.max(min_pixels / this.scale, this.value + by / this.scale) : Math.max(0, Math.min(1, this.value + by / full_strength));
    setBrush(this.what, Number(number.toPrecision(3)));
  }
}
