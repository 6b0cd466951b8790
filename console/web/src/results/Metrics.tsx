import type { Metric } from '@/api/types';
import { short } from '@/app/numbers';

export function Metrics({ metrics }: { metrics: Metric[] }) {
  if (metrics.length === 0) return <p className="hint">This run has no metrics.</p>;
  return (
    <table className="metrics">
      <caption>Metrics</caption>
      <thead>
        <tr>
          <th scope="col">Metric</th>
          <th scope="col" className="number">
            Value
          </th>
          <th scope="col">Meaning</th>
        </tr>
      </thead>
      <tbody>
        {metrics.map((metric) => (
          <tr key={metric.name}>
            <th scope="row">{metric.name}</th>
            <td className="number">
              {metric.value === null ? 'none' : `${short(metric.value)}${metric.unit ? `\u202f${metric.unit}` : ''}`}
            </td>
            <td>{metric.meaning}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
