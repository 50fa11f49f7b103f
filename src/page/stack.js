/* The stack: two frames on the same piece of memory, and three words that a reader may choose. */

import stack from 'docs/lab-book/figures/stack.tsv';
import { by, make, shown } from './dom.js';
import * as engine from './engine.js';

const places = ['skew[0][0]', 'skew[1][1]', 'skew[2][2]'];
const hex = (word) => (word >>> 0).toString(16).padStart(8, '0');

/* From S, the stack pointer of main, down to the last word of getj that is seen: the table of the lab book's figure. */
const rows = stack.split('\n').filter((line) => line && !line.startsWith('#')).map((line) => line.split('\t'))
  .map(([place, left, , right]) => ({ place: `S - ${place}`, left, right, unset: places.indexOf(right) }))
  .slice(0, 13);

function presets() {
  const alpha = engine.toolAlpha();
  const [, sine, third] = engine.toolResidue().map(engine.wordOf);
  return [
    { id: 'm68020', name: '68020: IEEE, the upper half first', words: [engine.upperHalf(alpha), sine, third] },
    { id: 'vax', name: 'VAX: a double begins with a float', words: [engine.wordOf(alpha), sine, third] },
    { id: 'little', name: 'IEEE, little-endian: the lower half first', words: [engine.lowerHalf(alpha), sine, third] },
    { id: 'zero', name: 'zeros: as if the words had been set', words: [0, 0, 0] },
  ];
}

/* The numbers that the words decide: those that are not as published where the words are zeros. */
function deciding() {
  return engine.bench(['skew-residue']).flatMap((one, at) => one.results
    .map((result, i) => ({ at, i, name: `${one.program} ${one.number}: ${result.quantity}`, result }))
    .filter(({ result }) => !result.verdict.startsWith('agrees')));
}

function halves() {
  const alpha = engine.toolAlpha();
  const upper = engine.upperHalf(alpha);
  const lower = engine.lowerHalf(alpha);
  const cells = (...texts) => make('tr', {}, make('th', { scope: 'row' }, texts[0]),
    ...texts.slice(1).map((text) => make('td', {}, text)));
  return make('table', { class: 'numbers' },
    make('caption', {}, 'alpha of the Adept’s tool, as adpta keeps it'),
    make('thead', {}, make('tr', {}, ...['what', 'word', 'seen by a float']
      .map((text) => make('th', { scope: 'col' }, text)))),
    make('tbody', {},
      cells('alpha as a float', hex(engine.wordOf(alpha)), shown(alpha, 9)),
      cells('upper half of alpha as a double', hex(upper), shown(engine.floatOf(upper), 9)),
      cells('lower half of alpha as a double', hex(lower), shown(engine.floatOf(lower), 9))));
}

function framesTable(words) {
  return make('table', { class: 'frames' },
    make('caption', {}, 'The frame of gnpr for the tool, and the frame of getj for the base, on the same words'),
    make('thead', {}, make('tr', {}, ...['place', 'gnpr has left there', 'word', 'getj has there']
      .map((text) => make('th', { scope: 'col' }, text)))),
    make('tbody', {}, ...rows.map(({ place, left, right, unset }) => make('tr', { class: unset < 0 ? '' : 'unset' },
      make('th', { scope: 'row' }, place), make('td', {}, left),
      make('td', {}, unset < 0 ? '' : make('code', {}, hex(words[unset]))),
      make('td', {}, unset < 0 ? right : make('strong', {}, `${right}, never set`))))));
}

/* One word: its digits, and a slider over what a float sees there. */
function field(i, changed) {
  const digits = make('input', {
    id: `word-${i}`, type: 'text', maxlength: '8', size: '8', spellcheck: 'false', autocomplete: 'off',
    'aria-describedby': `seen-${i}`,
  });
  const slider = make('input', { id: `slider-${i}`, type: 'range', min: '-4', max: '4', step: '0.001' });
  const seen = make('output', { id: `seen-${i}`, for: `word-${i} slider-${i}` });
  const node = make('div', { class: 'word' },
    make('label', { for: `word-${i}` }, `${places[i]}, hexadecimal`), digits,
    make('label', { for: `slider-${i}` }, `${places[i]}, as a float`), slider, seen);
  digits.addEventListener('input', () => {
    const fine = /^[0-9a-f]{8}$/i.test(digits.value);
    digits.setAttribute('aria-invalid', String(!fine));
    if (fine) changed(i, parseInt(digits.value, 16), digits);
    else seen.textContent = 'expected eight hexadecimal digits';
  });
  slider.addEventListener('input', () => changed(i, engine.wordOf(Number(slider.value)), slider));
  return {
    node,
    show(word, except) {
      const value = engine.floatOf(word);
      const fine = Number.isFinite(value);
      if (except !== digits) digits.value = hex(word);
      digits.setAttribute('aria-invalid', 'false');
      if (except !== slider) slider.value = String(fine ? value : 0);
      seen.textContent = fine ? `a float sees ${Number(value.toPrecision(9))}` : 'a float sees no number';
    },
  };
}

export function startStack() {
  const answering = deciding();
  const kinds = presets();
  let words = kinds[0].words;
  const fields = places.map((_, i) =>
    field(i, (at, word, origin) => set(words.map((old, n) => (n === at ? word : old)), origin)));

  function set(chosen, origin) {
    words = chosen;
    const cases = engine.stack(words);
    const preset = kinds.find((kind) => kind.words.every((word, i) => word === words[i]));
    fields.forEach((one, i) => one.show(words[i], origin));
    for (const button of by('stack-presets').children) {
      button.setAttribute('aria-pressed', String(button.id === `preset-${preset?.id}`));
    }
    by('stack-frames').replaceChildren(framesTable(words));
    by('stack-count').textContent = `${preset ? preset.name : 'Words of your own'}: ` +
      `${engine.agreeing(cases)} of ${engine.countOf(cases)} published numbers come out.`;
    by('stack-numbers').replaceChildren(...answering.map(({ at, i, name }) => {
      const result = cases[at].results[i];
      const missed = !result.verdict.startsWith('agrees');
      return make('tr', { class: missed ? 'missed' : '' }, make('th', { scope: 'row' }, name),
        make('td', {}, result.published), make('td', {}, result.computed),
        make('td', {}, make('span', { class: 'mark', 'aria-hidden': 'true' }, missed ? '≠' : '='), ' ',
          result.verdict));
    }));
  }

  by('stack-words').append(...fields.map((one) => one.node));
  by('stack-presets').append(...kinds.map((kind) => make('button', {
    type: 'button', id: `preset-${kind.id}`, 'aria-pressed': 'false', onclick: () => set(kind.words),
  }, kind.name)));
  by('stack-halves').append(halves());
  set(words);
}
