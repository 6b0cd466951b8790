import type {
  CaseFeatures, PlanAnswer, PlanRequest, Preview, Run, RunDetail, Scene, StartRun,
} from '@/api/types';

/** What the console refused, in its own words. */
export class Refused extends Error {
  constructor(
    readonly status: number,
    message: string,
    readonly wanted?: string,
  ) {
    super(message);
  }
}

async function ask<T>(method: string, path: string, body?: unknown, keepalive = false): Promise<T> {
  let response: Response;
  try {
    response = await fetch(`/api/${path}`, {
      method,
      keepalive,
      ...(body === undefined
        ? {}
        : { body: JSON.stringify(body), headers: { 'content-type': 'application/json' } }),
    });
  } catch {
    throw new Refused(0, 'The console does not answer. Is "console serve" running?');
  }
  const text = await response.text();
  const answer = parsed(text);
  if (!response.ok) throw refusal(response.status, answer);
  return answer as T;
}

function parsed(text: string): unknown {
  try {
    return text === '' ? null : JSON.parse(text);
  } catch {
    return null;
  }
}

function refusal(status: number, answer: unknown): Refused {
  const { error, wanted } = (answer ?? {}) as { error?: unknown; wanted?: unknown };
  const text = typeof error === 'string' ? error : `the console answered ${status}`;
  return new Refused(status, text, wanted === undefined ? undefined : String(wanted));
}

const at = encodeURIComponent;

export const api = {
  version: () => ask<{ version: string }>('GET', 'version'),
  runs: () => ask<Run[]>('GET', 'runs'),
  run: (id: string) => ask<RunDetail>('GET', `runs/${at(id)}`),
  start: (run: StartRun) => ask<{ id: string }>('POST', 'runs', run),
  stop: (id: string) => ask<unknown>('DELETE', `runs/${at(id)}`),
  run_scene: (id: string) => ask<Scene>('GET', `runs/${at(id)}/scene`),
  open_replay: (run: string) => ask<{ id: string }>('POST', 'replays', { run }),
  /** Also done when the page goes away. */
  close_replay: (run: string) => ask<unknown>('DELETE', `replays/${at(run)}`, undefined, true),
  maps: () => ask<{ name: string }[]>('GET', 'maps'),
  map: (name: string) => ask<Scene>('GET', `maps/${at(name)}`),
  missions: () => ask<{ name: string; title: string }[]>('GET', 'missions'),
  scenarios: () => ask<{ name: string; description: string }[]>('GET', 'scenarios'),
  plan: (map_name: string, request: PlanRequest) =>
    ask<PlanAnswer>('POST', 'plans', { map_name, request }),
  preview: (mission: string, map_name: string, flights: number, extra: string) =>
    ask<{ id: string }>('POST', 'previews', { mission, map_name, flights, ...(extra ? { extra } : {}) }),
  preview_state: (id: string) => ask<Preview>('GET', `previews/${at(id)}`),
  cancel_preview: (id: string) => ask<unknown>('DELETE', `previews/${at(id)}`),
  rate: (cases: number[], score: number, failures: string[], map: string) =>
    ask<unknown>('POST', 'outcomes', { cases, score, failures, map }),
  store: (mission: string, title: string, features: CaseFeatures[]) =>
    ask<{ text: string }>('POST', 'cases', { mission, title, features }),
};

export function socket_of(run: string): string {
  const secure = location.protocol === 'https:';
  return `${secure ? 'wss' : 'ws'}://${location.host}/ws/${at(run)}`;
}

/** What is told to a person of anything that was thrown. */
export function words_of(error: unknown): string {
  if (error instanceof Refused && error.wanted) return `${error.message}; wanted: ${error.wanted}`;
  return error instanceof Error ? error.message : String(error);
}
