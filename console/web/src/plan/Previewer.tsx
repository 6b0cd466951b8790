import { useEffect, useState } from 'react';

import { api, words_of } from '@/api/client';
import { useAsked } from '@/api/use';
import type { OfferedPlan, Preview } from '@/api/types';
import { clock } from '@/app/numbers';
import { Trouble } from '@/app/parts';
import { usual_extra } from '@/plan/extra';
import { useDraft, useSession } from '@/plan/store';

const kAskEvery_ms = 700;
const kFlights = [5, 10, 30, 100];

/** Flies a plan a few times, faster than real time and with no robot harmed. */
export function Previewer({ plan, map }: { plan: OfferedPlan; map: string }) {
  const { preview, set } = useSession();
  const { preferences } = useDraft();
  const scene = useAsked(() => api.map(map), `map ${map}`);
  const [flights, set_flights] = useState(10);
  const [id, set_id] = useState('');
  const [error, set_error] = useState('');
  const running = id !== '' && (preview === null || preview.state === 'running');

  useEffect(() => {
    if (!running) return;
    let wanted = true;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const ask = async () => {
      try {
        const now = await api.preview_state(id);
        if (!wanted) return;
        set({ preview: now });
        if (now.state === 'running') timer = setTimeout(ask, kAskEvery_ms);
      } catch (thrown) {
        if (!wanted) return;
        set_error(words_of(thrown));
        set_id('');
      }
    };
    void ask();
    return () => {
      wanted = false;
      clearTimeout(timer);
    };
  }, [id, running, set]);

  const start = async () => {
    set_error('');
    set({ preview: null });
    try {
      set_id((await api.preview(plan.mission, map, flights, usual_extra(preferences.enemy, scene.value))).id);
    } catch (thrown) {
      set_error(words_of(thrown));
    }
  };
  const cancel = async () => {
    try {
      await api.cancel_preview(id);
      set({ preview: await api.preview_state(id) });
    } catch (thrown) {
      set_error(words_of(thrown));
    }
    set_id('');
  };
  return (
    <section className="preview" aria-label="Preview">
      <h2>Preview</h2>
      <div className="row">
        <label className="inline">
          Flights
          <select value={flights} disabled={running} onChange={(event) => set_flights(Number(event.target.value))}>
            {kFlights.map((count) => (
              <option key={count}>{count}</option>
            ))}
          </select>
        </label>
        {running ? (
          <button type="button" className="danger" onClick={cancel}>
            Cancel
          </button>
        ) : (
          <button type="button" onClick={start}>
            {preview ? 'Preview again' : 'Preview'}
          </button>
        )}
      </div>
      {error && <Trouble text={error} />}
      {preview && <Outcome preview={preview} />}
      {!preview && !running && <p className="hint">See how likely it is to succeed before you run it.</p>}
    </section>
  );
}

const percent = (share: number) => `${Math.round(100 * share)}\u202f%`;

function Outcome({ preview }: { preview: Preview }) {
  const { success } = preview;
  return (
    <>
      <label className="progress">
        <span role="status">
          {preview.flown} of {preview.flights} flights {preview.state === 'cancelled' ? '(cancelled)' : 'flown'}
        </span>
        <progress max={preview.flights} value={preview.flown} />
      </label>
      <dl className="facts">
        <div>
          <dt>Success</dt>
          <dd>{success ? percent(success.share) : '–'}</dd>
        </div>
        <div>
          <dt>95 % interval</dt>
          <dd>{success ? `${percent(success.low)} to ${percent(success.high)}` : '–'}</dd>
        </div>
        <div>
          <dt>Mean score</dt>
          <dd>{preview.mean_score === null ? '–' : percent(preview.mean_score)}</dd>
        </div>
        <div>
          <dt>Median time</dt>
          <dd>{preview.median_time_s === null ? '–' : clock(preview.median_time_s)}</dd>
        </div>
      </dl>
      {preview.alike && (
        <p className="hint">
          Every flight went the same way: senses, calls and mission draw no chance, so this is worth one flight.
        </p>
      )}
      {preview.failures.length > 0 && (
        <ul className="failures">
          {preview.failures.map((failure) => (
            <li key={failure}>✕ {failure}</li>
          ))}
        </ul>
      )}
    </>
  );
}
