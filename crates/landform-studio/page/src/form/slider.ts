// A slider's position (0 to 1) and its number, on a linear or logarithmic scale between soft limits.

export interface Scale {
  low: number;
  high: number;
  log: boolean;
}

/** Steps of a slider from end to end. */
export const SLIDER_STEPS = 400;

export function positionOf(number: number, { low, high, log }: Scale): number {
  const part = log ? Math.log(Math.max(number, low) / low) / Math.log(high / low) : (number - low) / (high - low);
  return Math.min(1, Math.max(0, part));
}

/** The number at a position, rounded to what the slider can show. */
export function numberAt(position: number, scale: Scale, whole = false): number {
  const { low, high, log } = scale;
  const raw = log ? low * (high / low) ** position : low + (high - low) * position;
  if (whole) return Math.round(raw);
  if (log) return Number(raw.toPrecision(3));
  const step = 10 ** Math.floor(Math.log10((high - low) / SLIDER_STEPS));
  return Number((Math.round(raw / step) * step).toPrecision(12));
}

/** Soft limits widened so that the number itself lies on the slider. */
export function widened(scale: Scale, number: number | null): Scale {
  if (number === null || !Number.isFinite(number)) return scale;
  if (scale.log && number <= 0) return scale;
  return { ...scale, low: Math.min(scale.low, number), high: Math.max(scale.high, number) };
}
