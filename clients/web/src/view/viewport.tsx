// The viewport: the picture, the brush over it, and the handling of pointers. The server draws the picture; all else is
// drawn here.
import {effect, signal, untracked} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {log, model_id, revision, scene, shown_model} from "../scene/session";
import {keepPicture} from "../scene/thumbnails";
import {trial} from "../scene/trial";
import {mark} from "../scene/marks";
import {guideReach, guidesOf} from "../tools/guides";
import {brush, current, hand_symmetry, in_hand, set_values, worldRadius} from "../tools/state";
import {beginHold, type Hold} from "../tools/hand";
import {Adjustment, adjusting, type Adjusted} from "./adjust";
import {orbit, pinholeOf, type Projection} from "./camera";
import {Badge} from "./badge";
import {playing} from "./clock";
import {Compare} from "./compare";
import {compared} from "./compared";
import {FirstPicture} from "./first_picture";
import {FrameLoop, type Stage} from "./frames";
import {GuideHandles} from "./guide_handles";
import {Gizmos} from "./gizmos";
import {HandHints} from "./hand_hints";
import {imagesOf} from "./mirror";
import {Navigation} from "./navigation";
import type {Hit} from "./proxy";
import {movePie, PieMenu} from "./pie_menu";
import {PictureStack} from "./picture_stack";
import {dial, rest_quality, shared_request} from "./quality";
import {drawRing, drawStrands} from "./ring";
import {drawLine, drawPlanes} from "./sketch";
import {followModel, furAt, hover, pending_pick, projectionNow, proxy, seen_orbit, skinAt, viewport_size} from "./surface";
import {ViewCube} from "./view_cube";
import {moveTo} from "./views";

const max_ratio = 2;
const strands_of_guide = 40;  // maximum of strands that are drawn around each point of a guide

/** The state of the viewport while it is on the page. */
class View {
  readonly frames: FrameLoop;
  private readonly navigation: Navigation;
  private readonly pictures: PictureStack;
  private readonly pen: CanvasRenderingContext2D;
  private hold: Hold | null = null;
  private pointer: [number, number] | null = null;
  private adjustment: Adjustment | null = null;
  private redraw = 0;

  constructor(private readonly box: HTMLElement, pictures: HTMLCanvasElement[], private readonly sketch: HTMLCanvasElement) {
    this.pictures = new PictureStack(pictures);
    this.pen = sketch.getContext("2d")!;
    this.frames = new FrameLoop(() => this.viewState(), (bitmap, stage) => this.present(bitmap, stage));
    this.navigation = new Navigation(box, {
      size: () => scene.value?.size ?? 1,
      height: () => viewport_size.value.height,
      hits: (x, y) => furAt(x, y) !== null,
      changed: () => { this.frames.touch({turning: true}); this.sketchSoon(); },
      toolDown: (event) => this.toolDown(event),
      toolMove: (events) => this.toolMove(events),
      toolUp: (_, cancelled) => { this.hold?.up(cancelled); this.hold = null; this.sketchSoon(); },
      hover: (event) => this.hover(event),
    });
  }

  stop() {
    this.frames.stop();
    this.navigation.stop();
    cancelAnimationFrame(this.redraw);
  }

  private viewState() {
    if (!scene.value) return null;
    const {width, height} = viewport_size.value;
    const ratio = Math.min(devicePixelRatio || 1, max_ratio);
    const drawn = trial.value?.of === scene.value.id ? trial.value : {scene: scene.value.id, revision: revision.value};
    return {scene: drawn.scene, revision: drawn.revision, orbit: orbit.value, width, height, ratio};
  }

  private present(bitmap: ImageBitmap, stage: Stage) {
    this.pictures.show(bitmap, stage === "rest" || stage === "traced");
    if (stage === "rest" && scene.value && !trial.value) keepPicture(scene.value.id, this.pictures.canvas);
  }

  /** Returns the mean colour around a pixel of the picture. */
  colourAt(x: number, y: number) { return this.pictures.colourAt(x / viewport_size.value.width, y / viewport_size.value.height); }

  /** Clears the picture and cancels the current stroke, because another scene or model is opened. */
  forget() {
    this.hold?.up(true);
    this.hold = null;
    this.frames.forget();
    this.pictures.clear();
  }

  private toolDown(event: PointerEvent) {
    const hit = furAt(event.offsetX, event.offsetY), skin = skinAt(event.offsetX, event.offsetY);
    if (pending_pick.value) return this.passPick(skin, [event.offsetX, event.offsetY]);
    if (!hit) return;
    this.pointer = [event.offsetX, event.offsetY];
    const press = {hit, skin, projection: projectionNow(), orbit: seen_orbit.value, time: event.timeStamp};
    this.hold = beginHold(in_hand.value, event, press, skinAt, {
      sent: () => this.frames.touch({moving: true, news: true}),
      changed: () => this.frames.touch({moving: true}),
    });
    this.sketchSoon();
  }

  private hover(event: PointerEvent | null) {
    if (movePie(event ? [event.offsetX, event.offsetY] : null)) return;
    if (this.adjustment) { if (event) this.adjustment.move(event.offsetX); return; }
    this.pointer = event ? [event.offsetX, event.offsetY] : null;
    this.sketchSoon();
  }

  /** Starts the adjustment of a brush setting while a key is held; null ends it. */
  adjust(what: Adjusted | null) {
    const hit = this.pointer ? furAt(...this.pointer) : null;
    this.adjustment = what && this.pointer && hit ? new Adjustment(what, this.pointer, projectionNow().unitsPerPixel(hit.point)) : null;
  }

  /** Passes a press to the panel that waits for a position. */
  private passPick(skin: Hit | null, pixel: [number, number]) {
    const request = pending_pick.value;
    if (!request || !skin) return;
    pending_pick.value = null;
    request.take(skin, pixel);
  }

  private toolMove(events: PointerEvent[]) {
    this.hold?.move(events, projectionNow());
    const last = events[events.length - 1]!;
    this.pointer = [last.offsetX, last.offsetY];
    this.sketchSoon();
  }

  /** Draws the overlay at the next animation frame. */
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
    const projection = projectionNow();
    drawPlanes(this.pen, projection, hand_symmetry.value, scene.value);
    this.drawReach(projection);
    if (this.hold) drawLine(this.pen, projection, this.hold.line());
    this.drawBrush(projection);
    mark("ring", {start, end: performance.now()});
  }

  /** Draws the strands that guides reach, while a guide tool is current. */
  private drawReach(projection: Projection) {
    const op = current.value, model = proxy.value;
    if (!model || (op !== "flow" && op !== "interpolate")) return;
    const camera = pinholeOf(seen_orbit.value).position, style = {radius: guideReach(op), colour: "#a8e0ff"};
    for (const guide of guidesOf(op)) for (const point of guide) drawStrands(this.pen, projection, model, point, style, camera, strands_of_guide);
  }

  private drawBrush(projection: Projection) {
    const hit = this.pointer ? furAt(...this.pointer) : null;
    hover.value = hit;
    this.box.dataset["hand"] = hit ? "groom" : "turn";
    if (!hit || !proxy.value || pending_pick.value) return;
    const style = {
      radius: worldRadius(projection.unitsPerPixel(hit.point)), inner: Number(brush.value["strength"] ?? 1),
      colour: in_hand.value === "smooth" ? "#7fd1ff" : "#ffd28a", flat: brush.value["falloff_shape"] === "surface",
    };
    drawRing(this.pen, projection, proxy.value, hit, imagesOf(hit, hand_symmetry.value), style, pinholeOf(seen_orbit.value).position);
  }
}

/** The current view, for modules that change what it shows. */
export const view = signal<View | null>(null);

/** Runs `work` when a signal that `seen` reads changes. Signals that only `work` reads do not count: requesting a frame reads
 *  the camera, and would then trigger itself. */
const when = (seen: () => unknown, work: () => void) => effect(() => { seen(); untracked(work); });

/** Makes the frame loop request a new picture when any signal that affects the picture changes. */
function follow(shown: View): () => void {
  const touch = () => shown.frames.touch();
  const stops = [
    when(() => shown_model.value, () => shown.forget()),
    when(() => model_id.value, () => moveTo("three_quarter", true)),
    followModel(),
    when(() => [revision.value, shown_model.value], touch),
    when(() => [dial.value, rest_quality.value, shared_request.value, compared.value], () => shown.frames.touch({moving: playing.value})),
    when(() => playing.value, touch),
    when(() => adjusting.value, () => shown.adjust(adjusting.value)),
    when(() => trial.value, () => shown.frames.touch({moving: trial.value !== null})),
    when(() => viewport_size.value, () => { touch(); shown.sketchSoon(); }),
    when(() => [brush.value, in_hand.value, hand_symmetry.value, current.value, log.value, set_values.value, proxy.value, seen_orbit.value], () => shown.sketchSoon()),
  ];
  return () => stops.forEach((stop) => stop());
}

/** Moves the keyboard focus to the viewport under the pointer, unless the user is typing or a dialog is open. */
function takeKeys(element: HTMLElement) {
  const holds = document.activeElement;
  if (holds instanceof HTMLElement && (/^(INPUT|TEXTAREA|SELECT)$/.test(holds.tagName) && !["range", "checkbox", "radio"].includes((holds as HTMLInputElement).type) || holds.closest("dialog, [popover]"))) return;
  element.focus({preventScroll: true});
}

export function Viewport() {
  const box = useRef<HTMLDivElement>(null);
  const pictures = [useRef<HTMLCanvasElement>(null), useRef<HTMLCanvasElement>(null)];
  const sketch = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const element = box.current!;
    element.addEventListener("pointerenter", () => takeKeys(element));
    const measure = () => { viewport_size.value = {width: element.clientWidth, height: element.clientHeight}; };
    const watcher = new ResizeObserver(measure);
    watcher.observe(element);
    measure();
    const shown = new View(element, pictures.map(({current}) => current!), sketch.current!);
    view.value = shown;
    const unfollow = follow(shown);
    const visible = () => { if (!document.hidden) shown.frames.touch(); };
    document.addEventListener("visibilitychange", visible);
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
        {pictures.map((ref, k) => <canvas key={k} class="picture" ref={ref} aria-hidden="true" />)}
        <canvas class="sketch" ref={sketch} aria-hidden="true" />
      </div>
      <FirstPicture />
      {pending_pick.value && <div class="hint-line" role="status">{pending_pick.value.says} <kbd>Esc</kbd> cancels.</div>}
      <PieMenu />
      <Compare />
      <Gizmos />
      <GuideHandles />
      <ViewCube />
      <Badge />
      <HandHints />
    </div>
  );
}
