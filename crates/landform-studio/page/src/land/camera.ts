// An orbiting camera: it looks at a target on the ground from a direction, an angle above the horizon and a distance.

export interface Orbit {
  /** Metres from the land's middle, east and north, and height above its lowest ground. */
  target: [number, number, number];
  /** Compass direction in which the camera looks, radians. */
  heading: number;
  /** Angle above the horizon, radians. */
  pitch: number;
  distance: number;
}

export const LEAST_PITCH = 0.03;
export const MOST_PITCH = Math.PI / 2 - 0.001;
export const FIELD_OF_VIEW = 32 * (Math.PI / 180);

/** The view in which land of a size (metres) fills a picture of an aspect, seen from the south-south-east. */
export function homeView(width: number, height: number, relief: number, aspect: number): Orbit {
  const view: Orbit = { target: [0, 0, relief * 0.3], heading: -0.4, pitch: 0.62, distance: 1 };
  const up = Math.tan(FIELD_OF_VIEW / 2) * 0.94, across = up * Math.max(aspect, 0.1);
  const corners = [-0.5, 0.5].flatMap((x) => [-0.5, 0.5].flatMap((y) => [-0.06 * Math.max(width, height), relief].map((z) => [x * width, y * height, z] as const)));
  // Again and again: where the land's middle stands in the picture depends on the distance.
  for (let k = 0; k < 5; k++) {
    const seen = corners.map((corner) => fromCamera(view, corner));
    view.distance = Math.max(...seen.map(([x, y, z]) => Math.max(Math.abs(x) / across, Math.abs(y) / up) - z));
    const middle = (axis: 0 | 1) => {
      const parts = seen.map((p) => p[axis] / (view.distance + p[2]));
      return ((Math.max(...parts) + Math.min(...parts)) / 2) * view.distance;
    };
    const [aside, above] = [middle(0), middle(1)];
    const [sin, cos] = [Math.sin(view.heading), Math.cos(view.heading)];
    view.target[0] += aside * cos + above * Math.sin(view.pitch) * sin;
    view.target[1] += -aside * sin + above * Math.sin(view.pitch) * cos;
    view.target[2] += above * Math.cos(view.pitch);
  }
  return view;
}

/** A place as seen: to the right, up, and beyond the target. */
function fromCamera(view: Orbit, place: readonly [number, number, number]): [number, number, number] {
  const [x, y, z] = [place[0] - view.target[0], place[1] - view.target[1], place[2] - view.target[2]];
  const [sh, ch, sp, cp] = [Math.sin(view.heading), Math.cos(view.heading), Math.sin(view.pitch), Math.cos(view.pitch)];
  const forward = x * sh + y * ch;
  return [x * ch - y * sh, forward * sp + z * cp, forward * cp - z * sp];
}

/** Where the camera stands: east, north, up. */
export function eye({ target, heading, pitch, distance }: Orbit): [number, number, number] {
  const flat = distance * Math.cos(pitch);
  return [
    target[0] - flat * Math.sin(heading),
    target[1] - flat * Math.cos(heading),
    target[2] + distance * Math.sin(pitch),
  ];
}

export function turned(view: Orbit, byHeading: number, byPitch: number): Orbit {
  const pitch = Math.min(MOST_PITCH, Math.max(LEAST_PITCH, view.pitch + byPitch));
  const full = 2 * Math.PI;
  return { ...view, heading: (((view.heading + byHeading) % full) + full) % full, pitch };
}

/** Nearer (factor < 1) or farther, within limits by the size of the land. */
export function zoomed(view: Orbit, factor: number, size: number): Orbit {
  return { ...view, distance: Math.min(size * 6, Math.max(size * 0.004, view.distance * factor)) };
}

/** Moves the target along the ground: right and forward as seen, in parts of the distance. */
export function panned(view: Orbit, right: number, forward: number, size: number): Orbit {
  const [sin, cos] = [Math.sin(view.heading), Math.cos(view.heading)];
  const d = view.distance;
  const within = (v: number) => Math.min(size, Math.max(-size, v));
  return {
    ...view,
    target: [
      within(view.target[0] + d * (right * cos + forward * sin)),
      within(view.target[1] + d * (-right * sin + forward * cos)),
      view.target[2],
    ],
  };
}
