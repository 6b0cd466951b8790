export function schema_of(name: string): string;
export function writer_of(name: string): (value: object) => Uint8Array;
