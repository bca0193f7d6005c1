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

/** The view in which land of a size (metres) fills the picture. */
export function homeView(width: number, height: number, relief: number, aspect: number): Orbit {
  const heading = -0.62;
  const pitch = 0.55;
  const radius = Math.hypot(width, height) / 2;
  const across = 2 * Math.atan(Math.tan(FIELD_OF_VIEW / 2) * Math.max(aspect, 0.1));
  const needed = Math.min(across * 0.92, FIELD_OF_VIEW * 1.5);
  return { target: [0, 0, relief * 0.25], heading, pitch, distance: radius / Math.sin(needed / 2) };
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
