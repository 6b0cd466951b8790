// @vitest-environment node
import { unpacker } from '@/wire/unpack';
import { schema_of, writer_of } from '../mock/schemas.mjs';

const kRobot = {
  x_m: 1.5, y_m: -2, heading_cos: 0, heading_sin: 1, velocity_x_mps: 0.25, velocity_y_mps: 0,
  robot: 12, present: 1, able: 0, holding: 1, colour: 2,
};

function there_and_back(name: string, value: object): unknown {
  const bytes: Uint8Array = writer_of(name)(value);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return unpacker(schema_of(name))(view);
}

test('a world view is unpacked as it was packed', () => {
  const view = {
    time_s: 12.5, tick: 125n, robots: [kRobot, { ...kRobot, robot: 13 }],
    enemies: [{ x_m: 3, y_m: 4, enemy: 9, kind: 2 }], mines: [], objects: [],
  };
  expect(there_and_back('WorldView', view)).toEqual(view);
});

test('telemetry keeps its words', () => {
  const telemetry = {
    tick: 7n, decisions: 7n, duplicates: 0n, rejected: 0n, robot: 3, learner: 'lm',
    situation: 'ClearToEnemy', role: '', state: '',
    shares: [{ gain: 0.5, push_x: 1, push_y: -1, name: 'Noise' }],
  };
  expect(there_and_back('Telemetry', telemetry)).toEqual(telemetry);
});

test('a schema that is none is refused', () => {
  expect(() => unpacker('this is no schema')).toThrow();
});
