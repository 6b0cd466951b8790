import { useCallback, useEffect, useState } from 'react';

import { words_of } from '@/api/client';

export interface Asked<T> {
  value: T | null;
  error: string;
  again: () => void;
}

/** Asks once, again when `key` changes, and every `every_ms` if given. Keeps the last answer while
 * it asks again. */
export function useAsked<T>(ask: () => Promise<T>, key: string, every_ms?: number): Asked<T> {
  const [state, set_state] = useState<{ key: string; value: T | null; error: string }>({
    key, value: null, error: '',
  });
  const [round, set_round] = useState(0);
  useEffect(() => {
    let wanted = true;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const once = async () => {
      try {
        const value = await ask();
        if (wanted) set_state({ key, value, error: '' });
      } catch (error) {
        if (wanted) {
          set_state((old) => ({ key, value: old.key === key ? old.value : null, error: words_of(error) }));
        }
      }
      if (wanted && every_ms) timer = setTimeout(once, every_ms);
    };
    void once();
    return () => {
      wanted = false;
      clearTimeout(timer);
    };
    // `ask` is a new function each time; `key` says when it asks for something else.
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [key, every_ms, round]);
  const again = useCallback(() => set_round((n) => n + 1), []);
  return state.key === key
    ? { value: state.value, error: state.error, again }
    : { value: null, error: '', again };
}
