// The map: a picture of the nodes, moved and scaled, with contours, the brush and what is compared.
import type { Beside } from "../land/view.ts";
import type { LandState } from "../land/state.ts";
import { extent } from "../model/raster.ts";
import { contourInterval, contourLine } from "./contours.ts";
import { mapPixels } from "./paint.ts";

/** Middle of the picture, metres from the land's middle, and how many times larger than the whole land. */
export interface MapPlace {
  east: number;
  north: number;
  zoom: number;
}

interface Painted {
  state: LandState;
  picture: HTMLCanvasElement;
  lines: { path: Path2D; strong: boolean }[] | null;
}

export class MapView {
  private readonly context: CanvasRenderingContext2D;
  private readonly painted = new Map<LandState, Painted>();
  private pending = 0;
  private size: [number, number] = [1, 1];
  state: LandState | null = null;
  beside: Beside | null = null;
  contours = true;
  brush: [number, number, number] = [0, 0, 0];
  place: MapPlace = { east: 0, north: 0, zoom: 1 };
  onDrawn: (milliseconds: number) => void = () => {};

  constructor(readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext("2d", { alpha: false })!;
  }

  resize(width: number, height: number): void {
    this.size = [Math.max(1, width), Math.max(1, height)];
    this.redraw();
  }

  redraw(): void {
    this.pending ||= requestAnimationFrame(() => {
      this.pending = 0;
      this.draw();
    });
  }

  /** Pixels of the page for a metre. */
  private scale(state: LandState): number {
    const [w, h] = extent(state.ground);
    return Math.min((this.size[0] - 32) / w, (this.size[1] - 32) / h) * this.place.zoom;
  }

  /** Metres from the land's middle at a place of the picture (parts of its width and height). */
  toGround(x: number, y: number): [number, number] | null {
    if (!this.state) return null;
    const scale = this.scale(this.state);
    return [this.place.east + ((x - 0.5) * this.size[0]) / scale, this.place.north - ((y - 0.5) * this.size[1]) / scale];
  }

  /** Metres that a part of the picture's width spans. */
  metres(pixels: number): number {
    return this.state ? pixels / this.scale(this.state) : 0;
  }

  private draw(): void {
    const start = performance.now();
    const { canvas, context, state } = this;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = this.size;
    if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
    if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = "#0b0d10";
    context.fillRect(0, 0, width, height);
    if (!state) return;
    this.forget();
    if (this.beside) {
      const cut = width * this.beside.split;
      this.clipped(0, cut, () => this.one(state));
      this.clipped(cut, width, () => this.one(this.beside!.state));
    } else this.one(state);
    this.drawBrush(state);
    this.drawScaleBar(state);
    this.onDrawn(performance.now() - start);
  }

  private forget(): void {
    for (const key of this.painted.keys()) if (key !== this.state && key !== this.beside?.state) this.painted.delete(key);
  }

  private clipped(left: number, right: number, draw: () => void): void {
    this.context.save();
    this.context.beginPath();
    this.context.rect(left, 0, right - left, this.size[1]);
    this.context.clip();
    draw();
    this.context.restore();
  }

  private one(state: LandState): void {
    const { context } = this;
    const painted = this.paint(state);
    const { ground } = state;
    const [w, h] = extent(ground);
    const scale = this.scale(state);
    const left = this.size[0] / 2 - (this.place.east + w / 2) * scale, top = this.size[1] / 2 + (this.place.north - h / 2) * scale;
    context.imageSmoothingEnabled = true;
    context.imageSmoothingQuality = "high";
    // A node is the middle of its pixel.
    const [dx, dy] = [(ground.cell[0] * scale) / 2, (ground.cell[1] * scale) / 2];
    context.drawImage(painted.picture, left - dx, top - dy, w * scale + 2 * dx, h * scale + 2 * dy);
    if (!this.contours) return;
    painted.lines ??= contourPaths(state);
    context.save();
    context.translate(left, top);
    context.scale(ground.cell[0] * scale, ground.cell[1] * scale);
    for (const { path, strong } of painted.lines ?? []) {
      context.lineWidth = (strong ? 1.3 : 0.7) / (ground.cell[0] * scale);
      context.strokeStyle = strong ? "rgba(15,12,8,.6)" : "rgba(15,12,8,.36)";
      context.stroke(path);
    }
    context.restore();
  }

  private paint(state: LandState): Painted {
    let painted = this.painted.get(state);
    if (!painted) {
      const picture = document.createElement("canvas");
      picture.width = state.ground.cols;
      picture.height = state.ground.rows;
      picture.getContext("2d")!.putImageData(new ImageData(mapPixels(state), state.ground.cols, state.ground.rows), 0, 0);
      painted = { state, picture, lines: null };
      this.painted.set(state, painted);
    }
    return painted;
  }

  private drawBrush(state: LandState): void {
    const [east, north, radius] = this.brush;
    if (!(radius > 0)) return;
    const scale = this.scale(state);
    const { context } = this;
    context.beginPath();
    context.arc(this.size[0] / 2 + (east - this.place.east) * scale, this.size[1] / 2 - (north - this.place.north) * scale, radius * scale, 0, 2 * Math.PI);
    context.lineWidth = 3;
    context.strokeStyle = "rgba(0,0,0,.5)";
    context.stroke();
    context.lineWidth = 1.5;
    context.strokeStyle = "#ffd479";
    context.stroke();
  }

  private drawScaleBar(state: LandState): void {
    const { context } = this;
    const scale = this.scale(state);
    const length = contourInterval(150 / scale, 1.2);
    const [x, y] = [66, this.size[1] - 58];
    const text = length >= 1000 ? `${length / 1000} km` : `${length} m`;
    context.lineWidth = 3;
    context.strokeStyle = "rgba(10,12,14,.75)";
    const bar = () => {
      context.beginPath();
      context.moveTo(x, y - 5);
      context.lineTo(x, y);
      context.lineTo(x + length * scale, y);
      context.lineTo(x + length * scale, y - 5);
      context.stroke();
    };
    bar();
    context.lineWidth = 1.4;
    context.strokeStyle = "#f2eee6";
    bar();
    context.font = "12px system-ui, sans-serif";
    context.lineWidth = 3;
    context.strokeStyle = "rgba(10,12,14,.75)";
    context.strokeText(text, x + 5, y - 7);
    context.fillStyle = "#f2eee6";
    context.fillText(text, x + 5, y - 7);
  }
}

function contourPaths({ ground }: LandState): Painted["lines"] {
  const step = contourInterval(ground.max - ground.min, 16);
  const lines: NonNullable<Painted["lines"]> = [];
  if (!(step > 0)) return lines;
  for (let level = Math.ceil(ground.min / step) * step, k = 0; level < ground.max && k < 64; level += step, k++) {
    const pieces = contourLine(ground, level);
    const path = new Path2D();
    for (let i = 0; i < pieces.length; i += 4) {
      path.moveTo(pieces[i]!, pieces[i + 1]!);
      path.lineTo(pieces[i + 2]!, pieces[i + 3]!);
    }
    lines.push({ path, strong: Math.round(level / step) % 5 === 0 });
  }
  return lines;
}
