// Colours of what the ground is made of, as the program's own pictures have them.
import type { Rgb } from "./ramps.ts";

/** Built-in materials in the order of their numbers; a recipe's own follow in the order of their names. */
const BUILT_IN = ["rock", "granite", "basalt", "limestone", "sandstone", "shale", "coral", "clay", "gravel", "sediment", "soil", "sand", "snow"];

const COLOURS: { [name: string]: number } = {
  sand: 0xd9b482, gravel: 0x9c8567, sediment: 0xb59a72, snow: 0xe9edf3, sandstone: 0xc48a5a, shale: 0x8b8a80, limestone: 0xd6cfba, granite: 0xb3a9a2,
  basalt: 0x56545a, clay: 0xa5745a, coral: 0xdcd2c2, chalk: 0xe6e2d6, dolomite: 0xc9c0aa, marble: 0xd8d5d0, gneiss: 0xa89b93, quartzite: 0xcdb394,
  schist: 0x7f877c, slate: 0x666d77, conglomerate: 0xa98a6b, tuff: 0xbfae94,
};
const OTHERS = [0xb98f6f, 0x8e8577, 0xc2b59a, 0x77736f, 0xa4836a, 0x9aa08f];
/** These lie open; of rock, slopes show it and gentle ground is grown over. */
const OPEN = new Set(["sand", "gravel", "snow", "coral", "sediment"]);

export interface Cover {
  colour: Rgb;
  /** How much of it shows: 0 what grows there, 0.5 rock on slopes, 1 all of it. */
  shows: number;
}

/** What each number of `surface_material` looks like, given the names of a recipe's own materials. */
export function covers(own: string[]): Cover[] {
  const added = own.filter((name) => !BUILT_IN.includes(name)).sort();
  return [...BUILT_IN, ...added].map((name, i) => {
    const hex = COLOURS[name] ?? OTHERS[i % OTHERS.length]!;
    const shows = name === "rock" || name === "soil" ? 0 : OPEN.has(name) ? 1 : 0.5;
    return { colour: [hex >> 16, (hex >> 8) & 255, hex & 255], shows };
  });
}

/** What a number beyond the table looks like. */
export function otherCover(number: number): Cover {
  const hex = OTHERS[Math.abs(number) % OTHERS.length]!;
  return { colour: [hex >> 16, (hex >> 8) & 255, hex & 255], shows: 0.5 };
}
