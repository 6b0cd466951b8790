import type { GainSample } from '@/live/live_run';

export interface GainColumns {
  names: string[];
  times_s: number[];
  gains: (number | null)[][];
  bands: { situation: string; from_s: number; to_s: number }[];
}

/** Samples as one column a schema; a gap where a schema was not in the assemblage. */
export function gain_columns(samples: readonly GainSample[]): GainColumns {
  const names: string[] = [];
  for (const { names: of_one } of samples) {
    for (const name of of_one) if (!names.includes(name)) names.push(name);
  }
  const columns: GainColumns = {
    names,
    times_s: samples.map((sample) => sample.time_s),
    gains: names.map((name) => samples.map((sample) => gain_of(sample, name))),
    bands: [],
  };
  for (const { situation, time_s } of samples) {
    const last = columns.bands[columns.bands.length - 1];
    if (last) last.to_s = time_s;
    if (last?.situation !== situation) columns.bands.push({ situation, from_s: time_s, to_s: time_s });
  }
  return columns;
}

function gain_of(sample: GainSample, name: string): number | null {
  const at = sample.names.indexOf(name);
  return at < 0 ? null : (sample.gains[at] ?? null);
}
