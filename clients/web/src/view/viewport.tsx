// The picture, the brush over it and what the pointer does. The picture comes from the server; all else is drawn here.
import {effect, signal, untracked, useSignal} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {isOpen, model_id, revision, scene, settings, shown_model} from "../scene/session";
import {trial} from "../scene/trial";
import {mark} from "../scene/marks";
import {sayError} from "../scene/messages";
import {brush, in_hand, worldRadius} from "../tools/state";
import {takeUp, type Hold} from "../tools/hand";
import {orbit, pinholeOf, Projection} from "./camera";
import {Badge} from "./badge";
import {playing} from "./clock";
import {Compare} from "./compare";
import {compared} from "./compared";
import {FirstPicture} from "./first_picture";
import {FrameLoop} from "./frames";
import {GuideHandles} from "./guide_handles";
import {Gizmos} from "./gizmos";
import {HandHints} from "./hand_hints";
import {mirrored} from "./mirror";
import {Navigation} from "./navigation";
import type {Hit, Proxy} from "./proxy";
import {dial, rest_quality, shared_request} from "./quality";
import {drawRing} from "./ring";
import {drawLine, drawPlanes} from "./sketch";
import {ViewCube} from "./view_cube";
import {moveTo} from "./views";

/** Where the pointer is on the model; null beside it. */
export const hover = signal<Hit | null>(null);
/** Size of the picture, CSS pixels. */
export const viewport_size = signal({width: 1, height: 1});
export const proxy = signal<Proxy | null>(null);
/** Whether the next press on the model is taken by a panel that asked for a place. */
export const place_request = signal<{says: string; take: (hit: Hit) => void} | null>(null);

const max_ratio = 2;

/** Everything that lives as long as the viewport is on the page. */
class View {
  readonly frames: FrameLoop;
  private readonly navigation: Navigation;
  private readonly picture: ImageBitmapRenderingContext;
  private readonly pen: CanvasRenderingContext2D;
  private hold: Hold | null = null;
  private pointer: [number, number] | null = null;
  private redraw = 0;

  constructor(box: HTMLElement, picture: HTMLCanvasElement, private readonly sketch: HTMLCanvasElement) {
    this.picture = picture.getContext("bitmaprenderer")!;
    this.pen = sketch.getContext("2d")!;
    this.frames = new FrameLoop(() => this.wish(), (bitmap) => this.present(bitmap));
    this.navigation = new Navigation(box, {
      size: () => scene.value?.size ?? 1,
      height: () => viewport_size.value.height,
      hits: (x, y) => this.cast(x, y) !== null,
      changed: () => { this.frames.touch({turning: true}); this.sketchSoon(); },
      toolDown: (event) => this.toolDown(event),
      toolMove: (events) => this.toolMove(events),
      toolUp: (_, cancelled) => { this.hold?.up(cancelled); this.hold = null; this.sketchSoon(); },
      hover: (event) => { this.pointer = event ? [event.offsetX, event.offsetY] : null; this.sketchSoon(); },
    });
  }

  stop() {
    this.frames.stop();
    this.navigation.stop();
    cancelAnimationFrame(this.redraw);
  }

  private wish() {
    if (!scene.value) return null;
    const {width, height} = viewport_size.value;
    const ratio = Math.min(devicePixelRatio || 1, max_ratio);
    const drawn = trial.value ?? {scene: scene.value.id, revision: revision.value};
    return {...drawn, camera: pinholeOf(orbit.value), width, height, ratio};
  }

  private present(bitmap: ImageBitmap) {
    const {canvas} = this.picture;
    if (canvas.width !== bitmap.width) canvas.width = bitmap.width;
    if (canvas.height !== bitmap.height) canvas.height = bitmap.height;
    this.picture.transferFromImageBitmap(bitmap);
  }

  /** Another scene or model comes: nothing of the one before is seen, and a stroke on it ends there. */
  forget() {
    this.hold?.up(true);
    this.hold = null;
    this.frames.forget();
    this.picture.transferFromImageBitmap(null);
  }

  projection() { return new Projection(orbit.value, viewport_size.value.width, viewport_size.value.height); }

  cast(x: number, y: number): Hit | null {
    const ray = this.projection().ray(x, y);
    return proxy.value?.cast(ray.origin, ray.direction) ?? null;
  }

  private toolDown(event: PointerEvent) {
    const hit = this.cast(event.offsetX, event.offsetY);
    if (!hit) return;
    if (place_request.value) {
      const request = place_request.value;
      place_request.value = null;
      return request.take(hit);
    }
    this.pointer = [event.offsetX, event.offsetY];
    const press = {hit, projection: this.projection(), orbit: orbit.value, time: event.timeStamp};
    this.hold = takeUp(in_hand.value, event, press, (x, y) => this.cast(x, y), {
      sent: () => this.frames.touch({moving: true, news: true}),
      changed: () => this.frames.touch({moving: true}),
    });
    this.sketchSoon();
  }

  private toolMove(events: PointerEvent[]) {
    this.hold?.move(events, this.projection());
    const last = events[events.length - 1]!;
    this.pointer = [last.offsetX, last.offsetY];
    this.sketchSoon();
  }

  /** At the next frame of the screen. */
  sketchSoon() {
    if (this.redraw) return;
    this.redraw = requestAnimationFrame(() => {
      this.redraw = 0;
      this.drawSketch();
    });
  }

  private drawSketch() {
    const start = performance.now();
    const {width, height} = viewport_size.value;
    const ratio = devicePixelRatio || 1;
    if (this.sketch.width !== Math.round(width * ratio)) this.sketch.width = Math.round(width * ratio);
    if (this.sketch.height !== Math.round(height * ratio)) this.sketch.height = Math.round(height * ratio);
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.pen.clearRect(0, 0, width, height);
    const projection = this.projection();
    drawPlanes(this.pen, projection, settings.value?.symmetry, scene.value);
    if (this.hold) drawLine(this.pen, projection, this.hold.line());
    this.drawBrush(projection);
    mark("ring", {start, end: performance.now()});
  }

  private drawBrush(projection: Projection) {
    const hit = this.pointer ? this.cast(...this.pointer) : null;
    hover.value = hit;
    if (!hit || !proxy.value || place_request.value) return;
    const radius = worldRadius(projection.unitsPerPixel(hit.point));
    const symmetric = mirrored(hit, settings.value?.symmetry, proxy.value);
    const style = {radius, inner: Number(brush.value["strength"] ?? 1), colour: in_hand.value === "smooth" ? "#7fd1ff" : "#ffd28a", symmetric};
    drawRing(this.pen, projection, proxy.value, hit, style, pinholeOf(orbit.value).position);
  }
}

/** The newest view, for those who change what it shows. */
export const view = signal<View | null>(null);

async function loadProxy(id: string, model: string): Promise<void> {
  try {
    const {Proxy} = await import("./proxy");
    const loaded = await Proxy.load(id);
    if (model_id.value !== model) return;
    proxy.value = loaded;
    mark("proxy", {at: performance.now()});
  } catch (error) {
    if (model_id.value !== model || !scene.value) return;
    if (!isOpen(id)) return loadProxy(scene.value.id, model);  // a scene that is gone had the same model
    sayError(error);
  }
}

/** Runs `work` when what `seen` reads changes. What the work reads does not count: asking for a frame reads the camera, and a camera
 *  that followed itself would never turn. */
const when = (seen: () => unknown, work: () => void) => effect(() => { seen(); untracked(work); });

/** What the picture follows: every signal that changes it makes the loop ask anew. */
function follow(shown: View): () => void {
  const touch = () => shown.frames.touch();
  const stops = [
    when(() => shown_model.value, () => shown.forget()),
    when(() => model_id.value, () => {
      proxy.value = null;  // nothing of the model before is found under the pointer
      if (scene.value) void loadProxy(scene.value.id, model_id.value);
    }),
    when(() => [revision.value, shown_model.value], touch),
    when(() => [dial.value, rest_quality.value, shared_request.value, compared.value], () => shown.frames.touch({moving: playing.value})),
    when(() => playing.value, touch),
    when(() => trial.value, () => shown.frames.touch({moving: trial.value !== null})),
    when(() => viewport_size.value, () => { touch(); shown.sketchSoon(); }),
    when(() => [brush.value, in_hand.value, settings.value, proxy.value, orbit.value], () => shown.sketchSoon()),
    when(() => model_id.value, () => moveTo("three_quarter", true)),
  ];
  return () => stops.forEach((stop) => stop());
}

export function Viewport() {
  const box = useRef<HTMLDivElement>(null);
  const picture = useRef<HTMLCanvasElement>(null);
  const sketch = useRef<HTMLCanvasElement>(null);
  const ready = useSignal(false);
  useEffect(() => {
    const element = box.current!;
    const measure = () => { viewport_size.value = {width: element.clientWidth, height: element.clientHeight}; };
    const watcher = new ResizeObserver(measure);
    watcher.observe(element);
    measure();
    const shown = new View(element, picture.current!, sketch.current!);
    view.value = shown;
    const unfollow = follow(shown);
    const visible = () => { if (!document.hidden) shown.frames.touch(); };
    document.addEventListener("visibilitychange", visible);
    ready.value = true;
    return () => {
      document.removeEventListener("visibilitychange", visible);
      watcher.disconnect();
      unfollow();
      shown.stop();
    };
  }, []);
  return (
    <div class="viewport">
      <div class="surface" ref={box} tabIndex={0} role="application" aria-label="The model. Drag on the fur to groom, beside it to turn.">
        <canvas class="picture" ref={picture} aria-hidden="true" />
        <canvas class="sketch" ref={sketch} aria-hidden="true" />
      </div>
      <FirstPicture />
      {place_request.value && <div class="hint-line" role="status">{place_request.value.says} <kbd>Esc</kbd> leaves it.</div>}
      <Compare />
      <Gizmos />
      <GuideHandles />
      <ViewCube />
      <Badge />
      <HandHints />
    </div>
  );
}
