import type { Telemetry, ViewedRobot } from '@/wire/words';

export type RobotKind = 'forager' | 'soldier' | 'mechanic' | 'robot' | 'hostile';
export const kRobotKinds: [RobotKind, string][] = [
  ['forager', 'Forager'],
  ['soldier', 'Soldier'],
  ['mechanic', 'Mechanic'],
  ['robot', 'Robot'],
  ['hostile', 'Hostile robot'],
];
const kRed = 2;

/** Shape and colour of a robot: by its role, else by the side it is on. */
export function kind_of(robot: ViewedRobot, telemetry: Telemetry | null): RobotKind {
  const role = telemetry?.role.toLowerCase();
  if (role === 'forager' || role === 'soldier' || role === 'mechanic') return role;
  return robot.colour === kRed ? 'hostile' : 'robot';
}

/** What a robot is, in words. */
export function words_of_robot(robot: ViewedRobot, telemetry: Telemetry | null): string {
  const parts = [`Robot ${robot.robot}`, telemetry?.role, telemetry?.state, telemetry?.situation];
  if (!robot.able) parts.push('disabled');
  if (!robot.present) parts.push('absent');
  if (robot.holding) parts.push('holds something');
  return parts.filter(Boolean).join(', ');
}

/** Shapes of 20 pixels, ahead to the right. */
const kShapes: Record<RobotKind, string> = {
  forager: 'M9 0A9 9 0 1 1-9 0 9 9 0 1 1 9 0ZM2 0 9 0',
  soldier: 'M11 0-8 9-4 0-8-9Z',
  mechanic: 'M-8-8H8V8H-8ZM2 0H8',
  robot: 'M10 0 5 8H-8V-8H5Z',
  hostile: 'M10 0 0 9-10 0 0-9Z',
};

export function Glyphs() {
  return (
    <defs>
      {kRobotKinds.map(([kind]) => (
        <path key={kind} id={`glyph-${kind}`} d={kShapes[kind]} />
      ))}
      <path id="glyph-disabled" d="M-6-6 6 6M6-6-6 6" />
      <path id="glyph-enemy-normal" d="M0-8 8 0 0 8-8 0Z" />
      <path id="glyph-enemy-decoy" d="M0-8 8 0 0 8-8 0ZM-4 0H4" />
      <path id="glyph-enemy-hunter" d="M0-10 4-4 10 0 4 4 0 10-4 4-10 0-4-4Z" />
      <path id="glyph-mine" d="M0-5A5 5 0 1 1 0 5 5 5 0 1 1 0-5M0-8V-5M0 8V5M-8 0H-5M8 0H5" />
    </defs>
  );
}

/** What the shapes mean. */
export function Legend() {
  const rows: [string, string, string][] = [
    ...kRobotKinds.map(([kind, name]): [string, string, string] => [`robot ${kind}`, kind, name]),
    ['enemy normal', 'enemy-normal', 'Enemy'],
    ['enemy decoy', 'enemy-decoy', 'Decoy'],
    ['enemy hunter', 'enemy-hunter', 'Hunter'],
    ['mine', 'mine', 'Mine'],
  ];
  return (
    <details className="legend">
      <summary>Legend</summary>
      <ul>
        {rows.map(([classes, glyph, name]) => (
          <li key={name}>
            <svg width="24" height="24" viewBox="-12 -12 24 24" aria-hidden="true">
              <g className={classes}>
                <use href={`#glyph-${glyph}`} className="body" />
              </g>
            </svg>
            {name}
          </li>
        ))}
        <li>
          <svg width="24" height="24" viewBox="-12 -12 24 24" aria-hidden="true">
            <g className="robot robot-kind disabled">
              <use href="#glyph-robot" className="body" />
              <use href="#glyph-disabled" className="cross" />
            </g>
          </svg>
          Disabled
        </li>
      </ul>
    </details>
  );
}
