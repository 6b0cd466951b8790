// A pretended recorded run, played by a clock as the console plays one.
const kBeat_ms = 50;
const kTick_s = 0.1;

export class Recording {
  services = ['pause', 'resume', 'speed', 'step', 'seek'];
  log = [];
  calls = [];
  listeners = new Set();
  playing = false;
  speed = 1;
  time_s = 0;
  sent_s = 0;

  constructor(id, world, ticks) {
    this.id = id;
    this.robots = world.robots;
    this.messages = world.record(ticks);
    this.end_s = ticks * kTick_s;
    this.timer = setInterval(() => this.#beat(), kBeat_ms);
    this.timer.unref();
  }

  end() {
    clearInterval(this.timer);
  }

  listen(listener) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  get replay() {
    const { end_s, time_s, playing, speed } = this;
    return { start_s: 0, end_s, time_s, playing, speed };
  }

  /** The newest of a state; of happenings nothing. */
  latest(topic) {
    if (topic === '/tacit/events') return null;
    const all = this.messages.filter((one) => one.topic === topic);
    return all.filter((one) => one.time_s <= this.time_s + 1e-6).pop() ?? all[0];
  }

  control(service, request) {
    this.calls.push([service, request]);
    if (service === 'pause') this.playing = false;
    if (service === 'resume') this.playing = true;
    if (service === 'speed') this.speed = request.factor;
    if (service === 'step') {
      this.playing = false;
      this.#play_to(this.time_s + request.ticks * kTick_s);
    }
    if (service === 'seek') setTimeout(() => this.#seek(request.time_s), kBeat_ms);
    return '';
  }

  #seek(time_s) {
    this.time_s = this.sent_s = Math.min(Math.max(time_s, 0), this.end_s);
    this.#say('time');
    for (const topic of new Set(this.messages.map((one) => one.topic))) {
      const one = this.latest(topic);
      if (one) this.#say(topic, one.value, one.time_s);
    }
    this.#say('parameter');
  }

  #beat() {
    if (this.playing) this.#play_to(this.time_s + (this.speed * kBeat_ms) / 1000);
    if (this.time_s >= this.end_s) this.playing = false;
    this.beats = (this.beats ?? 0) + 1;
    if (this.beats % 4 === 0) this.#say('parameter');
  }

  #play_to(time_s) {
    this.time_s = Math.min(time_s, this.end_s);
    for (const one of this.messages) {
      if (one.time_s > this.sent_s + 1e-6 && one.time_s <= this.time_s + 1e-6) {
        this.#say(one.topic, one.value, one.time_s);
      }
    }
    this.sent_s = this.time_s;
    this.#say('time');
  }

  #say(topic, value, time_s = this.time_s) {
    for (const listener of this.listeners) listener(topic, value, time_s);
  }
}
