// The picture in three dimensions, with mouse and keys.
import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { panned, turned, zoomed, type Orbit } from "../land/camera.ts";
import { pick } from "../land/pick.ts";
import { LandView } from "../land/view.ts";
import { contourInterval } from "../map/contours.ts";
import { endStroke, radius, strokePoint } from "../model/brush.ts";
import { begunNow, drawnNow } from "../model/actions.ts";
import { extent } from "../model/raster.ts";
import { brushAt, contours, ground, homeAsked, land, note, painting, shownLook, snowLine, sunAzimuth, sunHeight, tall, viewing } from "../model/store.ts";
import { drawnStates } from "./compared.ts";
import { follow } from "./follow.ts";
import { brushKey } from "./tools.tsx";
import { hover } from "./readout.tsx";

/** The view is kept while the pane is away. */
let kept: Orbit | null = null;
let keptSize = 0;

export function LandPane() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const element = canvas.current!;
    let view: LandView;
    try {
      view = new LandView(element);
    } catch (error) {
      note("error", (error as Error).message);
      viewing.value = "map";
      return;
    }
    view.orbit = kept;
    view.onBegin = begunNow;
    view.onDrawn = drawnNow;
    const stopResizing = follow(element, (w, h) => {
      view.resize(w, h);
      if (!kept) view.orbit = null;
    });
    const stopDrawing = effect(() => show(view));
    const stopHearing = listen(view, element);
    const stopHoming = homeAsked.subscribe(() => {
      if (homeAsked.value === 0) return;
      kept = null;
      view.orbit = view.home();
      view.redraw();
    });
    return () => {
      stopResizing();
      stopDrawing();
      stopHearing();
      stopHoming();
      view.dispose();
    };
  }, []);
  return (
    <div class="pane">
      <canvas ref={canvas} role="application" tabIndex={0} aria-label={label()} data-testid="land-canvas" />
    </div>
  );
}

function label(): string {
  const g = ground.value;
  if (!g) return "The land in three dimensions. No picture yet.";
  return `The land in three dimensions, level ${g.level}, from ${Math.round(g.min)} to ${Math.round(g.max)} metres. Arrows turn, plus and minus zoom, Home shows all.`;
}

let lastShown = 0;

function show(view: LandView): void {
  const { state, beside } = drawnStates.value;
  const degrees = Math.PI / 180;
  const size = state ? Math.max(...extent(state.ground)) : 1;
  if (state && Math.abs(size / keptSize - 1) > 0.02) {
    kept = null;
    view.orbit = null;
    keptSize = size;
  }
  view.state = state;
  view.beside = beside;
  view.drawn = {
    look: shownLook.value, tall: tall.value, light: { azimuth: sunAzimuth.value * degrees, height: sunHeight.value * degrees }, snow: snowLine.value,
    contour: contours.value && state ? contourInterval(state.ground.max - state.ground.min, 24) : 0, haze: 0.045 / size, detail: !view.software,
    brush: brushAt.value && painting.value ? [...brushAt.value, painting.value === "probe" ? size * 0.008 : radius()] : [0, 0, 0],
  };
  // What changes again and again is moving; the last change is drawn well.
  const now = performance.now();
  view.redraw(view.software || now - lastShown < 700);
  lastShown = now;
}

function listen(view: LandView, element: HTMLCanvasElement): () => void {
  let held: { x: number; y: number; pan: boolean; paint: boolean } | null = null;
  const size = () => (land.value ? Math.max(...extent(land.value.ground)) : 1);
  const set = (orbit: Orbit) => {
    kept = view.orbit = orbit;
    view.redraw(true);
  };
  const under = (e: PointerEvent | MouseEvent): [number, number] | null => {
    const box = element.getBoundingClientRect();
    const ray = view.ray((e.clientX - box.left) / box.width, (e.clientY - box.top) / box.height);
    return ray && ground.value ? pick(ground.value, tall.value, ray.from, ray.way) : null;
  };
  const down = (e: PointerEvent) => {
    element.focus({ preventScroll: true });
    element.setPointerCapture(e.pointerId);
    const paint = e.button === 0 && painting.value !== null && painting.value !== "probe" && !e.shiftKey;
    held = { x: e.clientX, y: e.clientY, pan: e.button !== 0 || e.shiftKey, paint };
    const at = paint ? under(e) : null;
    if (at) strokePoint(at, e.pressure);
  };
  const move = (e: PointerEvent) => {
    if (held && !held.paint && view.orbit) {
      const [dx, dy] = [e.clientX - held.x, e.clientY - held.y];
      held.x = e.clientX;
      held.y = e.clientY;
      if (held.pan) set(panned(view.orbit, -dx / element.clientHeight / 1.7, dy / element.clientHeight / 1.2, size()));
      else set(turned(view.orbit, dx * 0.006, dy * 0.005));
      return;
    }
    const at = under(e);
    hover.value = at;
    if (painting.value) brushAt.value = at;
    if (held?.paint && at) strokePoint(at, e.pressure);
  };
  const up = () => {
    if (held?.paint) endStroke();
    held = null;
  };
  const wheel = (e: WheelEvent) => {
    e.preventDefault();
    if (view.orbit) set(zoomed(view.orbit, Math.exp(Math.sign(e.deltaY) * Math.min(Math.abs(e.deltaY), 120) * 0.0016), size()));
  };
  const leave = () => (hover.value = null);
  const key = (e: KeyboardEvent) => {
    if (brushKey(e)) return void e.preventDefault();
    const next = view.orbit && orbitKey(view.orbit, e, size());
    if (next) set(next);
    else if (e.key === "Home") homeAsked.value++;
    else return;
    e.preventDefault();
  };
  const menu = (e: Event) => e.preventDefault();
  const all: [string, EventListener][] = [
    ["pointerdown", down as EventListener], ["pointermove", move as EventListener], ["pointerup", up], ["pointercancel", up], ["pointerleave", leave],
    ["wheel", wheel as EventListener], ["keydown", key as EventListener], ["contextmenu", menu],
  ];
  for (const [name, listener] of all) element.addEventListener(name, listener, { passive: false });
  return () => all.forEach(([name, listener]) => element.removeEventListener(name, listener));
}

function orbitKey(orbit: Orbit, e: KeyboardEvent, size: number): Orbit | null {
  const arrows: { [key: string]: [number, number] } = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const way = arrows[e.key];
  if (way && e.shiftKey) return panned(orbit, way[0] * 0.04, way[1] * 0.04, size);
  if (way) return turned(orbit, way[0] * 0.08, way[1] * 0.06);
  if (e.key === "+" || e.key === "=") return zoomed(orbit, 0.88, size);
  if (e.key === "-" || e.key === "−") return zoomed(orbit, 1 / 0.88, size);
  return null;
}
