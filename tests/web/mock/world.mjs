// A pretended run: robots that go round, enemies that come, mines that get fewer.
const kRoles = ['Forager', 'Soldier', 'Mechanic'];
const kStates = {
  Forager: ['LookForMine', 'MoveToMine', 'CarryMine'],
  Soldier: ['Wander', 'InterceptEnemy'],
  Mechanic: ['StayNear', 'MoveToDisabled'],
};
const kSituations = [
  'AllClear', 'ClearToEnemy', 'FlankingEnemy', 'SoldierNeedsHelp', 'NoSoldiersNeedHelp',
];
const kSchemas = ['MoveToTarget', 'InterceptEnemies', 'AvoidSoldiers', 'AvoidObstacles', 'Noise'];
const kKinds = { created: 0, intercepted: 1, collision: 3, taken: 10, stored: 12, disabled: 13,
  revived: 14, over: 15, begun: 16, entered: 23, ended: 8, checkpoint: 7 };
const kPhases = ['gathering', 'running', 'paused', 'ended', 'stopped'];
const kEvent = {
  x_m: 0, y_m: 0, distance_to_target_m: 0, mean_distance_to_target_m: 0, mean_speed_mps: 0,
  joystick_x: 0, joystick_y: 0, tick: 0n, state_digest: 0n, score_ticks: 0n, number: 0, left: 0,
  other: 0, robot: 0, other_robot: 0, kind: 0, detail: 0, word: '',
};

/** Chance that is the same each time. */
function chance(seed) {
  let state = seed >>> 0 || 1;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

export class World {
  constructor({ id, robots = 6, size_m = 60, roles = true, lasts_ticks = 36_000, centre = [0, 0] }) {
    Object.assign(this, { id, size_m, roles, centre, last_tick: lasts_ticks });
    this.random = chance(7);
    this.tick = 0;
    this.phase = 'running';
    this.speed = 1;
    this.log = [];
    this.listeners = new Set();
    this.calls = [];
    this.robots = Array.from({ length: robots }, (_, i) => this.#robot(i));
    this.enemies = [];
    this.mines = Array.from({ length: roles ? 12 : 0 }, (_, i) => ({
      mine: i + 1, x_m: this.#place(0), y_m: this.#place(1),
    }));
    this.objects = [[4, 'green', 3], [9, 'brown', 0.4]].map(([colour, , radius_m], i) => ({
      x_m: this.#place(0), y_m: this.#place(1), radius_m, number: i + 1,
      colour: [6, 9][i],
    }));
    this.#tell('begun', { left: this.mines.length });
    this.timer = setInterval(() => this.#beat(), 50);
    this.timer.unref();
  }

  end() {
    clearInterval(this.timer);
  }

  listen(listener) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** All that it says in so many ticks, at once. */
  record(ticks) {
    const said = [];
    const leave = this.listen((topic, value, time_s) => said.push({ topic, value: structuredClone(value), time_s }));
    this.end();
    this.#send('/tacit/events', { first: 0n, events: [...this.log] });
    for (this.beats = 0; this.beats < ticks; ++this.beats) {
      this.#publish();
      this.#step();
    }
    this.phase = 'ended';
    this.beats = 4;
    this.#publish();
    leave();
    return said;
  }

  /** An empty answer, or why not. */
  control(service, request) {
    this.calls.push([service, request]);
    if (service === 'pause') this.phase = 'paused';
    if (service === 'resume') this.phase = 'running';
    if (service === 'step') {
      if (this.phase !== 'paused') return 'a run is stepped when it is paused';
      for (let i = 0; i < request.ticks; ++i) this.#step();
      this.#publish();
    }
    if (service === 'speed') this.speed = request.factor;
    if (service === 'stop') this.phase = 'stopped';
    return '';
  }

  #place(axis) {
    return this.centre[axis] + (this.random() - 0.5) * this.size_m * 0.9;
  }

  #robot(i) {
    return {
      robot: i + 1, x_m: this.#place(0), y_m: this.#place(1), heading: this.random() * 6.28,
      turn: 0, able: 1, present: 1, holding: 0, colour: 1, role: this.roles ? kRoles[i % 3] : '',
    };
  }

  #beat() {
    if (this.phase === 'running') {
      const ticks = this.speed === 0 ? 20 : Math.max(1, Math.round(this.speed / 2));
      for (let i = 0; i < ticks; ++i) this.#step();
    }
    this.beats = (this.beats ?? 0) + 1;
    this.#publish();
  }

  #step() {
    this.tick += 1;
    for (const robot of this.robots) this.#move(robot);
    for (const enemy of this.enemies) {
      enemy.x_m += (this.centre[0] - enemy.x_m) * 0.004;
      enemy.y_m += (this.centre[1] - enemy.y_m) * 0.004;
    }
    if (this.tick % 120 === 20) this.#enemy_comes();
    if (this.tick % 120 === 110 && this.enemies.length > 3) this.#enemy_goes();
    if (this.tick % 200 === 150) this.#something_happens();
    if (this.tick % 100 === 0) this.#tell('checkpoint', { number: this.enemies.length });
  }

  #move(robot) {
    if (!robot.able || !robot.present) return;
    robot.turn = Math.max(-0.3, Math.min(0.3, robot.turn + (this.random() - 0.5) * 0.1));
    const x = robot.x_m - this.centre[0];
    const y = robot.y_m - this.centre[1];
    if (Math.hypot(x, y) > this.size_m * 0.45) {
      const home = Math.atan2(-y, -x) - robot.heading;
      robot.turn = 0.2 * Math.sign(Math.sin(home));
    }
    robot.heading += robot.turn * 0.3;
    robot.x_m += 0.1 * Math.cos(robot.heading);
    robot.y_m += 0.1 * Math.sin(robot.heading);
  }

  #enemy_comes() {
    const enemy = { enemy: (this.next_enemy = (this.next_enemy ?? 0) + 1), kind: this.next_enemy % 3,
      x_m: this.#place(0), y_m: this.#place(1) };
    this.enemies.push(enemy);
    this.#tell('created', { number: enemy.enemy, detail: enemy.kind, x_m: enemy.x_m, y_m: enemy.y_m });
  }

  #enemy_goes() {
    const enemy = this.enemies.shift();
    const robot = 1 + (enemy.enemy % this.robots.length);
    this.#tell('intercepted', { number: enemy.enemy, robot, distance_to_target_m: 12.5 });
  }

  #something_happens() {
    const robot = this.robots[Math.floor(this.random() * this.robots.length)];
    if (!robot.able) {
      robot.able = 1;
      this.#tell('revived', { robot: robot.robot, other_robot: 1 + (robot.robot % this.robots.length) });
    } else if (this.mines.length > 0 && robot.holding) {
      robot.holding = 0;
      this.#tell('stored', { robot: robot.robot, number: this.mines.length, left: this.mines.length });
    } else if (this.mines.length > 0 && this.random() < 0.6) {
      robot.holding = 1;
      this.#tell('taken', { robot: robot.robot, number: this.mines.pop().mine });
    } else {
      robot.able = 0;
      this.#tell('disabled', { robot: robot.robot, detail: 0 });
    }
  }

  #tell(kind, more) {
    const event = { ...kEvent, tick: BigInt(this.tick), kind: kKinds[kind], ...more };
    this.log.push(event);
    if (this.listeners.size > 0) {
      this.#send('/tacit/events', { first: BigInt(this.log.length - 1), events: [event] });
    }
  }

  #publish() {
    if (this.listeners.size === 0) return;
    const robots = this.robots.map((r) => ({
      ...r, heading_cos: Math.cos(r.heading), heading_sin: Math.sin(r.heading),
      velocity_x_mps: Math.cos(r.heading), velocity_y_mps: Math.sin(r.heading),
    }));
    this.#send('/tacit/world_view', {
      time_s: this.tick * 0.1, tick: BigInt(this.tick), robots,
      enemies: this.enemies, mines: this.mines, objects: this.objects,
    });
    if (this.beats % 4 === 0) this.#send('/tacit/status', this.#status());
    if (this.beats % 2 === 0) for (const robot of this.robots) this.#telemetry(robot);
  }

  #status() {
    return {
      wall_s: this.beats / 20, first_tick_s: 0.8, tick: BigInt(this.tick),
      last_tick: BigInt(this.last_tick), events: BigInt(this.log.length), resent: 0, rejected: 0,
      robots: this.robots.length, present: this.robots.length, phase: kPhases.indexOf(this.phase),
      repeatable: 1,
    };
  }

  #telemetry(robot) {
    const slow = Math.floor(this.tick / 60 + robot.robot) % kSituations.length;
    const states = kStates[robot.role] ?? ['AlongHallway', 'EnterRoom', 'Survey'];
    const gains = kSchemas.map((_, i) => 0.8 + 0.7 * Math.sin(this.tick / (40 + 12 * i) + i + robot.robot));
    this.#send(`/tacit/robot_${robot.robot}/telemetry`, {
      tick: BigInt(this.tick), decisions: BigInt(this.tick), duplicates: 0n, rejected: 0n,
      robot: robot.robot, learner: robot.role ? 'q' : 'lm', role: robot.role,
      situation: kSituations[slow], state: states[slow % states.length],
      shares: kSchemas.map((name, i) => ({
        name, gain: gains[i], push_x: Math.cos(this.tick / 30 + i * 1.3),
        push_y: Math.sin(this.tick / 30 + i * 1.3),
      })),
    });
  }

  #send(topic, value) {
    for (const listener of this.listeners) listener(topic, value, this.tick * 0.1);
  }
}
