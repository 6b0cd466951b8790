/** Moves to the newest moment that was asked for, one jump at a time: a slider asks faster than a
 * recording is read. */
export class Seeker {
  #wanted_s: number | null = null;
  #going_s: number | null = null;

  constructor(
    private readonly seek: (time_s: number) => Promise<void>,
    private readonly changed: () => void,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** Where it goes; nothing when it stands. */
  get goal_s(): number | null {
    return this.#wanted_s ?? this.#going_s;
  }

  to(time_s: number): void {
    this.#wanted_s = time_s;
    this.changed();
    if (this.#going_s === null) void this.#go();
  }

  async #go(): Promise<void> {
    while (this.#wanted_s !== null) {
      const to_s = this.#wanted_s;
      this.#going_s = to_s;
      this.#wanted_s = null;
      try {
        await this.seek(to_s);
      } catch (error) {
        this.failed(error);
      }
    }
    this.#going_s = null;
    this.changed();
  }
}
