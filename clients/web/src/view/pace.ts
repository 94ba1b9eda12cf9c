// How large drafts are: as large as the server draws in time. The picture at rest is sharp again.
import type {Picture} from "../api/client";
import {millisecondsOf} from "./measured";

const wanted = 60;               // ms of the server for a draft
const sizes = [1, 0.7, 0.5];     // of the canvas's pixels along a side
const patience = 4;              // drafts of one size before it changes: each change draws a whole picture
const longer_when_larger = 2.2;  // times, about as many pixels

export class Pace {
  private size = 1;          // so that the first picture comes soon
  private drawn = 0;         // drafts of this size
  private milliseconds = 0;  // of them, newer ones count more

  get ratio() { return sizes[this.size] ?? 1; }

  /** Takes note of a draft that was asked for at `ratio`. The first of a size says nothing: it is drawn whole. */
  note(ratio: number, picture: Picture) {
    if (ratio !== this.ratio || this.drawn++ === 0) return;
    const time = millisecondsOf(picture);
    this.milliseconds = this.drawn === 2 ? time : 0.7 * this.milliseconds + 0.3 * time;
    if (this.drawn < patience) return;
    if (this.milliseconds > wanted) this.resize(1);
    else if (this.milliseconds * longer_when_larger < wanted) this.resize(-1);
  }

  private resize(by: number) {
    const size = Math.min(Math.max(this.size + by, 0), sizes.length - 1);
    if (size !== this.size) this.size = size, this.drawn = 0;
  }
}
