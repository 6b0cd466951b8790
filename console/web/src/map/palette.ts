/** Colours of the page for what is drawn on a canvas, from the style sheet. */
const kNames = [
  'ground', 'paper', 'grid', 'wall', 'room', 'hall', 'disc', 'ink', 'faint', 'accent', 'c1', 'c2',
  'c3', 'c4', 'c5', 'c6', 'c7', 'c8', 'base', 'push',
] as const;
export type Palette = Record<(typeof kNames)[number], string>;

let known: Palette | null = null;

export function palette(): Palette {
  if (known) return known;
  const style = getComputedStyle(document.documentElement);
  known = Object.fromEntries(
    kNames.map((name) => [name, style.getPropertyValue(`--${name}`).trim() || '#888']),
  ) as Palette;
  return known;
}

/** The n-th colour of a series, all told apart by people who see fewer colours. */
export function series_colour(index: number): string {
  const colours = palette();
  return colours[`c${1 + (index % 8)}` as 'c1'];
}

const listeners = new Set<() => void>();

export function on_palette(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

function changed(): void {
  known = null;
  for (const listener of listeners) listener();
}

new MutationObserver(changed).observe(document.documentElement, { attributeFilter: ['data-theme'] });
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed);
