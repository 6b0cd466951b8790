import { parse } from '@foxglove/rosmsg';
import { MessageReader } from '@foxglove/rosmsg2-serialization';

export type Unpack = (bytes: DataView) => unknown;

/** Unpacks CDR by a schema in `ros2msg`. Throws when the text is no such schema. */
export function unpacker(schema: string): Unpack {
  const reader = new MessageReader(parse(schema, { ros2: true }));
  return (bytes) => reader.readMessage(bytes);
}
