// ros2msg schemas from idl/wire/team.idl, and writers of CDR by them.
import { readFileSync } from 'node:fs';
import { need } from './packages.mjs';

const { parse } = need('@foxglove/rosmsg');
const { MessageWriter } = need('@foxglove/rosmsg2-serialization');

const kTypes = {
  boolean: 'bool',
  octet: 'uint8',
  char: 'char',
  short: 'int16',
  'unsigned short': 'uint16',
  long: 'int32',
  'unsigned long': 'uint32',
  'long long': 'int64',
  'unsigned long long': 'uint64',
  float: 'float32',
  double: 'float64',
};

const idl = readFileSync(new URL('../../../idl/wire/team.idl', import.meta.url), 'utf8').replace(
  /\/\/.*$/gm,
  '',
);
const structs = new Map(
  [...idl.matchAll(/struct\s+(\w+)\s*\{([^}]*)\}/g)].map(([, name, body]) => [name, fields(body)]),
);

function fields(body) {
  return [...body.matchAll(/([^;]+?)\s+(\w+)\s*;/g)].map(([, type, name]) => ({
    type: type.replace(/\s+/g, ' ').trim(),
    name,
  }));
}

function ros_type(type) {
  const sequence = /^sequence<\s*(.+?)\s*,\s*(\d+)\s*>$/.exec(type);
  if (sequence) return `${ros_type(sequence[1])}[<=${sequence[2]}]`;
  const string = /^string<(\d+)>$/.exec(type);
  if (string) return `string<=${string[1]}`;
  return kTypes[type] ?? `tacit_wire/${type}`;
}

function parts_of(name, known = new Set()) {
  known.add(name);
  for (const field of structs.get(name)) {
    const inner = /(?:sequence<\s*)?(\w+)/.exec(field.type)[1];
    if (structs.has(inner) && !known.has(inner)) parts_of(inner, known);
  }
  return known;
}

const body_of = (name) =>
  structs.get(name).map((field) => `${ros_type(field.type)} ${field.name}`).join('\n');

/** The schema of one structure, with those that it is made of. */
export function schema_of(name) {
  const [root, ...rest] = parts_of(name);
  const more = rest.map((part) => `${'='.repeat(80)}\nMSG: tacit_wire/${part}\n${body_of(part)}`);
  return [body_of(root), ...more].join('\n');
}

const writers = new Map();

export function writer_of(name) {
  if (!writers.has(name)) writers.set(name, new MessageWriter(parse(schema_of(name), { ros2: true })));
  return (value) => writers.get(name).writeMessage(value);
}
