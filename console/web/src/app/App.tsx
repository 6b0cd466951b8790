import { lazy, Suspense, useEffect, useState } from 'react';

import { api } from '@/api/client';
import { useAsked } from '@/api/use';
import { Help } from '@/app/Help';
import { useKeys } from '@/app/keys';
import { Loading } from '@/app/parts';
import { address_of, useRoute, type View } from '@/app/route';
import { show_theme, useSettings, type Theme } from '@/app/settings';
import { Operate } from '@/operate/Operate';

const Plan = lazy(() => import('@/plan/Plan'));
const Results = lazy(() => import('@/results/Results'));
const Replay = lazy(() => import('@/replay/Replay'));

const kViews: [View, string][] = [
  ['operate', 'Operate'],
  ['plan', 'Plan'],
  ['results', 'Results'],
];
const kHelpKey = ['?'];

function ThemeSwitch() {
  const { theme, set } = useSettings();
  useEffect(() => show_theme(theme), [theme]);
  return (
    <label className="theme">
      <span className="unseen">Colours</span>
      <select value={theme} onChange={(event) => set({ theme: event.target.value as Theme })}>
        <option value="system">System colours</option>
        <option value="light">Light</option>
        <option value="dark">Dark</option>
      </select>
    </label>
  );
}

export function App() {
  const route = useRoute();
  const [help, set_help] = useState(false);
  const version = useAsked(api.version, 'version', 30_000);
  useKeys(kHelpKey, () => set_help(true));
  useEffect(() => {
    const title = kViews.find(([view]) => view === route.view)?.[1] ?? 'Replay';
    document.title = `${title} · Tacit console`;
  }, [route.view]);
  return (
    <>
      <a className="skip" href="#main" onClick={skip_to_main}>
        Skip to the content
      </a>
      <header className="top">
        <a className="brand" href="#/operate">
          <img src="/favicon.svg" alt="" width="24" height="24" /> Tacit
        </a>
        <nav aria-label="Views">
          {kViews.map(([view, title]) => (
            <a key={view} href={address_of(view)} aria-current={route.view === view ? 'page' : undefined}>
              {title}
            </a>
          ))}
        </nav>
        <span className="spacer" />
        {version.error ? (
          <span className="link-state bad" role="status">
            <span aria-hidden="true">⚠ </span>Console does not answer
          </span>
        ) : (
          <span className="link-state">{version.value ? `Version ${version.value.version}` : ''}</span>
        )}
        <ThemeSwitch />
        <button type="button" onClick={() => set_help(true)}>
          <span aria-hidden="true">?</span> Help
        </button>
      </header>
      <main id="main" tabIndex={-1}>
        <Suspense fallback={<Loading what="the view" />}>
          {route.view === 'operate' && <Operate run={route.run} />}
          {route.view === 'plan' && <Plan />}
          {route.view === 'results' && <Results run={route.run} />}
          {route.view === 'replay' && <Replay key={route.run} run={route.run} />}
        </Suspense>
      </main>
      <Help open={help} close={() => set_help(false)} />
    </>
  );
}

/** The address holds the view, so the jump is made by hand. */
function skip_to_main(event: React.MouseEvent) {
  event.preventDefault();
  document.getElementById('main')?.focus();
}
