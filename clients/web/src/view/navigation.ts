// Moves the camera by pointer, wheel and touch. A pointer's gesture is decided when it goes down and stays until it is up.
import {orbit, panned, turned, zoomed, type Orbit} from "./camera";

export type Gesture = "tool" | "orbit" | "pan" | "zoom";

export interface NavigationOptions {
  size: () => number;               // size of the model
  height: () => number;             // height of the picture in pixels
  hits: (x: number, y: number) => boolean;
  changed: () => void;              // the camera moved
  toolDown: (event: PointerEvent) => void;
  toolMove: (events: PointerEvent[]) => void;
  toolUp: (event: PointerEvent, cancelled: boolean) => void;
  hover: (event: PointerEvent | null) => void;
}

const turn_per_pixel = 0.008, zoom_per_pixel = 0.006, zoom_per_notch = 0.0016;

/** The left button on the model uses the tool; beside the model, with Alt, or with other buttons, it moves the camera. */
export function gestureOf(event: PointerEvent, on_model: boolean, pen_seen: boolean): Gesture {
  if (event.button === 1) return event.shiftKey ? "pan" : "orbit";
  if (event.button === 2) return event.altKey ? "zoom" : event.shiftKey ? "pan" : "orbit";
  if (event.altKey) return event.shiftKey ? "pan" : "orbit";
  if (event.pointerType === "touch" && pen_seen) return "orbit";
  return on_model ? "tool" : "orbit";
}

export class Navigation {
  private readonly pointers = new Map<number, PointerEvent>();
  private gesture: Gesture | null = null;
  private tool_pointer = -1;
  private pen_seen = false;
  private readonly stops = new AbortController();

  constructor(private readonly element: HTMLElement, private readonly options: NavigationOptions) {
    const listen = <K extends keyof HTMLElementEventMap>(name: K, handle: (event: HTMLElementEventMap[K]) => void) =>
      element.addEventListener(name, handle, {signal: this.stops.signal, passive: false});
    listen("pointerdown", (event) => this.down(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => this.up(event, false));
    listen("pointercancel", (event) => this.up(event, true));
    listen("pointerleave", () => { if (this.pointers.size === 0) options.hover(null); });
    listen("wheel", (event) => this.wheel(event));
    listen("contextmenu", (event) => event.preventDefault());
  }

  stop() { this.stops.abort(); }

  private down(event: PointerEvent) {
    event.preventDefault();
    this.element.focus({preventScroll: true});
    this.element.setPointerCapture(event.pointerId);
    this.pen_seen ||= event.pointerType === "pen";
    this.pointers.set(event.pointerId, event);
    if (this.pointers.size === 2) return this.twoFingers(event);
    if (this.pointers.size > 2) return;
    this.gesture = gestureOf(event, this.options.hits(event.offsetX, event.offsetY), this.pen_seen);
    if (this.gesture !== "tool") return;
    this.tool_pointer = event.pointerId;
    this.options.toolDown(event);
  }

  /** A second finger cancels the first one's stroke; both then move the camera. */
  private twoFingers(event: PointerEvent) {
    if (this.gesture === "tool") this.options.toolUp(event, true);
    this.tool_pointer = -1;
    this.gesture = "orbit";
  }

  private move(event: PointerEvent) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return this.options.hover(event);
    if (this.gesture === "tool") {
      if (event.pointerId !== this.tool_pointer) return;
      const events = event.getCoalescedEvents?.() ?? [];
      this.options.toolMove(events.length ? events : [event]);
    } else if (this.pointers.size >= 2) {
      this.pinch(before, event);
    } else {
      this.drag(event.offsetX - before.offsetX, event.offsetY - before.offsetY);
    }
    this.pointers.set(event.pointerId, event);
  }

  private up(event: PointerEvent, cancelled: boolean) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (event.pointerId === this.tool_pointer) {
      this.options.toolUp(event, cancelled);
      this.tool_pointer = -1;
    }
    if (this.pointers.size === 0) this.gesture = null;
  }

  private set(next: Orbit) {
    orbit.value = next;
    this.options.changed();
  }

  private drag(dx: number, dy: number) {
    const now = orbit.value;
    if (this.gesture === "pan") return this.set(panned(now, dx, dy, this.options.height()));
    if (this.gesture === "zoom") return this.set(zoomed(now, Math.exp((dy - dx) * zoom_per_pixel), this.options.size()));
    this.set(turned(now, -dx * turn_per_pixel, dy * turn_per_pixel));
  }

  /** Two fingers: moving their middle pans, changing their distance zooms. */
  private pinch(before: PointerEvent, event: PointerEvent) {
    const other = [...this.pointers.values()].find((pointer) => pointer.pointerId !== event.pointerId);
    if (!other) return;
    const gap = (pointer: PointerEvent) => Math.hypot(pointer.offsetX - other.offsetX, pointer.offsetY - other.offsetY);
    const moved = panned(orbit.value, (event.offsetX - before.offsetX) / 2, (event.offsetY - before.offsetY) / 2, this.options.height());
    this.set(zoomed(moved, Math.max(gap(before), 1) / Math.max(gap(event), 1), this.options.size()));
  }

  /** A wheel and a pinch zoom. Two fingers on a trackpad, recognized by sideways or fractional deltas, orbit. With Shift,
   * both pan. */
  private wheel(event: WheelEvent) {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    const [dx, dy] = [event.deltaX * lines, event.deltaY * lines];
    const trackpad = !event.ctrlKey && event.deltaMode === WheelEvent.DOM_DELTA_PIXEL && (dx !== 0 || !Number.isInteger(dy));
    if (event.shiftKey) return this.set(panned(orbit.value, -(dx || dy), dx ? -dy : 0, this.options.height()));
    if (trackpad) return this.set(turned(orbit.value, dx * turn_per_pixel * 0.6, -dy * turn_per_pixel * 0.6));
    const speed = event.ctrlKey ? zoom_per_notch * 6 : zoom_per_notch;
    this.set(zoomed(orbit.value, Math.exp(dy * speed), this.options.size()));
  }
}
