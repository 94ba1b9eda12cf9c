// Combines pictures of the same size into one, each with its number in the upper left corner.
import {decode, encode} from "fast-png";

export interface Corner { left: number; top: number }
export interface Montage { png: Uint8Array; size: {width: number; height: number}; corners: Corner[] }

interface Canvas { width: number; height: number; data: Uint8Array }

const gap = 4;
const gap_colour = 255;
const channels = 3;

/** Arranges up to three pictures in a row, more in a nearly square grid. `pngs` have 8 bits and this width and height. */
export function montage(pngs: Uint8Array[], width: number, height: number): Montage {
  const columns = pngs.length <= 3 ? pngs.length : Math.ceil(Math.sqrt(pngs.length)), rows = Math.ceil(pngs.length / columns);
  const canvas = blank(columns * (width + gap) - gap, rows * (height + gap) - gap);
  const corners = pngs.map((png, k) => {
    const corner = {left: (k % columns) * (width + gap), top: Math.floor(k / columns) * (height + gap)};
    place(canvas, png, corner);
    drawNumber(canvas, k + 1, corner, Math.max(1, Math.round(Math.min(width, height) / 96)));
    return corner;
  });
  return {png: encode({...canvas, channels, depth: 8}), size: {width: canvas.width, height: canvas.height}, corners};
}

const blank = (width: number, height: number): Canvas => ({width, height, data: new Uint8Array(width * height * channels).fill(gap_colour)});

function place(canvas: Canvas, png: Uint8Array, {left, top}: Corner) {
  const picture = decode(png);
  for (let y = 0; y < picture.height; ++y) {
    for (let x = 0; x < picture.width; ++x) {
      const from = (y * picture.width + x) * picture.channels;
      setPixel(canvas, left + x, top + y, [picture.data[from]!, picture.data[from + 1]!, picture.data[from + 2]!]);
    }
  }
}

function setPixel({width, height, data}: Canvas, x: number, y: number, colour: readonly number[]) {
  if (x < width && y < height) data.set(colour, (y * width + x) * channels);
}

/** The digits 0 to 9 as bitmaps: rows of three bits, top row first. */
const digits = [
  [7, 5, 5, 5, 7], [2, 6, 2, 2, 7], [7, 1, 7, 4, 7], [7, 1, 7, 1, 7], [5, 5, 7, 1, 1],
  [7, 4, 7, 1, 7], [7, 4, 7, 5, 7], [7, 1, 1, 1, 1], [7, 5, 7, 5, 7], [7, 5, 7, 1, 7],
];
const digit_width = 3, digit_height = 5;

/** Draws a number in white on a black box, readable on any fur. Each dot of a digit is `dot` pixels wide. */
function drawNumber(canvas: Canvas, number: number, {left, top}: Corner, dot: number) {
  const shapes = [...String(number)].map((digit) => digits[Number(digit)]!);
  const isLit = (column: number, row: number) => {
    const shape = shapes[Math.floor((column - 1) / (digit_width + 1))], within = (column - 1) % (digit_width + 1);
    return column > 0 && row > 0 && within < digit_width && ((shape?.[row - 1] ?? 0) >> (digit_width - 1 - within) & 1) === 1;
  };
  const columns = shapes.length * (digit_width + 1) + 1, rows = digit_height + 2;
  for (let y = 0; y < rows * dot; ++y) {
    for (let x = 0; x < columns * dot; ++x) {
      const value = isLit(Math.floor(x / dot), Math.floor(y / dot)) ? 255 : 0;
      setPixel(canvas, left + x, top + y, [value, value, value]);
    }
  }
}
