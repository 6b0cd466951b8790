/** Play or pause, one step, and the speed: of a run that goes on or of a recorded one. */
export function PlayAndSpeed(props: {
  paused: boolean;
  dead: boolean;
  toggle: () => void;
  step: () => void;
  speed: number;
  /** 0 is as fast as it goes. */
  speeds: readonly number[];
  set_speed: (factor: number) => void;
}) {
  const { paused, dead } = props;
  return (
    <>
      <button type="button" className="primary wide" onClick={props.toggle} disabled={dead}>
        <span aria-hidden="true">{paused ? '▶' : '❚❚'}</span> {paused ? 'Play' : 'Pause'}
      </button>
      <button type="button" onClick={props.step} disabled={dead}>
        <span aria-hidden="true">▶❚</span> Step
      </button>
      <label className="speed">
        Speed
        <select
          value={props.speed}
          disabled={dead}
          onChange={(event) => props.set_speed(Number(event.target.value))}
        >
          {props.speeds.map((factor) => (
            <option key={factor} value={factor}>
              {factor === 0 ? 'as fast as it goes' : `${factor} ×`}
            </option>
          ))}
        </select>
      </label>
    </>
  );
}
