/** How a recorded run is played; the parameter "replay". */
export interface Playing {
  start_s: number;
  end_s: number;
  time_s: number;
  playing: boolean;
  speed: number;
}

/** How far back of a moment its state may have been sent: robots tell of themselves now and then. */
const kStateBack_s = 3.1;
const kSame_s = 1e-3;
const kAtMost_ms = 5000;

/** A recording's clock on its way to another moment. Until it is there, what comes is of before. */
export class Jump {
  /** Also ends when nothing is heard of it. */
  readonly ended: Promise<void>;
  #end!: () => void;

  constructor(
    private readonly from_s: number,
    private readonly to_s: number,
  ) {
    this.ended = new Promise((done) => {
      const timer = setTimeout(done, kAtMost_ms);
      this.#end = () => {
        clearTimeout(timer);
        done();
      };
    });
  }

  /** A clock goes back by a jump alone; forward it may be there by itself. */
  is_done_at(time_s: number): boolean {
    if (Math.abs(time_s - this.to_s) < kSame_s) return true;
    return this.to_s < this.from_s ? time_s < this.from_s - kSame_s : time_s >= this.to_s;
  }

  get oldest_s(): number {
    return this.to_s - kStateBack_s;
  }

  end(): void {
    this.#end();
  }
}
