import { useId, useState, type FormEvent } from 'react';

import { api, words_of } from '@/api/client';
import type { StartRun as Wanted } from '@/api/types';
import { useAsked } from '@/api/use';
import { Dialog, Loading, Trouble } from '@/app/parts';

/** A field's number; nothing when it is left empty. */
function number_in(form: FormData, name: string): number | undefined {
  const text = String(form.get(name) ?? '').trim();
  return text === '' ? undefined : Number(text);
}

export function wanted_of(form: FormData): Wanted {
  const [kind, name = ''] = String(form.get('what')).split(/:(.*)/);
  const wanted: Wanted = {};
  if (kind === 'scenario') wanted.scenario = name;
  else wanted.mission_name = name;
  const map = String(form.get('map') ?? '');
  if (map) wanted.map_name = map;
  for (const field of ['robots', 'seed', 'speed'] as const) {
    const value = number_in(form, field);
    if (value !== undefined) wanted[field] = value;
  }
  return wanted;
}

export function StartRun(props: { open: boolean; close: () => void; started: (id: string) => void }) {
  return (
    <Dialog title="Start a run" open={props.open} close={props.close}>
      <Form started={props.started} />
    </Dialog>
  );
}

async function choices() {
  const [scenarios, missions, maps] = await Promise.all([api.scenarios(), api.missions(), api.maps()]);
  return { scenarios, missions, maps };
}

function Form({ started }: { started: (id: string) => void }) {
  const asked = useAsked(choices, 'choices');
  const [what, set_what] = useState('');
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState('');
  const id = useId();
  if (asked.error) return <Trouble text={asked.error} again={asked.again} />;
  if (!asked.value) return <Loading what="scenarios" />;
  const { scenarios, missions, maps } = asked.value;
  const submit = async (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault();
    set_busy(true);
    set_error('');
    try {
      started((await api.start(wanted_of(new FormData(event.currentTarget)))).id);
    } catch (thrown) {
      set_error(words_of(thrown));
    }
    set_busy(false);
  };
  const described = scenarios.find((one) => `scenario:${one.name}` === what)?.description;
  const titled = missions.find((one) => `mission:${one.name}` === what)?.title;
  return (
    <form className="form" onSubmit={submit}>
      <label>
        Scenario or mission
        <select name="what" required value={what} onChange={(event) => set_what(event.target.value)} aria-describedby={`${id}what`}>
          <option value="">Choose …</option>
          <optgroup label="Scenarios">
            {scenarios.map((one) => (
              <option key={one.name} value={`scenario:${one.name}`}>
                {one.name}
              </option>
            ))}
          </optgroup>
          <optgroup label="Missions">
            {missions.map((one) => (
              <option key={one.name} value={`mission:${one.name}`}>
                {one.name}
              </option>
            ))}
          </optgroup>
        </select>
      </label>
      <p id={`${id}what`} className="hint">
        {described ?? titled ?? 'A scenario says all; a mission needs a map.'}
      </p>
      <label>
        Map
        <select name="map" required={what.startsWith('mission:')} defaultValue="">
          <option value="">{what.startsWith('mission:') ? 'Choose …' : "The scenario's own"}</option>
          {maps.map((one) => (
            <option key={one.name}>{one.name}</option>
          ))}
        </select>
      </label>
      <div className="fields">
        <label>
          Robots
          <input name="robots" type="number" min="1" max="1000" step="1" placeholder="its own" />
        </label>
        <label>
          Seed
          <input name="seed" type="number" min="0" step="1" placeholder="its own" />
        </label>
        <label>
          Speed, × real time
          <input name="speed" type="number" min="0" step="any" defaultValue="1" />
        </label>
      </div>
      <p className="hint">Speed 0 is as fast as it goes. The same scenario and seed give the same run.</p>
      {error && <Trouble text={error} />}
      <div className="row end">
        <button type="submit" className="primary" disabled={busy}>
          {busy ? 'Starting …' : 'Start'}
        </button>
      </div>
    </form>
  );
}
