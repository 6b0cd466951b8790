import { parse } from '@foxglove/rosmsg';
import { MessageReader } from '@foxglove/rosmsg2-serialization';

export type Unpack = (bytes: DataView) => unknown;

/** Reading a schema takes milliseconds, and a hundred robots have the same one. */
const known = new Map<string, Unpack>();

/** Unpacks CDR by a schema in `ros2msg`. Throws when the text is no such schema. */
export function unpacker(schema: string): Unpack {
  let unpack = known.get(schema);
  if (!unpack) {
    const reader = new MessageReader(parse(schema, { ros2: true }));
    unpack = (bytes) => reader.readMessage(bytes);
    known.set(schema, unpack);
  }
  return unpack;
}
