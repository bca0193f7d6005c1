// Charts of the shown ground and its report card.
import { areaText, numberText } from "../form/quantity.ts";
import { charts } from "../model/store.ts";
import type { CardRow, Charts } from "../protocol/messages.ts";
import { words } from "./words.ts";

export function Measures() {
  const c = charts.value;
  if (!c) return <div class="side-body"><p class="dim">Measures come when a preview is done.</p></div>;
  return (
    <div class="side-body" data-testid="measures" tabIndex={0} role="region" aria-label="Measures">
      <h2>Measures</h2>
      <p class="dim lead">Of the ground at level {c.level ?? "?"}.</p>
      <Summary c={c} />
      {c.histogram && c.histogram.counts.length > 0 && <Histogram edges={c.histogram.edges} counts={c.histogram.counts} />}
      {c.hypsometry && c.hypsometry.length > 1 && (
        <Plot title="Hypsometry" help="Share of the land above a height" points={c.hypsometry} x="share of the area" y="height, m" line />
      )}
      {c.slope_area && c.slope_area.length > 1 && (
        <Plot title="Slope and area" help="Rivers fall less the more land they drain" points={c.slope_area} x="drainage area" y="slope" log />
      )}
      {c.card && c.card.length > 0 && <Card rows={c.card} verdict={c.verdict} />}
    </div>
  );
}

function Summary({ c }: { c: Charts }) {
  return (
    <dl class="summary">
      {Object.entries(c.summary).filter(([, v]) => v !== null).map(([name, v]) => (
        <div key={name}><dt>{words(name)}</dt><dd>{summaryText(name, v!)}</dd></div>
      ))}
    </dl>
  );
}

const METRES = new Set(["min", "max", "mean", "median", "deviation", "relief", "sea_level"]);

function summaryText(name: string, v: number): string {
  if (METRES.has(name)) return `${numberText(v, 4)} m`;
  if (name === "area") return areaText(v);
  if (name === "mean_slope") return `${numberText(v, 3)}°`;
  if (name === "nodes") return v.toLocaleString("en");
  return numberText(v, 3);
}

const W = 312, H = 132, LEFT = 44, BOTTOM = 26, TOP = 8, RIGHT = 10;
const spanX = W - LEFT - RIGHT, spanY = H - TOP - BOTTOM;

function Frame({ title, help, x, y, lowX, highX, lowY, highY, children }: {
  title: string; help: string; x: string; y: string; lowX: string; highX: string; lowY: string; highY: string; children: preact.ComponentChildren;
}) {
  return (
    <figure class="chart">
      <figcaption>{title} <small class="dim">{help}</small></figcaption>
      <svg viewBox={`0 0 ${W} ${H}`} role="img" aria-label={`${title}: ${x} from ${lowX} to ${highX}, ${y} from ${lowY} to ${highY}`}>
        <path class="axis" d={`M${LEFT} ${TOP}V${H - BOTTOM}H${W - RIGHT}`} />
        {children}
        <text x={LEFT - 5} y={TOP + 8} text-anchor="end">{highY}</text>
        <text x={LEFT - 5} y={H - BOTTOM} text-anchor="end">{lowY}</text>
        <text x={LEFT} y={H - BOTTOM + 13}>{lowX}</text>
        <text x={W - RIGHT} y={H - BOTTOM + 13} text-anchor="end">{highX}</text>
        <text x={LEFT + spanX / 2} y={H - BOTTOM + 13} text-anchor="middle" class="axis-name">{x}</text>
      </svg>
    </figure>
  );
}

function Histogram({ edges, counts }: { edges: number[]; counts: number[] }) {
  const most = Math.max(...counts, 1);
  const [low, high] = [edges[0] ?? 0, edges.at(-1) ?? 1];
  const at = (v: number) => LEFT + (spanX * (v - low)) / (high - low || 1);
  return (
    <Frame title="Heights" help="How much ground lies at each height" x="height, m" y="nodes" lowX={numberText(low, 3)} highX={numberText(high, 4)} lowY="0" highY="">
      {counts.map((n, i) => {
        const [a, b] = [at(edges[i]!), at(edges[i + 1]!)];
        const tall = (spanY * n) / most;
        return <rect key={i} class="bar" x={a + 0.5} y={TOP + spanY - tall} width={Math.max(0.5, b - a - 1)} height={tall} />;
      })}
    </Frame>
  );
}

function Plot({ title, help, points, x, y, line, log }: { title: string; help: string; points: [number, number][]; x: string; y: string; line?: boolean; log?: boolean }) {
  const usable = points.filter(([a, b]) => Number.isFinite(a) && Number.isFinite(b) && (!log || (a > 0 && b > 0)));
  if (usable.length < 2) return null;
  const f = log ? Math.log10 : (v: number) => v;
  const range = (k: 0 | 1) => [Math.min(...usable.map((p) => p[k])), Math.max(...usable.map((p) => p[k]))] as const;
  const [lowX, highX] = range(0), [lowY, highY] = range(1);
  const px = (v: number) => LEFT + (spanX * (f(v) - f(lowX))) / (f(highX) - f(lowX) || 1);
  const py = (v: number) => TOP + spanY * (1 - (f(v) - f(lowY)) / (f(highY) - f(lowY) || 1));
  const end = (v: number) => (log ? areaText(v) : numberText(v, 3));
  return (
    <Frame title={title} help={help} x={x} y={y} lowX={end(lowX)} highX={end(highX)} lowY={numberText(lowY, 2)} highY={numberText(highY, 3)}>
      {line
        ? <path class="line" d={usable.map(([a, b], i) => `${i ? "L" : "M"}${px(a).toFixed(1)} ${py(b).toFixed(1)}`).join("")} />
        : usable.map(([a, b], i) => <circle key={i} class="point" cx={px(a)} cy={py(b)} r="2.2" />)}
    </Frame>
  );
}

function Card({ rows, verdict }: { rows: CardRow[]; verdict: Charts["verdict"] }) {
  return (
    <section class="card">
      <h3>Report card</h3>
      {verdict && <p><b>{verdict.title}</b></p>}
      {verdict && <p class="dim lead">{verdict.reason}</p>}
      <p class="dim lead">Each number beside its range on real ground.</p>
      <ul>
        {rows.map((row) => (
          <li key={row.name} title={row.meaning ?? undefined}>
            <span>{words(row.name)}</span>
            <b>{row.value === null ? "–" : numberText(row.value, 3)}{row.unit && row.unit !== "1" ? ` ${row.unit}` : ""}</b>
            <small class="dim">{row.low !== null && row.high !== null ? `${numberText(row.low, 3)} to ${numberText(row.high, 3)}` : ""}</small>
            <small class={`verdict ${row.verdict === "inside" ? "good" : ""}`}>{row.verdict === "none" ? "" : row.verdict}</small>
          </li>
        ))}
      </ul>
    </section>
  );
}
