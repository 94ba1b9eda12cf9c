// A stroke under way: its samples go to the server in parts, one request at a time, as one undo step. They go to the scene that it
// began on, whichever is open meanwhile, and end where that scene gets another model.
import {Refusal} from "../api/client";
import {send} from "../api/outbox";
import type {Command, CommandAnswer, Pinhole} from "../api/types";
import {mark} from "../scene/marks";
import {sayError} from "../scene/messages";
import {accept, isOpen, model_id, scene} from "../scene/session";

export interface StrokeSample { screen: [number, number]; pressure: number; time: number }
export interface StrokeView { camera: Pinhole; width: number; height: number }

const max_samples = 9000;  // the contract takes 10000 a stroke
let serial = 0;

export class Stroke {
  private readonly scene = scene.value?.id ?? "";
  private readonly model = model_id.value;
  private id = "";
  private part = 0;
  private count = 0;
  private waiting: StrokeSample[] = [];
  private last_sent: StrokeSample | null = null;
  private newest = 0;  // when the newest sample was seen, ms of the page
  private sending = false;
  private ended = false;

  /** `command` has tool, settings and brush. `sent` is called with each part, `answered` with what became of it. */
  constructor(private readonly command: Command, private readonly view: StrokeView, private readonly page: string,
              private readonly sent: () => void, private readonly answered: (answer: CommandAnswer | null, last: boolean) => void) {
    this.begin();
  }

  add(samples: StrokeSample[]) {
    this.newest = performance.now();
    this.waiting.push(...samples);
    void this.work();
  }

  /** What is left goes to the outbox at once, which keeps it if the page is closed. */
  end() {
    this.ended = true;
    const samples = this.nextSamples();
    if (samples.length) void this.sendPart(samples, this.waiting.length === 0);
    if (this.waiting.length) void this.work();
  }

  private begin() {
    this.id = `${this.page}-${++serial}`;
    this.part = 0;
    this.count = 0;
  }

  /** The newest sample waits for the next one, so that the last part has one to send. */
  private nextSamples(): StrokeSample[] {
    return this.waiting.splice(0, Math.min(max_samples, this.waiting.length - (this.ended ? 0 : 1)));
  }

  private async work() {
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
      await this.mend(error, samples, last, part);
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

  /** Somebody else's edit, or a restart of the server, ends a live stroke: what is left goes on as a new one. */
  private async mend(error: unknown, samples: StrokeSample[], last: boolean, part: number) {
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
