// A run's socket: the Foxglove protocol, version 1, as a server speaks it.
import { need } from './packages.mjs';
import { schema_of, writer_of } from './schemas.mjs';

const { WebSocketServer } = need('ws');
const kProtocols = ['foxglove.sdk.v1', 'foxglove.websocket.v1'];
const kServices = [
  'pause', 'resume', 'step', 'speed', 'stop', 'proceed', 'skip_goal', 'steer', 'let_go',
];

export function attach_sockets(http, world_called) {
  const sockets = new WebSocketServer({
    noServer: true,
    handleProtocols: (offered) => kProtocols.find((one) => offered.has(one)) ?? false,
  });
  http.on('upgrade', (request, socket, head) => {
    const run = /^\/ws(?:\/([^/?]+))?$/.exec(request.url)?.[1];
    const world = world_called(run);
    if (!world) return socket.end('HTTP/1.1 404 Not Found\r\n\r\n');
    sockets.handleUpgrade(request, socket, head, (ws) => new Session(ws, world));
  });
  return { drop_all: () => sockets.clients.forEach((ws) => ws.terminate()) };
}

class Session {
  constructor(ws, world) {
    Object.assign(this, { ws, world, subscriptions: new Map(), channels: new Map(), followed: false });
    this.services = world.services ?? kServices;
    this.say({
      op: 'serverInfo',
      name: 'tacit',
      capabilities: ['services', 'time', 'parameters', 'parametersSubscribe'],
      supportedEncodings: ['json'],
      sessionId: world.id,
    });
    this.advertise();
    this.say({
      op: 'advertiseServices',
      services: this.services.map((name, i) => ({
        id: i + 1,
        name,
        type: `tacit/${name}`,
        requestSchema: '{"type":"object"}',
        responseSchema: '{"type":"object"}',
      })),
    });
    const leave = world.listen((topic, value, time_s) => this.hear(topic, value, time_s));
    ws.on('close', leave);
    ws.on('message', (data, binary) => (binary ? this.service(data) : this.text(JSON.parse(data))));
  }

  advertise() {
    const topics = [
      ['/tacit/world_view', 'WorldView'],
      ['/tacit/status', 'RunStatus'],
      ['/tacit/events', 'EventBatch'],
      ...this.world.robots.map((r) => [`/tacit/robot_${r.robot}/telemetry`, 'Telemetry']),
    ];
    const channels = topics.map(([topic, type], i) => {
      this.channels.set(topic, { id: i + 1, write: writer_of(type) });
      return {
        id: i + 1,
        topic,
        encoding: 'cdr',
        schemaName: `tacit_wire/msg/${type}`,
        schema: schema_of(type),
        schemaEncoding: 'ros2msg',
      };
    });
    this.say({ op: 'advertise', channels });
  }

  text(message) {
    if (message.op === 'subscribeParameterUpdates') this.followed = true;
    if (message.op === 'getParameters') this.parameters();
    if (message.op === 'subscribe') {
      for (const { id, channelId } of message.subscriptions) {
        this.subscriptions.set(channelId, id);
        this.latest(channelId);
        if (this.channels.get('/tacit/events')?.id === channelId) this.catch_up();
      }
    }
    if (message.op === 'unsubscribe') {
      for (const [channel, id] of this.subscriptions) {
        if (message.subscriptionIds.includes(id)) this.subscriptions.delete(channel);
      }
    }
  }

  hear(topic, value, time_s) {
    if (topic === 'time') this.time(time_s);
    else if (topic === 'parameter') this.followed && this.parameters();
    else this.send(topic, value, time_s);
  }

  parameters() {
    const { replay } = this.world;
    if (replay) this.say({ op: 'parameterValues', parameters: [{ name: 'replay', value: replay }] });
  }

  latest(channel) {
    const topic = [...this.channels].find(([, { id }]) => id === channel)?.[0];
    const one = this.world.latest?.(topic);
    if (one) this.send(topic, one.value, one.time_s);
  }

  time(time_s) {
    if (this.ws.readyState !== 1) return;
    const head = Buffer.alloc(9);
    head.writeUInt8(2, 0);
    head.writeBigUInt64LE(BigInt(Math.round(time_s * 1e9)), 1);
    this.ws.send(head);
  }

  catch_up() {
    if (this.world.log.length === 0) return;
    this.send('/tacit/events', { first: 0n, events: this.world.log.slice(0, 256) }, 0);
  }

  service(data) {
    const id = data.readUInt32LE(1);
    const call = data.readUInt32LE(5);
    const length = data.readUInt32LE(9);
    const request = JSON.parse(data.subarray(13 + length).toString() || '{}');
    const refusal = this.world.control(this.services[id - 1], request);
    if (refusal) {
      return this.say({ op: 'serviceCallFailure', serviceId: id, callId: call, message: refusal });
    }
    const head = Buffer.alloc(13);
    head.writeUInt8(3, 0);
    head.writeUInt32LE(id, 1);
    head.writeUInt32LE(call, 5);
    head.writeUInt32LE(4, 9);
    this.ws.send(Buffer.concat([head, Buffer.from('json{}')]));
  }

  send(topic, value, time_s) {
    const channel = this.channels.get(topic);
    const subscription = this.subscriptions.get(channel?.id);
    if (subscription === undefined || this.ws.readyState !== 1) return;
    const head = Buffer.alloc(13);
    head.writeUInt8(1, 0);
    head.writeUInt32LE(subscription, 1);
    head.writeBigUInt64LE(BigInt(Math.round(time_s * 1e9)), 5);
    this.ws.send(Buffer.concat([head, channel.write(value)]));
  }

  say(message) {
    this.ws.send(JSON.stringify(message));
  }
}
