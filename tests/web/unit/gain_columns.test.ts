import { gain_columns } from '@/operate/gain_columns';

const sample = (time_s: number, situation: string, gains: Record<string, number>) => ({
  time_s, situation, names: Object.keys(gains), gains: Float32Array.from(Object.values(gains)),
});

test('a schema that was not in the assemblage leaves a gap', () => {
  const columns = gain_columns([sample(1, '', { Noise: 0.5 }), sample(2, '', { MoveTo: 2 })]);
  expect(columns.names).toEqual(['Noise', 'MoveTo']);
  expect(columns.gains).toEqual([[0.5, null], [null, 2]]);
});

test('a situation lasts until the next begins', () => {
  const columns = gain_columns([
    sample(1, 'AllClear', {}), sample(2, 'AllClear', {}), sample(3, 'ClearToEnemy', {}),
  ]);
  expect(columns.bands).toEqual([
    { situation: 'AllClear', from_s: 1, to_s: 3 },
    { situation: 'ClearToEnemy', from_s: 3, to_s: 3 },
  ]);
});
