// A stroke in progress. Its samples are sent to the server in parts, one request at a time, as one undo step. They go to
// the scene on which the stroke began, whichever is open meanwhile; the stroke ends if that scene gets another model.
import {Refusal} from "../api/client";
import {send} from "../api/outbox";
import type {Command, CommandAnswer, Pinhole} from "../api/types";
import {mark} from "../scene/marks";
import {sayError} from "../scene/messages";
import {accept, isOpen, model_id, scene} from "../scene/session";

export interface StrokeSample { screen: [number, number]; pressure: number; time: number }
export interface StrokeView { camera: Pinhole; width: number; height: number }

const max_samples = 9000;  // the contract allows 10000 for a stroke
let serial = 0;

export class Stroke {
  private readonly scene = scene.value?.id ?? "";
  private readonly model = model_id.value;
  private id = "";
  private part = 0;
  private count = 0;
  private waiting: StrokeSample[] = [];
  private last_sent: StrokeSample | null = null;
  private newest = 0;  // time of the newest sample, in ms since the page started
  private sending = false;
  private ended = false;

  /** `command` has tool, settings and brush. Calls `sent` for each part, and `answered` with its answer, or with null if the
   * stroke failed. */
  constructor(private readonly command: Command, private readonly view: StrokeView, private readonly page: string,
              private readonly sent: () => void, private readonly answered: (answer: CommandAnswer | null, last: boolean) => void) {
    this.begin();
  }

  add(samples: StrokeSample[]) {
    this.newest = performance.now();
    this.waiting.push(...samples);
    void this.sendWaiting();
  }

  /** Ends the stroke. The remaining samples go to the outbox at once, which stores them in case the page is closed. */
  end() {
    this.ended = true;
    const samples = this.nextSamples();
    if (samples.length) void this.sendPart(samples, this.waiting.length === 0);
    if (this.waiting.length) void this.sendWaiting();
  }

  private begin() {
    this.id = `${this.page}-${++serial}`;
    this.part = 0;
    this.count = 0;
  }

  /** Takes the samples to send. Keeps back the newest one until the stroke ends, so that the last part is never empty. */
  private nextSamples(): StrokeSample[] {
    return this.waiting.splice(0, Math.min(max_samples, this.waiting.length - (this.ended ? 0 : 1)));
  }

  private async sendWaiting() {
    if (this.sending) return;
    this.sending = true;
    for (let done = false; !done;) {
      const samples = this.nextSamples();
      if (samples.length === 0) break;
      done = this.ended && this.waiting.length === 0;
      await this.sendPart(samples, done);
    }
    this.sending = false;
  }

  private async sendPart(samples: StrokeSample[], last: boolean) {
    const open = isOpen(this.scene);
    if (open && model_id.value !== this.model) return this.abandon();
    if (this.count + samples.length > max_samples) this.begin();
    const start = performance.now(), newest = this.newest, part = this.part++;
    try {
      const answer = send(this.scene, "commands", this.bodyOf(samples, last, part));
      this.count += samples.length;
      if (open) this.sent();
      this.note(await answer, samples, last);
      mark("part", {start, end: performance.now(), newest, revision: (await answer).revision});
    } catch (error) {
      await this.recover(error, samples, last, part);
    }
  }

  private bodyOf(samples: StrokeSample[], last: boolean, part: number): Command {
    return {...this.command, stroke: {id: this.id, part, last, view: this.view, samples}};
  }

  private note(answer: CommandAnswer, samples: StrokeSample[], last: boolean) {
    this.last_sent = samples[samples.length - 1]!;
    if (isOpen(this.scene)) accept(answer);
    this.answered(answer, last);
  }

  private abandon() {
    this.answered(null, true);
    this.waiting = [];
    this.ended = true;
  }

  /** Handles a failed part. If another user's edit or a restart of the server ended the stroke on the server, continues it
   * as a new stroke; else shows the error and gives up. */
  private async recover(error: unknown, samples: StrokeSample[], last: boolean, part: number) {
    const interrupted = error instanceof Refusal && part > 0 && [409, 422].includes(error.status) && /\/stroke/.test(error.problem.pointer ?? "");
    if (!interrupted) {
      sayError(error);
      return this.abandon();
    }
    const joined = this.last_sent ? [this.last_sent, ...samples] : samples;
    this.last_sent = samples[samples.length - 1]!;
    this.begin();
    await this.sendPart(joined, last);
  }
}
