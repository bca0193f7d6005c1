// The map, with mouse and keys.
import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { MapView } from "../map/view.ts";
import { begunNow, drawnNow } from "../model/actions.ts";
import { endStroke, radius, strokePoint } from "../model/brush.ts";
import { extent } from "../model/raster.ts";
import { brushAt, ground, homeAsked, mapContours, painting, viewing } from "../model/store.ts";
import { drawnStates } from "./compared.ts";
import { follow } from "./follow.ts";
import { hover } from "./readout.tsx";
import { brushKey } from "./tools.tsx";

export function MapPane() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const element = canvas.current!;
    const view = new MapView(element);
    view.onDrawn = () => {
      if (viewing.value !== "map") return;
      begunNow();
      drawnNow();
    };
    const stopResizing = follow(element, (w, h) => view.resize(w, h));
    const stopDrawing = effect(() => {
      const { state, beside } = drawnStates.value;
      view.state = state;
      view.beside = beside;
      view.contours = mapContours.value;
      const size = state ? Math.max(...extent(state.ground)) : 1;
      view.brush = brushAt.value && painting.value ? [...brushAt.value, painting.value === "probe" ? size * 0.008 : radius()] : [0, 0, 0];
      view.redraw();
    });
    const stopHearing = listen(view, element);
    const stopHoming = homeAsked.subscribe(() => {
      view.place = { east: 0, north: 0, zoom: 1 };
      view.redraw();
    });
    return () => {
      stopResizing();
      stopDrawing();
      stopHearing();
      stopHoming();
    };
  }, []);
  const g = ground.value;
  return (
    <div class="pane">
      <canvas
        ref={canvas} role="application" tabIndex={0} data-testid="map-canvas"
        aria-label={g ? `Map of the land, level ${g.level}, north is up. Arrows move, plus and minus zoom, Home shows all.` : "Map of the land. No picture yet."}
      />
    </div>
  );
}

function listen(view: MapView, element: HTMLCanvasElement): () => void {
  let held: { x: number; y: number; paint: boolean } | null = null;
  const inside = ([east, north]: [number, number]): boolean => {
    const g = ground.value;
    if (!g) return false;
    const [w, h] = extent(g);
    return Math.abs(east) <= w / 2 && Math.abs(north) <= h / 2;
  };
  const under = (e: PointerEvent | WheelEvent): [number, number] | null => {
    const box = element.getBoundingClientRect();
    return view.toGround((e.clientX - box.left) / box.width, (e.clientY - box.top) / box.height);
  };
  const shift = (dx: number, dy: number) => {
    view.place = { ...view.place, east: view.place.east - view.metres(dx), north: view.place.north + view.metres(dy) };
    view.redraw();
  };
  const zoom = (factor: number, at: [number, number] | null) => {
    const was = view.place;
    const next = Math.min(64, Math.max(0.5, was.zoom * factor));
    const keep = at ?? [was.east, was.north];
    const part = was.zoom / next;
    view.place = { zoom: next, east: keep[0] + (was.east - keep[0]) * part, north: keep[1] + (was.north - keep[1]) * part };
    view.redraw();
  };
  const down = (e: PointerEvent) => {
    element.focus({ preventScroll: true });
    element.setPointerCapture(e.pointerId);
    const paint = e.button === 0 && painting.value !== null && painting.value !== "probe" && !e.shiftKey;
    held = { x: e.clientX, y: e.clientY, paint };
    const at = under(e);
    if (paint && at && inside(at)) strokePoint(at, e.pressure);
  };
  const move = (e: PointerEvent) => {
    if (held && !held.paint) {
      shift(e.clientX - held.x, e.clientY - held.y);
      held.x = e.clientX;
      held.y = e.clientY;
      return;
    }
    const at = under(e);
    hover.value = at && inside(at) ? at : null;
    if (painting.value) brushAt.value = hover.value;
    if (held?.paint && hover.value) strokePoint(hover.value, e.pressure);
  };
  const up = () => {
    if (held?.paint) endStroke();
    held = null;
  };
  const wheel = (e: WheelEvent) => {
    e.preventDefault();
    zoom(Math.exp(-Math.sign(e.deltaY) * Math.min(Math.abs(e.deltaY), 120) * 0.0018), under(e));
  };
  const key = (e: KeyboardEvent) => {
    const arrows: { [key: string]: [number, number] } = { ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60] };
    const way = arrows[e.key];
    if (brushKey(e)) void 0;
    else if (way) shift(...way);
    else if (e.key === "+" || e.key === "=") zoom(1.25, null);
    else if (e.key === "-") zoom(0.8, null);
    else if (e.key === "Home") homeAsked.value++;
    else return;
    e.preventDefault();
  };
  const leave = () => (hover.value = null);
  const menu = (e: Event) => e.preventDefault();
  const all: [string, EventListener][] = [
    ["pointerdown", down as EventListener], ["pointermove", move as EventListener], ["pointerup", up], ["pointercancel", up], ["pointerleave", leave],
    ["wheel", wheel as EventListener], ["keydown", key as EventListener], ["contextmenu", menu],
  ];
  for (const [name, listener] of all) element.addEventListener(name, listener, { passive: false });
  return () => all.forEach(([name, listener]) => element.removeEventListener(name, listener));
}

