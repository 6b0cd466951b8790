import type { CaseFeatures, OfferedPlan, PlacedTask } from '@/api/types';

/** What a flown plan's tasks are stored under: what was wanted, else what the case had. */
export function features_of(tasks: readonly PlacedTask[], plan: OfferedPlan, robots: number | null): CaseFeatures[] {
  return tasks.map((task, i) => {
    const used = plan.cases.find((one) => one.task === i);
    const found = (feature: string) => used?.features.find((one) => one.feature === feature)?.found ?? '';
    return {
      task: task.task,
      robots: robots ?? (Number(found('NumberOfRobots')) || 1),
      localization: task.localization ?? (found('Localization') === 'UseLandmarks' ? 'UseLandmarks' : 'UseMaps'),
      environment: task.environment ?? (found('Environment') === 'Outdoor' ? 'Outdoor' : 'Indoor'),
      handles_enemy: task.handles_enemy ?? found('HandlesEnemy') === 'True',
    };
  });
}
