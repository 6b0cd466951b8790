// check_recording.mjs RECORDING INFO CSV
//
// Reads a recording of Tacit's with the readers of the people who made the format: by its index and
// as a stream, every checksum checked, every message decoded by the schema in the file. Compares
// with what `tacit replay` says of it: INFO as --info --json, CSV as --csv.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";

const [recording, infoFile, csvFile] = process.argv.slice(2);
const data = await readFile(recording);
const info = JSON.parse(await readFile(infoFile, "utf8"));
const csv = (await readFile(csvFile, "utf8")).trim().split("\n").map((line) => line.split(","));
const decompressHandlers = await loadDecompressHandlers();

const readable = {
  size: async () => BigInt(data.length),
  read: async (offset, length) => data.subarray(Number(offset), Number(offset + length)),
};
const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });

const decoders = new Map();
for (const channel of reader.channelsById.values()) {
  const schema = reader.schemasById.get(channel.schemaId);
  assert.equal(channel.messageEncoding, "cdr", channel.topic);
  assert.equal(schema.encoding, "ros2msg", channel.topic);
  const text = new TextDecoder().decode(schema.data);
  decoders.set(channel.id, new MessageReader(parse(text, { ros2: true })));
}

const channels = Object.fromEntries(Object.keys(info.channels).map((topic) => [topic, 0]));
const first = {};
const last = {};
let events = 0;
const poses = [];
let logTime = 0n;
for await (const message of reader.readMessages({ validateCrcs: true })) {
  assert(message.logTime >= logTime, "out of order");
  logTime = message.logTime;
  const { topic } = reader.channelsById.get(message.channelId);
  const value = decoders.get(message.channelId).readMessage(message.data);
  channels[topic] += 1;
  first[topic] ??= value;
  last[topic] = value;
  if (topic === "/tacit/events") {
    events = Math.max(events, Number(value.first) + value.events.length);
  }
  if (topic === "/tacit/world_view") {
    for (const { robot, x_m, y_m } of value.robots) poses.push([value.tick, robot, x_m, y_m]);
  }
}

const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
stream.append(data);
let streamed = 0;
for (let record; (record = stream.nextRecord()); ) streamed += record.type === "Message" ? 1 : 0;
assert(stream.done(), "the stream has no end");

const attachments = {};
for await (const { name, data: contents } of reader.readAttachments({ validateCrcs: true })) {
  attachments[name] = contents.length;
}
const metadata = {};
for await (const { name, metadata: values } of reader.readMetadata()) {
  metadata[name] = Object.fromEntries(values);
}

assert.equal(info.trouble, "");
assert.deepEqual(channels, info.channels);
assert.deepEqual(attachments, info.attachments);
assert.deepEqual(metadata, info.metadata);
assert.equal(events, info.events);
assert.equal(BigInt(streamed), reader.statistics.messageCount);
assert.equal(Number(reader.statistics.messageEndTime) / 1e9, info.end_s);
assert.equal(metadata.outcome.event_log_sha256, info.event_log_sha256);

const columns = csv.filter(([, , kind]) => kind === "robot");
assert.equal(columns.length, poses.length);
poses.forEach(([tick, robot, x_m, y_m], row) => {
  const [csvTick, id, , csvX, csvY] = columns[row];
  assert.deepEqual([Number(tick), robot, x_m, y_m], [csvTick, id, csvX, csvY].map(Number));
});

const view = last["/tacit/world_view"];
const bodies = last["/tacit/scene"].markers.filter(({ ns }) => ns === "robots");
assert.deepEqual(
  bodies.map(({ id, pose }) => [id, pose.position.x, pose.position.y]),
  view.robots.map(({ robot, x_m, y_m }) => [robot, x_m, y_m]),
);
assert.equal(bodies[0].header.frame_id, "world");
assert(first["/tacit/walls"].markers.find(({ ns }) => ns === "walls").points.length >= 8);
console.log(`${streamed} messages, ${events} events, ${poses.length} poses: as tacit replay says`);
