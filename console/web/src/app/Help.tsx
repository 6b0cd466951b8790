import { kMapKeys, kOperateKeys, kPlanKeys, kReplayKeys, type Shortcut } from '@/app/keys';
import { Dialog } from '@/app/parts';
import { useSettings } from '@/app/settings';

function Keys({ title, keys }: { title: string; keys: Shortcut[] }) {
  return (
    <section>
      <h3>{title}</h3>
      <dl className="keys">
        {keys.map((key) => (
          <div key={key.shown + key.does}>
            <dt>
              <kbd>{key.shown}</kbd>
            </dt>
            <dd>{key.does}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}

const kGlossary: [string, string][] = [
  ['Motor schema', 'One simple behaviour. It puts out a push: a direction with a strength.'],
  ['Gain', 'The weight of a motor schema. A robot moves by the sum of gain × push.'],
  ['Situation', 'What a robot judges that it is in, such as ClearToEnemy.'],
  ['Learning Momentum', 'Gains are changed while the robot acts, by rules for each situation.'],
  ['Role', 'Forager, Soldier or Mechanic: what a robot does until it changes its mind.'],
  ['Case', 'A mission that was flown before. The wizard makes plans out of cases.'],
];

export function Help({ open, close }: { open: boolean; close: () => void }) {
  const { keys, set } = useSettings();
  return (
    <Dialog title="Help" open={open} close={close}>
      <label className="check">
        <input type="checkbox" checked={keys} onChange={() => set({ keys: !keys })} />
        Single keys are shortcuts
      </label>
      <div className="columns">
        <div>
          <Keys title="Operate and replay" keys={kOperateKeys} />
          <Keys title="Replay" keys={kReplayKeys} />
        </div>
        <div>
          <Keys title="Map" keys={kMapKeys} />
          <Keys title="Plan" keys={kPlanKeys} />
          <Keys title="Everywhere" keys={[{ shown: '?', does: 'This help' }]} />
        </div>
      </div>
      <section>
        <h3>Words</h3>
        <dl className="glossary">
          {kGlossary.map(([word, meaning]) => (
            <div key={word}>
              <dt>{word}</dt>
              <dd>{meaning}</dd>
            </div>
          ))}
        </dl>
      </section>
    </Dialog>
  );
}
