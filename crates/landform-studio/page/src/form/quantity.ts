// Quantities as the text of a recipe holds them: "5 mm/yr". The unit that was typed is kept.

export interface Quantity {
  number: number;
  unit: string;
}

const YEAR = 365.25 * 86_400;
/** Name, SI value, powers of length and time. */
const UNITS: { [name: string]: [number, number, number] } = {
  m: [1, 1, 0], mm: [1e-3, 1, 0], cm: [1e-2, 1, 0], km: [1e3, 1, 0], um: [1e-6, 1, 0], ft: [0.3048, 1, 0],
  s: [1, 0, 1], min: [60, 0, 1], h: [3600, 0, 1], d: [86_400, 0, 1], day: [86_400, 0, 1],
  yr: [YEAR, 0, 1], year: [YEAR, 0, 1], years: [YEAR, 0, 1], a: [YEAR, 0, 1],
  kyr: [1e3 * YEAR, 0, 1], ka: [1e3 * YEAR, 0, 1], Myr: [1e6 * YEAR, 0, 1], Ma: [1e6 * YEAR, 0, 1],
  Gyr: [1e9 * YEAR, 0, 1], Ga: [1e9 * YEAR, 0, 1],
  deg: [Math.PI / 180, 0, 0], "°": [Math.PI / 180, 0, 0], rad: [1, 0, 0], "%": [0.01, 0, 0], "1": [1, 0, 0],
};

/** Number and unit of "5 mm/yr"; a bare number has the unit "". Null where there is no number. */
export function parseQuantity(value: unknown): Quantity | null {
  if (typeof value === "number") return Number.isFinite(value) ? { number: value, unit: "" } : null;
  if (typeof value !== "string") return null;
  const match = /^\s*([+-]?(?:\d[\d_]*\.?[\d_]*|\.\d[\d_]*)(?:[eE][+-]?\d+)?)\s*(.*?)\s*$/.exec(value);
  if (!match) return null;
  const number = Number(match[1]!.replaceAll("_", ""));
  return Number.isFinite(number) ? { number, unit: match[2]! } : null;
}

/** SI value of a unit such as "mm/yr", "m2/yr", "m^3/s", "1/yr"; null where it is not known. */
export function unitSize(unit: string): { si: number; length: number; time: number } | null {
  let si = 1, length = 0, time = 0;
  const parts = unit.trim().split("/");
  for (const [place, part] of parts.entries()) {
    for (const factor of part.split(/[*·]/)) {
      const match = /^\s*(1|[a-zA-Z°%]+)\s*(?:\^?(-?\d+))?\s*$/.exec(plainPowers(factor));
      const known = match && UNITS[match[1]!];
      if (!match || !known) return null;
      const power = Number(match[2] ?? 1) * (place === 0 ? 1 : -1);
      si *= known[0] ** power;
      length += known[1] * power;
      time += known[2] * power;
    }
  }
  return { si, length, time };
}

function plainPowers(factor: string): string {
  return factor.replace("²", "2").replace("³", "3").replace("⁻¹", "-1");
}

/** `quantity` as a number of `unit`; null where one cannot be turned into the other. */
export function numberIn(quantity: Quantity, unit: string): number | null {
  if (quantity.unit === unit || quantity.unit === "") return quantity.number;
  const from = unitSize(quantity.unit), to = unitSize(unit);
  if (!from || !to || from.length !== to.length || from.time !== to.time) return null;
  return (quantity.number * from.si) / to.si;
}

/** The text of a number: plain where that is short, at most `digits` significant digits. */
export function numberText(number: number, digits = 4): string {
  if (number === 0) return "0";
  if (!Number.isFinite(number)) return String(number);
  const rounded = Number(number.toPrecision(digits));
  const size = Math.abs(rounded);
  if (size >= 1e7 || size < 1e-4) return rounded.toExponential().replace("e+", "e");
  return String(rounded);
}

/** The value for the text: a string with unit, or a number where the value was one and may be one. */
export function quantityValue(number: number, unit: string, digits = 4): string | number {
  const text = numberText(number, digits);
  return unit === "" ? Number(text) : `${text} ${unit}`;
}

/** Years as a person reads them: "250 kyr", "1.2 Myr". */
export function timeText(years: number): string {
  const size = Math.abs(years);
  if (size >= 1e9) return `${numberText(years / 1e9, 4)} Gyr`;
  if (size >= 1e6) return `${numberText(years / 1e6, 4)} Myr`;
  if (size >= 1e4) return `${numberText(years / 1e3, 4)} kyr`;
  if (size >= 1 || size === 0) return `${numberText(years, 4)} yr`;
  const days = years * 365.25;
  return days >= 1 ? `${numberText(days, 3)} d` : `${numberText(days * 24, 3)} h`;
}

/** Bytes as a person reads them. */
export function bytesText(bytes: number): string {
  if (bytes >= 2 ** 30) return `${numberText(bytes / 2 ** 30, 3)} GiB`;
  if (bytes >= 2 ** 20) return `${numberText(bytes / 2 ** 20, 3)} MiB`;
  if (bytes >= 1024) return `${numberText(bytes / 1024, 3)} KiB`;
  return `${bytes} B`;
}

/** Metres as a person reads them. */
export function lengthText(metres: number): string {
  return Math.abs(metres) >= 1000 ? `${numberText(metres / 1000, 4)} km` : `${numberText(metres, 4)} m`;
}

/** Square metres as a person reads them. */
export function areaText(area: number): string {
  return area >= 1e5 ? `${numberText(area / 1e6, 3)} km²` : `${numberText(area, 3)} m²`;
}
