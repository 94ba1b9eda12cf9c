// Turns pointer input on the model into commands of the current tool. Each kind of interaction has its own class.
import {page_id} from "../api/identity";
import type {Command, CommandAnswer, Op, Vector} from "../api/types";
import {refresh, run} from "../scene/session";
import {pinholeOf, type Orbit, type Projection} from "../view/camera";
import type {Hit} from "../view/proxy";
import {add, scale, subtract, unit} from "../view/vector";
import {placeGuide} from "./guides";
import {brushOf, commandOf, inverting, steadiness, worldRadius} from "./state";
import {Stroke, type StrokeSample} from "./stroke";

/** A press on the model: `hit` is the point on the fur, `skin` the point on the skin below it, if any. */
export interface Press { hit: Hit; skin: Hit | null; projection: Projection; orbit: Orbit; time: number }
export interface HandOptions { sent: () => void; changed: () => void }

/** A tool between pointer down and up. */
export interface Hold {
  move(events: PointerEvent[], projection: Projection): void;
  up(cancelled: boolean): void;
  /** Returns a polyline, in the model's coordinates, to draw over the picture meanwhile. */
  line(): Vector[];
}

const min_step = 1.5;  // pixels between samples

const sampleOf = (event: PointerEvent, start: number): StrokeSample => ({
  screen: [event.offsetX, event.offsetY],
  pressure: event.pointerType === "pen" ? Math.max(0.02, event.pressure) : 1,
  time: Math.max(0, (event.timeStamp - start) / 1000),
});

const max_rope_pixels = 70;  // length at full steadiness, in pixels

/** Steadies strokes: the brush is pulled on a rope, so that movements shorter than the rope have no effect. */
class SteadyHand {
  private at: [number, number];
  constructor(start: [number, number], private readonly length: number) { this.at = start; }

  follow(to: [number, number]): [number, number] {
    const [x, y] = [to[0] - this.at[0], to[1] - this.at[1]], far = Math.hypot(x, y);
    if (far > this.length) this.at = [this.at[0] + x * (1 - this.length / far), this.at[1] + y * (1 - this.length / far)];
    return this.at;
  }
}

class BrushHold implements Hold {
  private readonly stroke: Stroke;
  private readonly steady: SteadyHand;
  private readonly start: number;
  private last: StrokeSample;

  constructor(event: PointerEvent, press: Press, command: Command, options: HandOptions) {
    const {width, height} = press.projection;
    const view = {camera: pinholeOf(press.orbit), width: Math.round(width), height: Math.round(height)};
    const answered = (answer: CommandAnswer | null, last: boolean) => {
      if (answer) options.changed();
      if (last) void refresh();
    };
    this.stroke = new Stroke(command, view, page_id, options.sent, answered);
    this.start = event.timeStamp;
    this.last = sampleOf(event, this.start);
    this.steady = new SteadyHand(this.last.screen, steadiness.value * max_rope_pixels);
    this.stroke.add([this.last]);
  }

  move(events: PointerEvent[]) {
    const fresh: StrokeSample[] = [];
    for (const event of events) {
      const seen = sampleOf(event, this.start), sample = {...seen, screen: this.steady.follow(seen.screen)};
      const step = Math.hypot(sample.screen[0] - this.last.screen[0], sample.screen[1] - this.last.screen[1]);
      if (step < min_step || sample.time < this.last.time) continue;
      fresh.push(sample);
      this.last = sample;
    }
    if (fresh.length) this.stroke.add(fresh);
  }

  up() { this.stroke.end(); }
  line(): Vector[] { return []; }
}

/** The pull tool: the attractor is where the pointer is released, at the fur's distance from the camera. */
class PullHold implements Hold {
  private point: Vector;
  constructor(private readonly press: Press, private readonly options: HandOptions) {
    this.point = add(press.hit.point, scale(press.hit.normal, this.radius() * 0.5));
  }

  private radius() { return worldRadius(this.press.projection.unitsPerPixel(this.press.hit.point)); }

  move(events: PointerEvent[], projection: Projection) {
    const event = events[events.length - 1]!;
    const ray = projection.ray(event.offsetX, event.offsetY);
    this.point = add(ray.origin, scale(ray.direction, projection.distanceTo(this.press.hit.point)));
  }

  up(cancelled: boolean) {
    if (cancelled) return;
    const reach = this.radius() + Math.hypot(...subtract(this.point, this.press.hit.point));
    void run(commandOf("attract", {point: this.point, radius: reach, units: "world"})).then(this.options.changed);
  }

  line(): Vector[] { return [this.press.hit.point, this.point]; }
}

/** The guide tools: the line drawn on the skin becomes a guide, or a key with its direction. */
class GuideHold implements Hold {
  private readonly points: Vector[];
  constructor(private readonly op: "flow" | "interpolate", press: Press, private readonly skinAt: (x: number, y: number) => Hit | null,
              private readonly options: HandOptions) {
    this.points = press.skin ? [press.skin.point] : [];
  }

  move(events: PointerEvent[]) {
    const event = events[events.length - 1]!;
    const hit = this.skinAt(event.offsetX, event.offsetY);
    if (hit) this.points.push(hit.point);
  }

  up(cancelled: boolean) {
    if (!cancelled && this.points.length > 1) void placeGuide(this.op, this.points).then(this.options.changed);
  }

  line(): Vector[] { return this.points; }
}

/** Returns a `blow` command whose source is half-way between camera and press, and a little above. */
function blowCommand(press: Press): Command {
  const ray = subtract(press.hit.point, pinholeOf(press.orbit).position);
  const back = scale(unit(ray), -0.5 * Math.hypot(...ray));
  const source = add(add(press.hit.point, back), scale([0, 1, 0], 0.12 * Math.hypot(...ray)));
  return commandOf("blow", {source, direction: subtract(press.hit.point, source)});
}

export function beginHold(op: Op, event: PointerEvent, press: Press, skinAt: (x: number, y: number) => Hit | null, options: HandOptions): Hold {
  if (op === "attract") return new PullHold(press, options);
  if (op === "flow" || op === "interpolate") return new GuideHold(op, press, skinAt, options);
  const command = op === "blow" ? blowCommand(press) : commandOf(op);
  return new BrushHold(event, press, {...command, brush: brushOf(op, inverting.value)}, options);
}
