// Chooses the size of drafts: the largest that the server draws in time. The picture at rest has full resolution.
import type {Picture} from "../api/client";
import {millisecondsOf} from "./measured";

const target_ms = 60;            // the server's time for a draft, in ms
const sizes = [1, 0.7, 0.5];     // factors for the canvas's side
const min_drafts = 4;            // drafts of one size before it may change; each change draws a whole picture
const longer_when_larger = 2.2;  // factor of time for the next larger size, about that of the pixels

export class Pace {
  private size = 1;          // index into sizes; starts small, so that the first picture comes soon
  private drawn = 0;         // number of drafts of this size
  private milliseconds = 0;  // moving average of their times

  get ratio() { return sizes[this.size] ?? 1; }

  /** Records a draft that was requested at `ratio`. Ignores the first one of a size, because it is drawn whole. */
  note(ratio: number, picture: Picture) {
    if (ratio !== this.ratio || this.drawn++ === 0) return;
    const time = millisecondsOf(picture);
    this.milliseconds = this.drawn === 2 ? time : 0.7 * this.milliseconds + 0.3 * time;
    if (this.drawn < min_drafts) return;
    if (this.milliseconds > target_ms) this.resize(1);
    else if (this.milliseconds * longer_when_larger < target_ms) this.resize(-1);
  }

  private resize(by: number) {
    const size = Math.min(Math.max(this.size + by, 0), sizes.length - 1);
    if (size !== this.size) this.size = size, this.drawn = 0;
  }
}
