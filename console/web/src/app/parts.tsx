import { useEffect, useRef, useState, type ReactNode } from 'react';

/** Something is being asked for. */
export function Loading({ what }: { what: string }) {
  return (
    <p className="state" role="status">
      <span className="spinner" aria-hidden="true" /> Loading {what} …
    </p>
  );
}

/** Something went wrong: what, and what to do. */
export function Trouble({ text, again }: { text: string; again?: () => void }) {
  return (
    <div className="state trouble" role="alert">
      <p>
        <span aria-hidden="true">⚠ </span>
        {text}
      </p>
      {again && (
        <button type="button" onClick={again}>
          Try again
        </button>
      )}
    </div>
  );
}

/** Nothing is there yet. */
export function Nothing({ title, children }: { title: string; children?: ReactNode }) {
  return (
    <div className="state nothing">
      <h1 className="nothing-title">{title}</h1>
      {children}
    </div>
  );
}

const kArmed_ms = 4000;

/** A button that has to be pressed twice; no window in the way. */
export function TwiceButton(props: {
  label: string; sure: string; act: () => void; className?: string; disabled?: boolean;
}) {
  const [armed, set_armed] = useState(false);
  useEffect(() => {
    if (!armed) return;
    const timer = setTimeout(() => set_armed(false), kArmed_ms);
    return () => clearTimeout(timer);
  }, [armed]);
  const pressed = () => {
    if (armed) props.act();
    set_armed(!armed);
  };
  return (
    <button
      type="button"
      className={`${props.className ?? 'danger'} ${armed ? 'armed' : ''}`}
      disabled={props.disabled}
      onClick={pressed}
      onBlur={() => set_armed(false)}
    >
      {armed ? props.sure : props.label}
    </button>
  );
}

/** A native dialog: the browser holds the focus in it and gives it back. */
export function Dialog(props: {
  title: string; open: boolean; close: () => void; children: ReactNode;
}) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const element = dialog.current;
    if (!element) return;
    if (props.open && !element.open) element.showModal();
    if (!props.open && element.open) element.close();
  }, [props.open]);
  return (
    <dialog ref={dialog} onClose={props.close} aria-label={props.title}>
      <header className="dialog-head">
        <h2>{props.title}</h2>
        <button type="button" className="quiet" onClick={props.close} aria-label="Close">
          ✕
        </button>
      </header>
      {props.open && props.children}
    </dialog>
  );
}

const kSaidEvery_ms = 3000;

/** Says a text to screen readers, the newest at most every three seconds. */
export function Announcer({ text }: { text: string }) {
  const [said, set_said] = useState('');
  const newest = useRef(text);
  newest.current = text;
  useEffect(() => {
    const timer = setInterval(() => set_said(newest.current), kSaidEvery_ms);
    return () => clearInterval(timer);
  }, []);
  return (
    <p className="unseen" role="status" aria-live="polite">
      {said}
    </p>
  );
}

const kRunStates = { live: '●', done: '✓', stopped: '■', failed: '✕' } as const;

export function RunState({ state }: { state: keyof typeof kRunStates }) {
  return (
    <span className={`run-state ${state}`}>
      <span aria-hidden="true">{kRunStates[state] ?? '?'}</span> {state}
    </span>
  );
}
