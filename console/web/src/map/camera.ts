import type { Scene } from '@/api/types';

const kMost_px_per_m = 400;
const kLeast_px_per_m = 0.2;
const kMargin_px = 24;

export interface Box {
  left: number;
  bottom: number;
  right: number;
  top: number;
}

/** Which part of the world the window shows. The world's y goes up, the screen's down. */
export class Camera {
  px_per_m = 10;
  x_m = 0;
  y_m = 0;
  width_px = 1;
  height_px = 1;
  /** Nobody has moved it since it was fitted. */
  is_fitted = false;
  #version = 0;
  #listeners = new Set<() => void>();

  to_screen(x_m: number, y_m: number): [number, number] {
    return [
      this.width_px / 2 + (x_m - this.x_m) * this.px_per_m,
      this.height_px / 2 - (y_m - this.y_m) * this.px_per_m,
    ];
  }

  to_world(x_px: number, y_px: number): [number, number] {
    return [
      this.x_m + (x_px - this.width_px / 2) / this.px_per_m,
      this.y_m - (y_px - this.height_px / 2) / this.px_per_m,
    ];
  }

  resize(width_px: number, height_px: number): void {
    this.width_px = Math.max(width_px, 1);
    this.height_px = Math.max(height_px, 1);
    this.#changed();
  }

  pan(x_px: number, y_px: number): void {
    this.is_fitted = false;
    this.x_m -= x_px / this.px_per_m;
    this.y_m += y_px / this.px_per_m;
    this.#changed();
  }

  look_at(x_m: number, y_m: number): void {
    this.is_fitted = false;
    this.x_m = x_m;
    this.y_m = y_m;
    this.#changed();
  }

  /** What is under the place stays there. */
  zoom(factor: number, x_px = this.width_px / 2, y_px = this.height_px / 2): void {
    this.is_fitted = false;
    const [x_m, y_m] = this.to_world(x_px, y_px);
    this.px_per_m = Math.min(Math.max(this.px_per_m * factor, kLeast_px_per_m), kMost_px_per_m);
    const [new_x_m, new_y_m] = this.to_world(x_px, y_px);
    this.x_m += x_m - new_x_m;
    this.y_m += y_m - new_y_m;
    this.#changed();
  }

  fit(box: Box): void {
    const width_m = Math.max(box.right - box.left, 1e-3);
    const height_m = Math.max(box.top - box.bottom, 1e-3);
    const room = (px: number) => Math.max(px - 2 * kMargin_px, 1);
    this.px_per_m = Math.min(room(this.width_px) / width_m, room(this.height_px) / height_m);
    this.x_m = (box.left + box.right) / 2;
    this.y_m = (box.bottom + box.top) / 2;
    this.is_fitted = true;
    this.#changed();
  }

  readonly on_change = (listener: () => void): (() => void) => {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  };
  readonly version = (): number => this.#version;

  #changed(): void {
    this.#version += 1;
    for (const listener of this.#listeners) listener();
  }
}

export function box_of(scene: Scene): Box {
  const { x, y } = scene.shift;
  return { left: x, bottom: y, right: x + scene.width_m, top: y + scene.height_m };
}

/** 1, 2 or 5 times a power of ten: the smallest that is at least `least`. */
export function round_step(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  for (const factor of [1, 2, 5]) if (factor * power >= least * (1 - 1e-9)) return factor * power;
  return 10 * power;
}
