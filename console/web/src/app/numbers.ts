/** Numbers for people: SI units, a thin space between number and unit. */
export function with_unit(value: number, unit: string, digits = 1): string {
  return `${value.toFixed(digits)}\u202f${unit}`;
}

/** "1:02:03.4" of simulated seconds. */
export function clock(time_s: number): string {
  const tenths = Math.floor(time_s * 10 + 1e-6);
  const hours = Math.floor(tenths / 36_000);
  const minutes = Math.floor(tenths / 600) % 60;
  const seconds = (tenths % 600) / 10;
  const tail = seconds.toFixed(1).padStart(4, '0');
  return hours > 0 ? `${hours}:${String(minutes).padStart(2, '0')}:${tail}` : `${minutes}:${tail}`;
}

/** At most four digits that count, no exponent for what fits. */
export function short(value: number): string {
  if (Number.isInteger(value)) return String(value);
  return Math.abs(value) >= 1000 ? value.toFixed(0) : Number(value.toPrecision(4)).toString();
}

/** A date as the person's own place writes it. */
export function when(text: string): string {
  const date = new Date(text);
  return Number.isNaN(date.getTime())
    ? text
    : date.toLocaleString(undefined, { dateStyle: 'medium', timeStyle: 'short' });
}
