type Cell = string | number | null | undefined;

/** RFC 4180. A cell that a spreadsheet would take for a formula is made text. */
export function csv(rows: Cell[][]): string {
  return rows.map((row) => row.map(cell_text).join(',')).join('\r\n') + '\r\n';
}

function cell_text(cell: Cell): string {
  if (cell === null || cell === undefined) return '';
  if (typeof cell === 'number') return String(cell);
  const text = /^[=+\-@\t\r]/.test(cell) ? `'${cell}` : cell;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

export function save_csv(name: string, rows: Cell[][]): void {
  const url = URL.createObjectURL(new Blob([csv(rows)], { type: 'text/csv;charset=utf-8' }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  URL.revokeObjectURL(url);
}
