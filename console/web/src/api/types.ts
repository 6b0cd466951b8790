/** The REST interface of the console, as JSON. */

export interface Run {
  id: string;
  name: string;
  scenario: string;
  seed: number;
  state: 'live' | 'done' | 'stopped' | 'failed';
  started: string;
  ticks: number;
  robots: number;
  /** Whether it can be played. */
  recording: boolean;
  score: Score | null;
}

export interface Score {
  done: number;
  wanted: number;
}

export interface Metric {
  name: string;
  value: number | null;
  unit: string;
  meaning: string;
}

export interface Check {
  name: string;
  done: boolean;
  evidence: string;
}

export interface RunDetail extends Run {
  metrics: Metric[];
  checklist: Check[] | null;
}

export interface StartRun {
  scenario?: string;
  mission?: string;
  mission_name?: string;
  map_name?: string;
  map?: string;
  robots?: number;
  learner?: string;
  strategy?: string;
  seed?: number;
  speed?: number;
  extra?: string;
}

export type Place = [x_m: number, y_m: number];

/** What stands still in a world, in the world's frame, in metres. */
export interface Scene {
  name: string;
  width_m: number;
  height_m: number;
  /** The world's frame is the map's plus this. */
  shift: { x: number; y: number };
  walls: [number, number, number, number][];
  discs: [x_m: number, y_m: number, radius_m: number][];
  rooms: { name: string; outline: Place[] }[];
  doors: { name: string; from: Place; to: Place }[];
  halls: { name: string; centre: Place[]; width_m: number }[];
  points: { name: string; x: number; y: number; r: number }[];
  start: { x: number; y: number } | null;
  target: { x: number; y: number } | null;
  base: { x: number; y: number; r: number } | null;
}

export type TaskKind = 'biohazard' | 'eod' | 'waypoint' | 'hostage' | 'rescue';
export type Localization = 'UseLandmarks' | 'UseMaps';
export type Environment = 'Indoor' | 'Outdoor';

export interface PlacedTask {
  task: TaskKind;
  x: number;
  y: number;
  localization?: Localization;
  environment?: Environment;
  handles_enemy?: boolean;
}

export interface PlanRequest {
  tasks: PlacedTask[];
  robots?: number;
  enemy?: boolean;
  max_velocity_mps: number;
  aggressiveness: number;
  top: number;
  naive?: boolean;
}

export interface FeatureMatch {
  feature: string;
  wanted: string;
  found: string;
  matches: boolean;
}

export interface UsedCase {
  id: number;
  title: string;
  task: number;
  record: string;
  features: FeatureMatch[];
}

export interface PlanChange {
  step: 'adapt' | 'criticize';
  rule: string;
  why: string;
  before: string;
  after: string;
  mended: boolean;
}

export interface OfferedPlan {
  stars: number;
  arrangement: string;
  mission: string;
  cases: UsedCase[];
  changes: PlanChange[];
}

export interface PlanAnswer {
  plans: OfferedPlan[];
  notes: string[];
}

export interface Preview {
  /** All flights went the same way: nothing in the mission draws chance. */
  alike?: boolean;
  state: 'running' | 'done' | 'cancelled';
  flown: number;
  flights: number;
  success: { share: number; low: number; high: number } | null;
  mean_score: number | null;
  median_time_s: number | null;
  failures: string[];
}

export interface CaseFeatures {
  task: TaskKind;
  robots: number;
  localization: Localization;
  environment: Environment;
  handles_enemy: boolean;
}
