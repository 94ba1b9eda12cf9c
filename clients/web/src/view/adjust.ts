// Sets the brush's radius or strength in the picture, by moving the pointer sideways while a key is held.
import {signal} from "@preact/signals";
import {brush, brushScale, setBrush} from "../tools/state";

export type Adjusted = "radius" | "strength";
/** The value that the held key sets; null while none is held. */
export const adjusting = signal<Adjusted | null>(null);

const full_strength = 240;  // pixels for a change of strength from 0 to 1
const min_pixels = 3;

/** One adjustment, from key down to key up. The ring stays where the pointer was at key down. */
export class Adjustment {
  private readonly value: number;
  private readonly start: number;
  private readonly scale: number;

  /** `at` is the pointer's position; a pixel covers `units_per_pixel` model units there. */
  constructor(private readonly property: Adjusted, readonly at: [number, number], units_per_pixel: number) {
    this.value = Number(brush.value[property]);
    this.scale = brushScale(units_per_pixel);
    this.start = at[0];
  }

  move(x: number) {
    const by = x - this.start;
    const number = this.property === "radius" ? Math.max(min_pixels / this.scale, this.value + by / this.scale) : Math.max(0, Math.min(1, this.value + by / full_strength));
    setBrush(this.property, Number(number.toPrecision(3)));
  }
}
