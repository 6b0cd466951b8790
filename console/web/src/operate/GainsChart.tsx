import { useEffect, useRef } from 'react';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

import type { LiveRun } from '@/live/live_run';
import { on_palette, palette, series_colour } from '@/map/palette';
import { gain_columns, type GainColumns } from '@/operate/gain_columns';
import { useNews } from '@/operate/use_live';

const kHeight_px = 180;
const kBand_px = 16;
const kDashes = [[], [6, 3], [2, 2], [8, 3, 2, 3], [12, 3]];
const kSituations = [
  'AllClear', 'ClearToEnemy', 'FlankingEnemy', 'SoldierNeedsHelp', 'NoSoldiersNeedHelp',
];

/** The same situation has the same colour in every robot. */
function situation_colour(situation: string): string {
  const known = kSituations.indexOf(situation);
  return series_colour(known >= 0 ? known : situation.length);
}

/** "ClearToEnemy" is CE: short enough for the band. */
export function initials(situation: string): string {
  return situation.replace(/[^A-Z]/g, '') || situation.slice(0, 2);
}

function draw_bands(plot: uPlot, columns: GainColumns): void {
  const pen = plot.ctx;
  const ratio = uPlot.pxRatio;
  const { left, top, width } = plot.bbox;
  pen.save();
  pen.beginPath();
  pen.rect(left, top, width, kBand_px * ratio);
  pen.clip();
  pen.font = `${10 * ratio}px system-ui, sans-serif`;
  pen.textBaseline = 'middle';
  pen.textAlign = 'left';
  for (const band of columns.bands) {
    if (!band.situation) continue;
    const from = plot.valToPos(band.from_s, 'x', true);
    const to = plot.valToPos(band.to_s, 'x', true);
    pen.globalAlpha = 0.35;
    pen.fillStyle = situation_colour(band.situation);
    pen.fillRect(from, top, to - from, kBand_px * ratio);
    pen.globalAlpha = 1;
    pen.fillStyle = palette().ink;
    pen.fillRect(from, top, ratio, kBand_px * ratio);
    const text = initials(band.situation);
    if (to - from > pen.measureText(text).width + 6 * ratio) {
      pen.fillText(text, Math.max(from, left) + 4 * ratio, top + (kBand_px / 2) * ratio);
    }
  }
  pen.restore();
}

function options(columns: GainColumns, width: number, newest: { current: GainColumns }): uPlot.Options {
  const colours = palette();
  const axis = { stroke: colours.ink, grid: { stroke: colours.grid, width: 1 }, ticks: { show: false } };
  return {
    width,
    height: kHeight_px,
    legend: { show: false },
    cursor: { show: false },
    padding: [8, 8, 0, 0],
    scales: { x: { time: false }, y: { range: (_, low, high) => [Math.min(low, 0), high + 0.2 * (high - Math.min(low, 0) || 1)] } },
    axes: [
      { ...axis, size: 28, values: (_, ticks) => ticks.map((s) => `${s} s`) },
      { ...axis, size: 40 },
    ],
    series: [
      {},
      ...columns.names.map((label, i) => ({
        label,
        stroke: series_colour(i),
        width: 1.8,
        dash: kDashes[i % kDashes.length]!,
        points: { show: false },
      })),
    ],
    hooks: { draw: [(plot) => draw_bands(plot, newest.current)] },
  };
}

/** The gains of one robot's motor schemas over simulated time, its situations as a band on top. */
export function GainsChart({ live, robot }: { live: LiveRun; robot: number }) {
  useNews(live);
  const box = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const columns = gain_columns(live.samples(robot));
  const newest = useRef(columns);
  newest.current = columns;
  const layout = columns.names.join();

  useEffect(() => {
    const element = box.current!;
    const make = () => {
      plot.current?.destroy();
      const now = newest.current;
      plot.current = new uPlot(options(now, element.clientWidth, newest), data_of(now), element);
    };
    make();
    const watch = new ResizeObserver(() => {
      plot.current?.setSize({ width: element.clientWidth, height: kHeight_px });
    });
    watch.observe(element);
    const leave = on_palette(make);
    return () => {
      leave();
      watch.disconnect();
      plot.current?.destroy();
      plot.current = null;
    };
  }, [layout, robot]);
  useEffect(() => plot.current?.setData(data_of(newest.current)));

  const situations = [...new Set(columns.bands.map((band) => band.situation).filter(Boolean))];
  return (
    <figure className="gains">
      <figcaption>Gains over time{situations.length > 0 ? ', with the situation' : ''}</figcaption>
      <div ref={box} role="img" aria-label={words_of_columns(columns)} />
      <ul className="chips">
        {columns.names.map((name, i) => (
          <li key={name}>
            <svg width="22" height="8" aria-hidden="true">
              <line
                x1="0" y1="4" x2="22" y2="4" stroke={series_colour(i)} strokeWidth="2.5"
                strokeDasharray={kDashes[i % kDashes.length]!.join(' ')}
              />
            </svg>
            {name}
          </li>
        ))}
        {situations.map((name) => (
          <li key={name}>
            <span className="chip-box" style={{ background: situation_colour(name) }} aria-hidden="true" />
            {initials(name)} {name}
          </li>
        ))}
      </ul>
    </figure>
  );
}

function data_of(columns: GainColumns): uPlot.AlignedData {
  return [columns.times_s, ...columns.gains];
}

function words_of_columns(columns: GainColumns): string {
  const last = columns.names.map((name, i) => `${name} ${columns.gains[i]!.at(-1)?.toFixed(2) ?? 'none'}`);
  return `Chart of gains over time. Now: ${last.join(', ')}`;
}
