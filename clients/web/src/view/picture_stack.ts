// Two stacked canvases: a better picture fades in over the one that it replaces.

const fade_ms = 160;

export class PictureStack {
  private readonly pens: ImageBitmapRenderingContext[];
  private front = 0;

  constructor(private readonly canvases: HTMLCanvasElement[]) {
    this.pens = canvases.map((canvas) => canvas.getContext("bitmaprenderer")!);
  }

  /** Shows a bitmap and takes ownership of it. `fades`: it is a better picture of the same state; else it appears at once. */
  show(bitmap: ImageBitmap, fades: boolean) {
    const old = this.canvases[this.front]!;
    this.front = 1 - this.front;
    const canvas = this.canvases[this.front]!;
    if (canvas.width !== bitmap.width) canvas.width = bitmap.width;
    if (canvas.height !== bitmap.height) canvas.height = bitmap.height;
    this.pens[this.front]!.transferFromImageBitmap(bitmap);
    delete old.dataset["front"];
    canvas.dataset["front"] = "";
    if (fades && !matchMedia("(prefers-reduced-motion: reduce)").matches) canvas.animate([{opacity: 0}, {opacity: 1}], fade_ms);
  }

  /** The visible canvas. */
  get canvas() { return this.canvases[this.front]!; }

  /** Returns the colour "#rrggbb" at fractions of width and height: a mean over 7 x 7 pixels, because single hairs vary. */
  colourAt(x: number, y: number): string {
    const canvas = this.canvas, side = 7;
    const copy = new OffscreenCanvas(side, side).getContext("2d")!;
    copy.drawImage(canvas, Math.round(x * canvas.width - side / 2), Math.round(y * canvas.height - side / 2), side, side, 0, 0, side, side);
    const {data} = copy.getImageData(0, 0, side, side);
    const mean = (channel: number) => data.reduce((sum, value, k) => sum + (k % 4 === channel ? value : 0), 0) / (side * side);
    return "#" + [0, 1, 2].map((channel) => Math.round(mean(channel)).toString(16).padStart(2, "0")).join("");
  }

  clear() { for (const pen of this.pens) pen.transferFromImageBitmap(null); }
}
