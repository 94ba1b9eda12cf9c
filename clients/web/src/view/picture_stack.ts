// Two canvases, one over the other: a better picture fades in over the one that it replaces.

const fade_ms = 160;

export class PictureStack {
  private readonly pens: ImageBitmapRenderingContext[];
  private front = 0;

  constructor(private readonly canvases: HTMLCanvasElement[]) {
    this.pens = canvases.map((canvas) => canvas.getContext("bitmaprenderer")!);
  }

  /** Takes the bitmap over. `fades` for a better picture of what is seen already; others replace it at once. */
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

  clear() { for (const pen of this.pens) pen.transferFromImageBitmap(null); }
}
