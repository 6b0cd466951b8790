// Foxglove's own client against the gateway: node client.mjs SERVER_PROGRAM
//
// Starts the program, which prints its port, goes through the protocol under both names of it,
// and ends with 1 and what was wrong at the first thing that is not as it should be.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const require = createRequire(import.meta.url);
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const { WebSocket } = require("ws");

const PATIENCE_MS = 10_000;
const text = (data) => new TextDecoder().decode(data);

/** The next event of that name for which `holds`. */
function next(client, event, holds = () => true) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`no ${event} came`)), PATIENCE_MS);
    const listener = (value) => {
      if (holds(value)) {
        clearTimeout(timer);
        client.off(event, listener);
        resolve(value);
      }
    };
    client.on(event, listener);
  });
}

async function check(port, protocol) {
  const ws = new WebSocket(`ws://127.0.0.1:${port}/ws/run-1`, [protocol]);
  const client = new FoxgloveClient({ ws });
  const errors = [];
  client.on("error", (error) => errors.push(error));
  const [info, channels, services, status, time] = await Promise.all([
    next(client, "serverInfo"),
    next(client, "advertise"),
    next(client, "advertiseServices"),
    next(client, "status"),
    next(client, "time"),
  ]);
  assert.equal(ws.protocol, protocol);
  assert.equal(info.name, "Interop");
  assert.equal(info.sessionId, "run-1");
  assert.ok(["time", "services", "parameters", "parametersSubscribe", "connectionGraph"].every(
    (capability) => info.capabilities.includes(capability)));
  assert.equal(status.level, 1);
  assert.equal(status.id, "agent");
  assert.ok(time.timestamp > 0n);

  const [channel] = channels;
  assert.deepEqual(
    [channel.topic, channel.encoding, channel.schemaName, channel.schemaEncoding],
    ["/tick", "cdr", "tacit/msg/Tick", "ros2msg"]);
  const subscription = client.subscribe(channel.id);
  for (let count = 0; count < 5; ++count) {
    const message = await next(client, "message");
    assert.equal(message.subscriptionId, subscription);
    const tick = message.data.getUint32(4, true);
    assert.equal(message.timestamp, BigInt(tick) * 50_000_000n);
  }
  client.unsubscribe(subscription);

  const echo = services.find((service) => service.name === "echo");
  assert.equal(JSON.parse(echo.request.schema).type, "object");
  const request = new TextEncoder().encode('{"factor":2}');
  const call = (callId, encoding) => client.sendServiceCallRequest({
    serviceId: echo.id, callId, encoding, data: new DataView(request.buffer) });
  const answer = next(client, "serviceCallResponse");
  call(1, "json");
  const response = await answer;
  assert.deepEqual([response.serviceId, response.callId, response.encoding], [echo.id, 1, "json"]);
  assert.equal(text(response.data), '{"factor":2}');
  const failure = next(client, "serviceCallFailure");
  call(2, "cdr");
  assert.equal((await failure).callId, 2);

  const values = (id) => next(client, "parameterValues", (answer) => answer.id === id);
  const all = values("all");
  client.getParameters([], "all");
  assert.deepEqual((await all).parameters.map((parameter) => parameter.name), ["alpha"]);
  client.subscribeParameterUpdates(["alpha"]);
  const told = values(undefined);
  const answered = values("set");
  client.setParameters([{ name: "alpha", value: 0.75 }], "set");
  assert.equal((await told).parameters[0].value, 0.75);
  assert.equal((await answered).parameters[0].value, 0.75);

  const graph = next(client, "connectionGraphUpdate");
  client.subscribeConnectionGraph();
  assert.deepEqual((await graph).publishedTopics, [{ name: "/tick", publisherIds: ["world"] }]);

  const closed = next(client, "close");
  client.close();
  await closed;
  assert.deepEqual(errors, []);
}

async function refused(port) {
  const ws = new WebSocket(`ws://127.0.0.1:${port}/ws`, ["mqtt"]);
  const error = await new Promise((resolve) => ws.on("error", resolve));
  assert.match(error.message, /400/);
}

const server = spawn(process.argv[2], { stdio: ["pipe", "pipe", "inherit"] });
const ended = new Promise((resolve) => server.on("exit", resolve));
try {
  const lines = createInterface({ input: server.stdout });
  const [port] = await new Promise((resolve) => lines.once("line", (line) => resolve([line])));
  for (const protocol of ["foxglove.sdk.v1", "foxglove.websocket.v1"]) {
    await check(Number(port), protocol);
    console.log(`${protocol}: as it should be`);
  }
  await refused(Number(port));
} finally {
  server.stdin.end();
  await ended;
}
assert.equal(server.exitCode, 0);
