/* The bench: errata as switches, and the 66 numbers that turn with them. */

import { by, make, shown } from './dom.js';
import * as engine from './engine.js';

const marks = { agrees: '=', 'agrees without its sign': '= ±', differs: '≠', missing: '?' };
const unitOf = { distance: 'mm', angle: 'rad' };

function row(result, before) {
  const missed = !result.verdict.startsWith('agrees');
  const turned = before !== undefined && before !== result.computed;
  return make('tr', { class: `${missed ? 'missed' : ''} ${turned ? 'turned' : ''}` },
    make('th', { scope: 'row' }, result.quantity),
    make('td', {}, result.published),
    make('td', {}, result.computed || '–'),
    make('td', {}, make('span', { class: 'mark', 'aria-hidden': 'true' }, marks[result.verdict]), ' ', result.verdict));
}

function tableOf(one, before) {
  const agree = one.results.filter((result) => result.verdict.startsWith('agrees')).length;
  return make('table', { class: 'numbers' },
    make('caption', {}, `${one.program}, case ${one.number}: ${agree} of ${one.results.length} as published`),
    make('thead', {}, make('tr', {}, ...['number', 'published', 'computed', 'verdict']
      .map((text) => make('th', { scope: 'col' }, text)))),
    make('tbody', {}, ...one.results.map((result, i) => row(result, before?.results[i]?.computed))));
}

/* A bar for what the switches give and one for all errata corrected, as parts of the larger. */
function bars(kind, now, corrected) {
  const most = Math.max(...now.map((one) => one[kind]), ...corrected.map((one) => one[kind]));
  const bar = (label, value, style) => make('div', { class: 'bar-row' },
    make('span', { class: 'bar-label' }, label),
    make('span', { class: 'bar-track', 'aria-hidden': 'true' },
      make('span', { class: `bar ${style}`, style: `width: ${(100 * value) / most}%` })),
    make('span', { class: 'bar-value' }, `${shown(value)} ${unitOf[kind]}`));
  return make('section', { class: 'bars', 'aria-label': `Bounds on the error in ${kind} parameters` },
    make('h4', {}, `Bound on the error in ${kind} parameters`),
    ...now.flatMap((one, i) => [
      bar(`${one.program} ${one.number}, these switches`, one[kind], 'now'),
      bar(`${one.program} ${one.number}, all corrected`, corrected[i][kind], 'corrected')]));
}

export function startBench() {
  const errata = engine.errata();
  const corrected = engine.bench(errata.map(({ id }) => id));
  let before;

  const boxes = errata.map(({ id }) =>
    make('input', { type: 'checkbox', id: `erratum-${id}`, value: id, onchange: turn }));
  const chosen = () => boxes.filter((box) => box.checked).map((box) => box.value);

  function turn() {
    const now = engine.bench(chosen());
    by('bench-count').textContent =
      `${engine.agreeing(now)} of ${engine.countOf(now)} published numbers come out with ` +
      `${chosen().length} of ${errata.length} errata corrected.`;
    by('bench-bars').replaceChildren(bars('distance', now, corrected), bars('angle', now, corrected));
    by('bench-tables').replaceChildren(...now.map((one, i) => tableOf(one, before?.[i])));
    before = now;
  }

  function set(checked) {
    for (const box of boxes) box.checked = checked;
    turn();
  }

  by('bench-switches').append(...errata.map(({ id, slip, touches }, i) => {
    boxes[i].setAttribute('aria-describedby', `slip-${id}`);
    return make('div', { class: 'switch' }, boxes[i],
      make('label', { for: `erratum-${id}` }, make('code', {}, id)),
      make('p', { id: `slip-${id}` }, `${slip}. Seen in: ${touches}.`));
  }));
  by('bench-none').addEventListener('click', () => set(false));
  by('bench-all').addEventListener('click', () => set(true));
  turn();
}
