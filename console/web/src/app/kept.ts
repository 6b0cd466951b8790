/** What the browser keeps for us; nothing when it does not keep anything. */
export function recall<T>(key: string, otherwise: T): T {
  try {
    const text = localStorage.getItem(`tacit.${key}`);
    return text === null ? otherwise : (JSON.parse(text) as T);
  } catch {
    return otherwise;
  }
}

export function keep(key: string, value: unknown): boolean {
  try {
    localStorage.setItem(`tacit.${key}`, JSON.stringify(value));
    return true;
  } catch {
    return false;
  }
}
