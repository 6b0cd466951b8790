import {
  forwardRef, useEffect, useImperativeHandle, useRef, useState, useSyncExternalStore,
  type KeyboardEvent, type PointerEvent, type ReactNode,
} from 'react';

import type { Scene } from '@/api/types';
import { box_of, round_step, type Camera } from '@/map/camera';
import { draw_scene } from '@/map/draw_scene';
import { labels_of } from '@/map/labels';
import { on_palette, palette, type Palette } from '@/map/palette';

const kPan_px = 60;
const kZoom = 1.25;
const kClickWithin_px = 4;
const kScaleBar_px = 110;

export interface MapHandle {
  redraw(): void;
  fit(): void;
}

export interface MapProps {
  label: string;
  camera: Camera;
  scene: Scene | null;
  /** Above the scene, on the canvas. */
  draw?: (pen: CanvasRenderingContext2D, colours: Palette) => void;
  /** Moves what stands in the SVG layer, when the camera or the data has changed. */
  place?: () => void;
  on_click?: (x_m: number, y_m: number) => void;
  className?: string;
  /** Elements of the SVG layer. */
  children?: ReactNode;
  /** HTML above the map. */
  over?: ReactNode;
}

/** A canvas for what is only looked at, under an SVG layer for what can be chosen. */
export const MapView = forwardRef<MapHandle, MapProps>(function MapView(props, handle) {
  const { camera, scene } = props;
  const frame = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const newest = useRef(props);
  newest.current = props;
  const asked = useRef(0);
  const fitted = useRef<string | null>(null);
  const [cursor, set_cursor] = useState<[number, number] | null>(null);

  const paint = () => {
    asked.current = 0;
    const pen = canvas.current?.getContext('2d');
    if (!pen) return;
    const ratio = window.devicePixelRatio || 1;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    const colours = palette();
    pen.fillStyle = colours.ground;
    pen.fillRect(0, 0, camera.width_px, camera.height_px);
    draw_scene(pen, camera, newest.current.scene, colours);
    newest.current.draw?.(pen, colours);
    newest.current.place?.();
  };
  const redraw = () => {
    asked.current ||= requestAnimationFrame(paint);
  };
  const fit = () => {
    const { scene: now } = newest.current;
    if (now) camera.fit(box_of(now));
  };
  useImperativeHandle(handle, () => ({ redraw, fit }));

  useEffect(() => {
    const element = frame.current!;
    const watch = new ResizeObserver(() => {
      const sheet = canvas.current;
      // It may be told once more after the map has gone.
      if (!sheet) return;
      const { clientWidth, clientHeight } = element;
      const ratio = window.devicePixelRatio || 1;
      sheet.width = clientWidth * ratio;
      sheet.height = clientHeight * ratio;
      const first = camera.width_px === 1;
      camera.resize(clientWidth, clientHeight);
      if (first || camera.is_fitted) fit();
    });
    watch.observe(element);
    const wheel = (event: WheelEvent) => {
      event.preventDefault();
      const box = element.getBoundingClientRect();
      camera.zoom(1.0015 ** -event.deltaY, event.clientX - box.left, event.clientY - box.top);
    };
    element.addEventListener('wheel', wheel, { passive: false });
    const leave_camera = camera.on_change(redraw);
    const leave_palette = on_palette(redraw);
    return () => {
      watch.disconnect();
      element.removeEventListener('wheel', wheel);
      leave_camera();
      leave_palette();
      cancelAnimationFrame(asked.current);
      asked.current = 0;
    };
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [camera]);

  useEffect(() => {
    if (scene && fitted.current !== scene.name) {
      fitted.current = scene.name;
      fit();
    }
    redraw();
  });

  const drag = useDrag(camera, frame, (x, y) => props.on_click?.(x, y), set_cursor);
  return (
    <div
      ref={frame}
      className={`map ${props.className ?? ''}`}
      role="group"
      aria-label={props.label}
      tabIndex={0}
      onKeyDown={(event) => move_by_key(event, camera)}
      {...drag}
    >
      <canvas ref={canvas} aria-hidden="true" />
      <svg className="map-over" width="100%" height="100%">
        {scene && <Names camera={camera} scene={scene} />}
        {props.children}
      </svg>
      <div className="map-foot">
        <ScaleBar camera={camera} />
        <span className="map-cursor" aria-hidden="true">
          {cursor ? `x ${cursor[0].toFixed(1)} m, y ${cursor[1].toFixed(1)} m` : ''}
        </span>
      </div>
      <div className="map-zoom" role="group" aria-label="Zoom">
        <button type="button" aria-label="Zoom in" onClick={() => camera.zoom(kZoom)}>
          +
        </button>
        <button type="button" aria-label="Zoom out" onClick={() => camera.zoom(1 / kZoom)}>
          −
        </button>
        <button type="button" aria-label="Fit the map into the window" onClick={fit}>
          ⤢
        </button>
      </div>
      {props.over}
    </div>
  );
});

/** Is drawn anew when the camera has moved. */
export function useCamera(camera: Camera): void {
  useSyncExternalStore(camera.on_change, camera.version);
}

function useDrag(
  camera: Camera,
  frame: React.RefObject<HTMLDivElement | null>,
  click: (x_m: number, y_m: number) => void,
  cursor: (place: [number, number] | null) => void,
) {
  const from = useRef<{ x: number; y: number; moved: number } | null>(null);
  const place_of = (event: PointerEvent): [number, number] => {
    const box = frame.current!.getBoundingClientRect();
    return camera.to_world(event.clientX - box.left, event.clientY - box.top);
  };
  return {
    onPointerDown: (event: PointerEvent) => {
      const target = event.target as Element;
      if (event.button !== 0 || target.closest('button, [data-own-pointer]')) return;
      from.current = { x: event.clientX, y: event.clientY, moved: 0 };
      frame.current!.setPointerCapture(event.pointerId);
    },
    onPointerMove: (event: PointerEvent) => {
      cursor(place_of(event));
      const start = from.current;
      if (!start) return;
      const [x, y] = [event.clientX - start.x, event.clientY - start.y];
      from.current = { x: event.clientX, y: event.clientY, moved: start.moved + Math.hypot(x, y) };
      camera.pan(x, y);
    },
    onPointerUp: (event: PointerEvent) => {
      const start = from.current;
      from.current = null;
      if (start && start.moved < kClickWithin_px) click(...place_of(event));
    },
    onPointerCancel: () => {
      from.current = null;
    },
    onPointerLeave: () => cursor(null),
  };
}

function move_by_key(event: KeyboardEvent<HTMLDivElement>, camera: Camera): void {
  if (event.target !== event.currentTarget) return;
  const moves: Record<string, () => void> = {
    ArrowLeft: () => camera.pan(kPan_px, 0),
    ArrowRight: () => camera.pan(-kPan_px, 0),
    ArrowUp: () => camera.pan(0, kPan_px),
    ArrowDown: () => camera.pan(0, -kPan_px),
    PageUp: () => camera.zoom(kZoom),
    PageDown: () => camera.zoom(1 / kZoom),
  };
  const move = moves[event.key];
  if (!move) return;
  event.preventDefault();
  move();
}

function ScaleBar({ camera }: { camera: Camera }) {
  useCamera(camera);
  let length_m = round_step(kScaleBar_px / camera.px_per_m / 2.5);
  if (2 * length_m * camera.px_per_m < kScaleBar_px) length_m *= 2;
  const text = length_m >= 1000 ? `${length_m / 1000} km` : `${Number(length_m.toPrecision(3))} m`;
  return (
    <span className="scale-bar" role="img" aria-label={`Scale: the bar is ${text}`}>
      <span style={{ width: `${length_m * camera.px_per_m}px` }} />
      {text}
    </span>
  );
}

function Names({ camera, scene }: { camera: Camera; scene: Scene }) {
  useCamera(camera);
  const wide_enough = camera.px_per_m * Math.max(scene.width_m, scene.height_m) > 220;
  if (!wide_enough) return null;
  return (
    <g className="names" aria-hidden="true">
      {labels_of(camera, scene).map(({ text, x, y }, i) => (
        <text key={i} x={x} y={y} textAnchor="middle">
          {text}
        </text>
      ))}
      {scene.start && <Mark camera={camera} at={[scene.start.x, scene.start.y]} kind="start" />}
      {scene.target && <Mark camera={camera} at={[scene.target.x, scene.target.y]} kind="target" />}
    </g>
  );
}

function Mark(props: { camera: Camera; at: [number, number]; kind: string }) {
  const [x, y] = props.camera.to_screen(...props.at);
  return (
    <g transform={`translate(${x} ${y})`} className={`mark ${props.kind}`}>
      {props.kind === 'start' ? (
        <path d="M-1 8V-10L9-6-1-2" />
      ) : (
        <>
          <circle r="9" />
          <circle r="3.5" className="full" />
        </>
      )}
    </g>
  );
}
