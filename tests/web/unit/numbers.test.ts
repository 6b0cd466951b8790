import { clock, short } from '@/app/numbers';
import { route_of } from '@/app/route';
import { wanted_of } from '@/operate/StartRun';

test.each([[0, '0:00.0'], [59.96, '0:59.9'], [75.3, '1:15.3'], [3723.4, '1:02:03.4']])(
  '%d s is %s',
  (time_s, text) => expect(clock(time_s)).toBe(text),
);

test('a number is short and has no exponent', () => {
  expect(short(0.123456)).toBe('0.1235');
  expect(short(123456.7)).toBe('123457');
  expect(short(3)).toBe('3');
});

test('an address that nobody knows is the live view', () => {
  expect(route_of('#/nowhere/x')).toMatchObject({ view: 'operate', run: 'x' });
  expect(route_of('')).toMatchObject({ view: 'operate', run: '' });
  expect(route_of('#/results/a%2Fb')).toMatchObject({ view: 'results', run: 'a/b' });
});

test('what is left empty is not asked for', () => {
  const form = new FormData();
  form.set('what', 'mission:biohazard');
  form.set('map', 'office');
  form.set('robots', '');
  form.set('speed', '0');
  expect(wanted_of(form)).toEqual({ mission_name: 'biohazard', map_name: 'office', speed: 0 });
});
