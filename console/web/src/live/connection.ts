import { FoxgloveClient, type Channel, type Service } from '@foxglove/ws-protocol';

import { unpacker, type Unpack } from '@/wire/unpack';

/** The protocol has had two names; the bytes are the same. */
const kProtocols = ['foxglove.sdk.v1', FoxgloveClient.SUPPORTED_SUBPROTOCOL];
const kFirstWait_ms = 500;
const kLongestWait_ms = 5000;
const kAnswerWithin_ms = 5000;

export type Link = 'connecting' | 'open' | 'waiting' | 'closed';

export interface Hearing {
  /** One message, unpacked, and the simulated time of its sending. */
  message(topic: string, value: unknown, time_s: number): void;
  /** Where the session's clock stands. */
  time(time_s: number): void;
  parameter(name: string, value: unknown): void;
  link(state: Link): void;
  /** A run that was not the one before: forget what was known. */
  session(id: string): void;
  trouble(text: string): void;
}

interface Call {
  done(answer: unknown): void;
  failed(error: Error): void;
  timer: ReturnType<typeof setTimeout>;
}

/** The socket of one run: hears every channel, calls services, comes back by itself. */
export class Connection {
  #client: FoxgloveClient | null = null;
  #link: Link = 'closed';
  #wait_ms = kFirstWait_ms;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #channels = new Map<number, { topic: string; subscription: number; unpack: Unpack }>();
  #by_subscription = new Map<number, number>();
  #services = new Map<string, Service>();
  #calls = new Map<number, Call>();
  #next_call = 1;
  #session = '';

  constructor(
    private readonly url: string,
    private readonly hearing: Hearing,
    /** Those that are followed. */
    private readonly parameters: string[] = [],
  ) {}

  open(): void {
    this.#say('connecting');
    const client = new FoxgloveClient({ ws: new WebSocket(this.url, kProtocols) });
    this.#client = client;
    client.on('open', () => {
      this.#wait_ms = kFirstWait_ms;
      this.#say('open');
    });
    client.on('close', () => this.#lost(client));
    client.on('error', () => {
      // A close follows, which is what counts.
    });
    client.on('serverInfo', (info) => {
      const id = info.sessionId ?? '';
      if (id !== this.#session) this.hearing.session(id);
      this.#session = id;
      if (this.parameters.length > 0) {
        client.subscribeParameterUpdates(this.parameters);
        client.getParameters(this.parameters);
      }
    });
    client.on('time', ({ timestamp }) => this.hearing.time(seconds(timestamp)));
    client.on('parameterValues', ({ parameters }) => {
      for (const { name, value } of parameters) this.hearing.parameter(name, value);
    });
    client.on('status', (status) => {
      if (status.level > 0) this.hearing.trouble(status.message);
    });
    client.on('advertise', (channels) => channels.forEach((channel) => this.#hear(client, channel)));
    client.on('unadvertise', (ids) => ids.forEach((id) => this.#forget(client, id)));
    client.on('advertiseServices', (services) => {
      for (const service of services) this.#services.set(service.name.replace(/^.*\//, ''), service);
    });
    client.on('message', ({ subscriptionId, timestamp, data }) => {
      const channel = this.#channels.get(this.#by_subscription.get(subscriptionId) ?? -1);
      if (channel) this.#unpack(channel.topic, channel.unpack, view_of(data), seconds(timestamp));
    });
    client.on('serviceCallResponse', ({ callId, data }) => {
      const text = new TextDecoder().decode(data);
      this.#answer(callId, (call) => call.done(text === '' ? null : JSON.parse(text)));
    });
    client.on('serviceCallFailure', ({ callId, message }) =>
      this.#answer(callId, (call) => call.failed(new Error(message))),
    );
  }

  close(): void {
    clearTimeout(this.#timer);
    const client = this.#client;
    this.#client = null;
    client?.close();
    this.#drop('the connection was closed');
    this.#say('closed');
  }

  /** Asks at once instead of at the end of the wait. */
  retry(): void {
    if (this.#link !== 'waiting') return;
    clearTimeout(this.#timer);
    this.open();
  }

  call(service: string, request: object): Promise<unknown> {
    const offered = this.#services.get(service);
    const client = this.#client;
    if (!client || this.#link !== 'open') return Promise.reject(new Error('there is no connection'));
    if (!offered) return Promise.reject(new Error(`this run does not offer "${service}"`));
    const callId = this.#next_call++;
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    return new Promise((done, failed) => {
      const timer = setTimeout(
        () => this.#answer(callId, (call) => call.failed(new Error('no answer came'))),
        kAnswerWithin_ms,
      );
      this.#calls.set(callId, { done, failed, timer });
      client.sendServiceCallRequest({
        serviceId: offered.id,
        callId,
        encoding: 'json',
        data: new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength),
      });
    });
  }

  #hear(client: FoxgloveClient, channel: Channel): void {
    if (channel.encoding !== 'cdr' || (channel.schemaEncoding ?? 'ros2msg') !== 'ros2msg') return;
    try {
      const unpack = unpacker(channel.schema);
      const subscription = client.subscribe(channel.id);
      this.#channels.set(channel.id, { topic: channel.topic, subscription, unpack });
      this.#by_subscription.set(subscription, channel.id);
    } catch (error) {
      this.hearing.trouble(`The schema of ${channel.topic} cannot be read: ${String(error)}`);
    }
  }

  #forget(client: FoxgloveClient, id: number): void {
    const channel = this.#channels.get(id);
    if (!channel) return;
    client.unsubscribe(channel.subscription);
    this.#by_subscription.delete(channel.subscription);
    this.#channels.delete(id);
  }

  #unpack(topic: string, unpack: Unpack, data: DataView, time_s: number): void {
    let value: unknown;
    try {
      value = unpack(data);
    } catch (error) {
      this.hearing.trouble(`A sample of ${topic} cannot be read: ${String(error)}`);
      return;
    }
    this.hearing.message(topic, value, time_s);
  }

  #answer(id: number, say: (call: Call) => void): void {
    const call = this.#calls.get(id);
    if (!call) return;
    this.#calls.delete(id);
    clearTimeout(call.timer);
    say(call);
  }

  #lost(client: FoxgloveClient): void {
    if (client !== this.#client) return;
    this.#client = null;
    this.#drop('the connection was lost');
    this.#say('waiting');
    this.#timer = setTimeout(() => this.open(), this.#wait_ms);
    this.#wait_ms = Math.min(2 * this.#wait_ms, kLongestWait_ms);
  }

  #drop(why: string): void {
    this.#channels.clear();
    this.#by_subscription.clear();
    this.#services.clear();
    for (const id of [...this.#calls.keys()]) this.#answer(id, (call) => call.failed(new Error(why)));
  }

  #say(link: Link): void {
    this.#link = link;
    this.hearing.link(link);
  }
}

function seconds(time_ns: bigint): number {
  return Number(time_ns) / 1e9;
}

function view_of(bytes: ArrayBufferView): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}
