import { temporal } from 'zundo';
import { create, useStore } from 'zustand';

import type { PlanAnswer, Preview } from '@/api/types';
import { keep, recall } from '@/app/kept';
import { kEmpty, kSafe, type Draft } from '@/plan/draft';

const kSteps = 100;
const kSavedAfter_ms = 300;

interface DraftStore extends Draft {
  /** Changes of the same `burst` that follow each other quickly are undone together. */
  change: (by: (draft: Draft) => Draft, burst?: string) => void;
}

const kBurst_ms = 1000;
let burst_now = '';
let burst_before = { key: '', at_ms: 0 };

function begins_a_step(): boolean {
  const now_ms = performance.now();
  const same = burst_now !== '' && burst_now === burst_before.key && now_ms - burst_before.at_ms < kBurst_ms;
  burst_before = { key: burst_now, at_ms: now_ms };
  return !same || useDraft.temporal.getState().futureStates.length > 0;
}

const draft_of = ({ map, tasks, preferences }: Draft): Draft => ({ map, tasks, preferences });

function saved(): Draft {
  const draft = recall<Partial<Draft>>('plan', {});
  return {
    ...kEmpty,
    ...draft,
    tasks: Array.isArray(draft.tasks) ? draft.tasks : [],
    preferences: { ...kSafe, ...draft.preferences },
  };
}

/** The description, with a hundred steps back. The browser keeps it. */
export const useDraft = create<DraftStore>()(
  temporal<DraftStore, [], [], Draft>(
    (set) => ({
      ...saved(),
      change: (by, burst = '') => {
        burst_now = burst;
        set((state) => draft_of(by(draft_of(state))));
      },
    }),
    {
      limit: kSteps,
      // Zundo's own type of `remember` lacks the last two arguments.
      handleSet: (remember) => (...step) => {
        if (begins_a_step()) (remember as (...all: unknown[]) => void)(...step);
      },
      partialize: draft_of,
      equality: (a, b) => JSON.stringify(a) === JSON.stringify(b),
    },
  ),
);

export function useHistory() {
  return useStore(useDraft.temporal);
}

export type Step = 'describe' | 'review' | 'run';

/** Where one is: what the wizard said and what was started. Is not undone. */
interface Session {
  step: Step;
  answer: PlanAnswer | null;
  /** The description that `answer` is for. */
  planned: Draft | null;
  chosen: number;
  preview: Preview | null;
  run: string;
  unsaved: boolean;
  set: (change: Partial<Omit<Session, 'set'>>) => void;
}

export const useSession = create<Session>((set) => ({
  step: 'describe',
  answer: null,
  planned: null,
  chosen: 0,
  preview: null,
  run: '',
  ...recall<Partial<Session>>('plan-session', {}),
  unsaved: false,
  set: (change) => set(change),
}));

useSession.subscribe(({ step, answer, planned, chosen, run }, before) => {
  const same = step === before.step && answer === before.answer && chosen === before.chosen && run === before.run;
  if (!same) keep('plan-session', { step, answer, planned, chosen, run });
});

let timer: ReturnType<typeof setTimeout> | undefined;
useDraft.subscribe((state) => {
  useSession.getState().set({ unsaved: true });
  clearTimeout(timer);
  timer = setTimeout(() => {
    if (keep('plan', draft_of(state))) useSession.getState().set({ unsaved: false });
  }, kSavedAfter_ms);
});

/** Whether the plans are for what is described now. */
export function is_planned(draft: Draft, planned: Draft | null): boolean {
  return planned !== null && JSON.stringify(draft_of(draft)) === JSON.stringify(planned);
}

export function current_draft(): Draft {
  return draft_of(useDraft.getState());
}
