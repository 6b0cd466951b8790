import type { LiveRun } from '@/live/live_run';
import type { Camera } from '@/map/camera';
import { kind_of, words_of_robot } from '@/operate/glyphs';
import {
  kColours, kEnemyKinds, type ViewedEnemy, type ViewedMine, type ViewedObject, type ViewedRobot,
} from '@/wire/words';

const kSvg = 'http://www.w3.org/2000/svg';

function element(name: string, attributes: Record<string, string> = {}): SVGElement {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

/** Sets what is not so already: most of what is drawn at 20 Hz does not change. */
function set(target: Element, name: string, value: string): void {
  if (target.getAttribute(name) !== value) target.setAttribute(name, value);
}

/** Elements by number, made and taken away as things come and go. */
class Pool<T> {
  readonly elements = new Map<number, SVGElement>();

  constructor(
    private readonly parent: SVGElement,
    private readonly number_of: (thing: T) => number,
    private readonly make: (thing: T) => SVGElement,
  ) {}

  show(things: readonly T[], update: (made: SVGElement, thing: T) => void): void {
    const gone = new Set(this.elements.keys());
    for (const thing of things) {
      const number = this.number_of(thing);
      let made = this.elements.get(number);
      if (!made) {
        made = this.make(thing);
        this.elements.set(number, made);
        this.parent.append(made);
      }
      gone.delete(number);
      update(made, thing);
    }
    for (const number of gone) {
      this.elements.get(number)?.remove();
      this.elements.delete(number);
    }
  }
}

export interface LiveLook {
  selected: number | null;
  labels: boolean;
}

/** What moves in a run, as SVG elements that are changed in place, past React: at 20 Hz and a
 * hundred robots it must cost little. */
export class LiveLayer {
  #robots: Pool<ViewedRobot>;
  #enemies: Pool<ViewedEnemy>;
  #mines: Pool<ViewedMine>;
  #objects: Pool<ViewedObject>;

  constructor(things: SVGElement, robots: SVGElement) {
    this.#objects = new Pool(things, (o) => o.number, make_object);
    this.#mines = new Pool(things, (m) => m.mine, make_mine);
    this.#enemies = new Pool(things, (e) => e.enemy, make_enemy);
    this.#robots = new Pool(robots, (r) => r.robot, make_robot);
  }

  show(run: LiveRun, camera: Camera, look: LiveLook): void {
    const { view } = run;
    const at = (thing: { x_m: number; y_m: number }) => {
      const [x, y] = camera.to_screen(thing.x_m, thing.y_m);
      return `translate(${x.toFixed(1)} ${y.toFixed(1)})`;
    };
    this.#objects.show(view?.objects ?? [], (made, object) => {
      set(made, 'transform', at(object));
      const side = Math.max(object.radius_m * camera.px_per_m, 5);
      set(made.firstElementChild!, 'r', side.toFixed(1));
    });
    this.#mines.show(view?.mines ?? [], (made, mine) => set(made, 'transform', at(mine)));
    this.#enemies.show(view?.enemies ?? [], (made, enemy) => set(made, 'transform', at(enemy)));
    const first = view?.robots[0]?.robot;
    this.#robots.show(view?.robots ?? [], (made, robot) => {
      set(made, 'transform', at(robot));
      show_robot(made, robot, run, look, robot.robot === (look.selected ?? first));
    });
  }

  focus(robot: number): void {
    this.#robots.elements.get(robot)?.focus();
  }
}

function make_robot(robot: ViewedRobot): SVGElement {
  const made = element('g', { role: 'option', 'data-robot': String(robot.robot), 'data-own-pointer': '' });
  made.append(
    element('circle', { r: '16', class: 'hit' }),
    element('circle', { r: '15', class: 'ring' }),
    element('use', { class: 'body' }),
    element('use', { class: 'cross', href: '#glyph-disabled' }),
    element('circle', { class: 'load', r: '4', cx: '9', cy: '-9' }),
  );
  const label = element('text', { x: '12', y: '-9' });
  label.textContent = String(robot.robot);
  made.append(label);
  return made;
}

function show_robot(made: SVGElement, robot: ViewedRobot, run: LiveRun, look: LiveLook, first: boolean): void {
  const telemetry = run.telemetry(robot.robot);
  const kind = kind_of(robot, telemetry);
  const selected = robot.robot === look.selected;
  const classes = ['robot', kind];
  if (!robot.able) classes.push('disabled');
  if (!robot.present) classes.push('absent');
  if (robot.holding) classes.push('holding');
  if (look.labels || selected) classes.push('labelled');
  set(made, 'class', classes.join(' '));
  set(made, 'aria-selected', String(selected));
  set(made, 'aria-label', words_of_robot(robot, telemetry));
  set(made, 'tabindex', first ? '0' : '-1');
  const body = made.children[2]!;
  set(body, 'href', `#glyph-${kind}`);
  const turn = (-180 / Math.PI) * Math.atan2(robot.heading_sin, robot.heading_cos);
  set(body, 'transform', `rotate(${turn.toFixed(0)})`);
}

function make_enemy(enemy: ViewedEnemy): SVGElement {
  const kind = kEnemyKinds[enemy.kind] ?? 'normal';
  const made = element('g', { class: `enemy ${kind}` });
  made.append(element('use', { class: 'body', href: `#glyph-enemy-${kind}` }));
  const title = element('title');
  title.textContent = `Enemy ${enemy.enemy}, ${kind}`;
  made.append(title);
  return made;
}

function make_mine(mine: ViewedMine): SVGElement {
  const made = element('g', { class: 'mine' });
  made.append(element('use', { class: 'body', href: '#glyph-mine' }));
  const title = element('title');
  title.textContent = `Mine ${mine.mine}`;
  made.append(title);
  return made;
}

function make_object(object: ViewedObject): SVGElement {
  const colour = kColours[object.colour] ?? 'grey';
  const made = element('g', { class: `object ${colour.replace(' ', '-')}` });
  made.append(element('circle', { class: 'body' }));
  const title = element('title');
  title.textContent = `Object ${object.number}, ${colour}`;
  made.append(title);
  return made;
}
