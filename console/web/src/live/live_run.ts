import { Connection, type Link } from '@/live/connection';
import { Jump, type Playing } from '@/live/jump';
import { Trail } from '@/live/trail';
import {
  kEventKinds,
  kPhases,
  type Event,
  type EventBatch,
  type Phase,
  type RunStatus,
  type Telemetry,
  type ViewedRobot,
  type WorldView,
} from '@/wire/words';

/** Older than this, what is shown is stale. */
export const kStaleAfter_ms = 1000;
const kMostSamples = 600;
const kMostEvents = 20_000;
const kNews_ms = 200;
const kRateOver_ms = 2000;

/** One look into a brain. `names` is shared between samples of the same assemblage. */
export interface GainSample {
  time_s: number;
  situation: string;
  names: string[];
  gains: Float32Array;
}

export interface LoggedEvent {
  index: number;
  event: Event;
}

/** How an agent answers. */
export interface Health {
  robot: number;
  /** Telemetry a second over the last few seconds. */
  rate_hz: number;
  heard_ms: number;
  decisions: number;
  duplicates: number;
  rejected: number;
  late: number;
}

interface Heard {
  telemetry: Telemetry;
  at_ms: number;
  times: number[];
  late: number;
}

/** All that is known of a run that goes on, or of a recorded one that is played. Told twice: each frame for what moves, and a few times
 * a second for what is read. */
export class LiveRun {
  view: WorldView | null = null;
  status: RunStatus | null = null;
  link: Link = 'connecting';
  stale = false;
  trouble = '';
  readonly events: LoggedEvent[] = [];
  missed_events = 0;
  readonly trails = new Map<number, Trail>();
  /** Of a recorded run: all events that were heard, over all jumps, in their order. */
  readonly heard_events: LoggedEvent[] = [];
  /** How a recorded run is played. */
  playing: Playing | null = null;
  /** Where the clock of a recorded run stands. */
  time_s = 0;
  /** Of the newest view, by number. */
  readonly robots = new Map<number, ViewedRobot>();

  #heard = new Map<number, Heard>();
  #samples = new Map<number, GainSample[]>();
  #layouts = new Map<string, string[]>();
  #connection: Connection;
  #on_frame = new Set<() => void>();
  #on_news = new Set<() => void>();
  #version = 0;
  #news_timer: ReturnType<typeof setTimeout> | undefined;
  #stale_timer: ReturnType<typeof setInterval> | undefined;
  #heard_ms = 0;
  #next_event = 0;
  #tick_s = 0.1;
  #rate = { wall_ms: 0, time_s: 0, factor: 0 };
  #jump: Jump | null = null;
  /** What was sent before this is of before a jump. */
  #not_before_s = 0;

  constructor(
    url: string,
    private readonly now: () => number = () => performance.now(),
    readonly recorded = false,
  ) {
    const hearing = {
      message: (topic: string, value: unknown, time_s: number) => this.take(topic, value, time_s),
      time: (time_s: number) => this.take_time(time_s),
      parameter: (name: string, value: unknown) => {
        if (name === 'replay') this.take_playing(value as Playing);
      },
      link: (link: Link) => {
        this.link = link;
        if (link !== 'open') this.#jump?.end();
        this.#frame();
        this.#news();
      },
      session: () => this.#forget(),
      trouble: (text: string) => {
        this.trouble = text;
        this.#news();
      },
    };
    this.#connection = new Connection(url, hearing, recorded ? ['replay'] : []);
  }

  start(): void {
    this.#heard_ms = this.now();
    this.#connection.open();
    this.#stale_timer = setInterval(() => this.#judge_age(), 250);
  }

  stop(): void {
    clearInterval(this.#stale_timer);
    clearTimeout(this.#news_timer);
    this.#connection.close();
  }

  retry(): void {
    this.#connection.retry();
  }

  async call(service: string, request: object = {}): Promise<unknown> {
    const answer = await this.#connection.call(service, request);
    // Told a moment later; a key that is pressed again before counts too.
    if (service === 'pause' || service === 'resume') this.#expect({ playing: service === 'resume' });
    return answer;
  }

  /** Moves a recorded run. Done when what comes is of then. */
  async seek(time_s: number): Promise<void> {
    const { start_s = 0, end_s = time_s } = this.playing ?? {};
    const to_s = Math.min(Math.max(time_s, start_s), end_s);
    this.#jump?.end();
    const jump = new Jump(this.time_s, to_s);
    this.#jump = jump;
    try {
      await this.#connection.call('seek', { time_s: to_s });
      await jump.ended;
    } finally {
      jump.end();
      if (this.#jump === jump) this.#jump = null;
    }
  }

  get phase(): Phase | null {
    return this.status ? (kPhases[this.status.phase] ?? null) : null;
  }

  /** A live run that has come to its end. */
  get over(): boolean {
    return !this.recorded && (this.phase === 'ended' || this.phase === 'stopped');
  }

  get paused(): boolean {
    return this.recorded ? !this.playing?.playing : this.phase === 'paused';
  }

  /** The events that people are shown. */
  get log(): readonly LoggedEvent[] {
    return this.recorded ? this.heard_events : this.events;
  }

  /** Simulated seconds a second of real time, as measured; 0 before it is known. */
  get real_time_factor(): number {
    return this.#rate.factor;
  }

  get tick_s(): number {
    return this.#tick_s;
  }

  telemetry(robot: number): Telemetry | null {
    return this.#heard.get(robot)?.telemetry ?? null;
  }

  samples(robot: number): readonly GainSample[] {
    return this.#samples.get(robot) ?? [];
  }

  health(): Health[] {
    const now = this.#clock_ms();
    return [...this.#heard.entries()]
      .map(([robot, heard]) => ({
        robot,
        rate_hz: rate_of(heard.times, now),
        heard_ms: now - heard.at_ms,
        decisions: Number(heard.telemetry.decisions),
        duplicates: Number(heard.telemetry.duplicates),
        rejected: Number(heard.telemetry.rejected),
        late: heard.late,
      }))
      .sort((a, b) => a.robot - b.robot);
  }

  /** Of a `Telemetry` channel or one of the run's; others are left. */
  take(topic: string, value: unknown, time_s = Infinity): void {
    if (this.#jump || time_s < this.#not_before_s) return;
    if (topic.endsWith('/world_view')) this.#take_view(value as WorldView);
    else if (topic.endsWith('/status')) this.#take_status(value as RunStatus);
    else if (topic.endsWith('/events')) this.#take_events(value as EventBatch);
    else if (topic.endsWith('/telemetry')) this.#take_telemetry(value as Telemetry);
    else return;
    this.#hear();
  }

  take_time(time_s: number): void {
    if (!this.recorded) return;
    this.time_s = time_s;
    if (this.#jump?.is_done_at(time_s)) {
      this.#not_before_s = this.#jump.oldest_s;
      this.#jump.end();
      this.#jump = null;
      this.#forget_past();
    }
    this.#hear();
  }

  take_playing(playing: Playing): void {
    if (!this.#jump && (!this.playing || !playing.playing)) this.time_s = playing.time_s;
    this.playing = playing;
    this.#hear();
  }

  readonly on_frame = (listener: () => void): (() => void) => {
    this.#on_frame.add(listener);
    return () => this.#on_frame.delete(listener);
  };
  readonly on_news = (listener: () => void): (() => void) => {
    this.#on_news.add(listener);
    return () => this.#on_news.delete(listener);
  };
  readonly version = (): number => this.#version;

  clear_trails(): void {
    for (const trail of this.trails.values()) trail.clear();
    this.#frame();
  }

  #expect(change: Partial<Playing>): void {
    if (this.playing) this.take_playing({ ...this.playing, time_s: this.time_s, ...change });
  }

  #hear(): void {
    this.#heard_ms = this.now();
    if (this.stale) {
      this.stale = false;
      this.#frame();
    }
    this.#news();
  }

  /** Agents of a recorded run are judged by the time in it. */
  #clock_ms(): number {
    return this.recorded ? 1000 * this.time_s : this.now();
  }

  #take_view(view: WorldView): void {
    // Somebody else has moved the recording back.
    if (this.recorded && this.view && view.time_s < this.view.time_s) this.#forget_past();
    this.view = view;
    this.robots.clear();
    for (const robot of view.robots) {
      this.robots.set(robot.robot, robot);
      let trail = this.trails.get(robot.robot);
      if (!trail) this.trails.set(robot.robot, (trail = new Trail()));
      if (robot.present) trail.add(robot.x_m, robot.y_m, view.time_s);
    }
    if (view.tick > 0n) this.#tick_s = view.time_s / Number(view.tick);
    this.#measure(view.time_s);
    this.#frame();
  }

  #measure(time_s: number): void {
    const now = this.now();
    if (this.#rate.wall_ms === 0 || time_s < this.#rate.time_s) {
      this.#rate = { wall_ms: now, time_s, factor: 0 };
      return;
    }
    if (now - this.#rate.wall_ms < kRateOver_ms) return;
    const factor = (1000 * (time_s - this.#rate.time_s)) / (now - this.#rate.wall_ms);
    this.#rate = { wall_ms: now, time_s, factor };
  }

  #take_status(status: RunStatus): void {
    this.status = status;
  }

  #take_events(batch: EventBatch): void {
    const first = Number(batch.first);
    if (this.#next_event > 0 && first > this.#next_event) this.missed_events += first - this.#next_event;
    batch.events.forEach((event, i) => {
      const index = first + i;
      if (index < this.#next_event) return;
      this.#next_event = index + 1;
      this.events.push({ index, event });
      if (this.recorded) insert(this.heard_events, { index, event });
      if (kEventKinds[event.kind] === 'late') {
        const heard = this.#heard.get(event.robot);
        if (heard) heard.late += 1;
      }
    });
    if (this.events.length > kMostEvents) this.events.splice(0, this.events.length - kMostEvents);
  }

  #take_telemetry(telemetry: Telemetry): void {
    const now = this.#clock_ms();
    const heard = this.#heard.get(telemetry.robot);
    const times = heard?.times ?? [];
    times.push(now);
    if (times.length > 30) times.shift();
    this.#heard.set(telemetry.robot, { telemetry, at_ms: now, times, late: heard?.late ?? 0 });
    this.#remember(telemetry);
  }

  #remember(telemetry: Telemetry): void {
    const key = telemetry.shares.map((share) => share.name).join();
    let names = this.#layouts.get(key);
    if (!names) this.#layouts.set(key, (names = telemetry.shares.map((share) => share.name)));
    let samples = this.#samples.get(telemetry.robot);
    if (!samples) this.#samples.set(telemetry.robot, (samples = []));
    const time_s = Number(telemetry.tick) * this.#tick_s;
    const last = samples[samples.length - 1];
    if (last && time_s <= last.time_s) return;
    samples.push({
      time_s,
      situation: telemetry.situation,
      names,
      gains: Float32Array.from(telemetry.shares, (share) => share.gain),
    });
    if (samples.length > kMostSamples) samples.shift();
  }

  #forget(): void {
    this.view = null;
    this.status = null;
    this.robots.clear();
    this.heard_events.length = 0;
    this.#not_before_s = 0;
    this.#forget_past();
    this.#news();
  }

  /** What a moment of a run does not say by itself. */
  #forget_past(): void {
    this.events.length = 0;
    this.missed_events = 0;
    this.#next_event = 0;
    this.trails.clear();
    this.#heard.clear();
    this.#samples.clear();
    this.#rate = { wall_ms: 0, time_s: 0, factor: 0 };
  }

  #judge_age(): void {
    const rests = this.over || (this.recorded && this.paused && this.link === 'open');
    const stale = !rests && this.now() - this.#heard_ms > kStaleAfter_ms;
    if (stale === this.stale) return;
    this.stale = stale;
    this.#frame();
    this.#news();
  }

  #frame(): void {
    for (const listener of this.#on_frame) listener();
  }

  #news(): void {
    if (this.#news_timer !== undefined) return;
    this.#news_timer = setTimeout(() => {
      this.#news_timer = undefined;
      this.#version += 1;
      for (const listener of this.#on_news) listener();
    }, kNews_ms);
  }
}

/** Keeps the order, and leaves what is there. */
function insert(events: LoggedEvent[], one: LoggedEvent): void {
  let at = events.length;
  while (at > 0 && events[at - 1]!.index > one.index) --at;
  if (events[at - 1]?.index === one.index || events.length >= kMostEvents) return;
  events.splice(at, 0, one);
}

function rate_of(times: number[], now: number): number {
  const first = times[0];
  if (first === undefined || times.length < 2) return 0;
  return (1000 * (times.length - 1)) / Math.max(now - first, 1);
}
