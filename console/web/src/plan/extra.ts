import type { Scene } from '@/api/types';

/** The mission of the enemy that ships; its robot goes from one point called Sentry… to the next. */
const kSentry = 'sentry';

/** Who else is to be about when a plan is flown: a sentry, where an enemy is expected and the map has a way for it. */
export function usual_extra(enemy: boolean, scene: Scene | null): string {
  return enemy && scene?.points.some((point) => point.name.startsWith('Sentry')) ? kSentry : '';
}
