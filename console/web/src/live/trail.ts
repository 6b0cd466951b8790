/** Where a robot has been: the newest `most` places, a step apart at least. */
export class Trail {
  #places: Float64Array;
  #next = 0;
  #count = 0;

  constructor(
    private readonly most = 400,
    private readonly step_m = 0.05,
  ) {
    this.#places = new Float64Array(3 * most);
  }

  get length(): number {
    return this.#count;
  }

  add(x_m: number, y_m: number, time_s: number): void {
    if (this.#count > 0) {
      const [x, y] = this.at(this.#count - 1);
      if (Math.hypot(x_m - x, y_m - y) < this.step_m) return;
    }
    this.#places.set([x_m, y_m, time_s], 3 * this.#next);
    this.#next = (this.#next + 1) % this.most;
    this.#count = Math.min(this.#count + 1, this.most);
  }

  /** From the oldest, which is 0. */
  at(index: number): [x_m: number, y_m: number, time_s: number] {
    const place = 3 * ((this.#next - this.#count + index + this.most) % this.most);
    return [this.#places[place]!, this.#places[place + 1]!, this.#places[place + 2]!];
  }

  clear(): void {
    this.#count = 0;
  }
}
