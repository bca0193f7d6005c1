// A small stand-in for the engine: uplift and stream power on a raster, so that pictures look like land.

/** Random numbers from a seed (mulberry32). */
export function random(seed) {
  let a = seed >>> 0;
  return () => {
    a = (a + 0x6d2b79f5) >>> 0;
    let t = Math.imul(a ^ (a >>> 15), a | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

export class Ground {
  constructor(size, cell, seed) {
    Object.assign(this, { size, cell, time: 0, z: new Float64Array(size * size), area: new Float64Array(size * size) });
    const next = random(seed);
    for (let i = 0; i < this.z.length; i++) this.z[i] = this.rim(i) ? 0 : next();
  }

  rim(i) {
    const r = Math.floor(i / this.size), c = i % this.size;
    return r === 0 || c === 0 || r === this.size - 1 || c === this.size - 1;
  }

  /** One implicit step of `dt` years: rates in m/yr and 1/yr (area exponent 0.5). */
  step(dt, uplift, erodibility) {
    const { size, cell, z, area } = this;
    const { order, receiver } = this.flood();
    area.fill(cell * cell);
    for (let k = order.length - 1; k >= 0; k--) if (receiver[order[k]] !== order[k]) area[receiver[order[k]]] += area[order[k]];
    for (const i of order) {
      if (this.rim(i)) continue;
      const r = receiver[i];
      const far = cell * (Math.abs(r - i) === 1 || Math.abs(r - i) === size ? 1 : Math.SQRT2);
      const f = (erodibility * dt * Math.sqrt(area[i])) / far;
      const x = (i % size) / size - 0.5, y = Math.floor(i / size) / size - 0.5;
      const raised = z[i] + uplift * dt * Math.max(0, 1 - 2.1 * Math.hypot(x, y) * (0.8 + 0.3 * Math.sin(5 * Math.atan2(y, x))));
      z[i] = Math.min((raised + f * z[r]) / (1 + f), z[r] + far * 0.75);
    }
    this.time += dt;
  }

  /** Nodes from the rim inwards by the height at which water reaches them, and where each drains to. */
  flood() {
    const { size, z } = this;
    const receiver = new Int32Array(z.length).fill(-1), order = [], heap = [];
    const push = (h, i) => {
      heap.push([h, i]);
      for (let k = heap.length - 1; k > 0;) {
        const up = (k - 1) >> 1;
        if (heap[up][0] <= heap[k][0]) break;
        [heap[up], heap[k]] = [heap[k], heap[up]];
        k = up;
      }
    };
    const pop = () => {
      const top = heap[0], end = heap.pop();
      if (heap.length) {
        heap[0] = end;
        for (let k = 0;;) {
          const l = 2 * k + 1;
          if (l >= heap.length) break;
          const m = l + 1 < heap.length && heap[l + 1][0] < heap[l][0] ? l + 1 : l;
          if (heap[k][0] <= heap[m][0]) break;
          [heap[m], heap[k]] = [heap[k], heap[m]];
          k = m;
        }
      }
      return top;
    };
    for (let i = 0; i < z.length; i++) if (this.rim(i)) { receiver[i] = i; push(z[i], i); }
    while (heap.length) {
      const [h, i] = pop();
      order.push(i);
      const r = Math.floor(i / size), c = i % size;
      for (let q = Math.max(0, r - 1); q <= Math.min(size - 1, r + 1); q++) {
        for (let p = Math.max(0, c - 1); p <= Math.min(size - 1, c + 1); p++) {
          const j = q * size + p;
          if (receiver[j] >= 0) continue;
          receiver[j] = i;
          push(Math.max(h, z[j]), j);
        }
      }
    }
    return { order, receiver };
  }
}
