/*
 * The exercises check themselves. What an answer is compared with comes from exercises/N.reference, run when the page
 * was built: formulas, or other programs than those of the exercise (docs/lab-book/check-exercise).
 */

import { references } from 'page/pages.js';
import { make } from './dom.js';

const number = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;

/** @param {{name: string, value: string, tolerance: string}} wanted @param {string} given */
export function isRight(wanted, given) {
  const text = given.trim();
  if (wanted.tolerance === '-') return text === wanted.value;
  return number.test(text) && Math.abs(Number(text) - Number(wanted.value)) <= Number(wanted.tolerance);
}

function formOf(exercise) {
  const { wanted } = exercise;
  const inputs = wanted.map(({ name }) => make('input', {
    type: 'text', id: `answer-${exercise.number}-${name}`, autocomplete: 'off', spellcheck: 'false',
  }));
  const verdict = make('output', { class: 'verdict' });
  const check = (event) => {
    event.preventDefault();
    const wrong = wanted.filter((one, i) => !isRight(one, inputs[i].value)).map(({ name }) => name);
    inputs.forEach((input, i) => input.setAttribute('aria-invalid', String(!isRight(wanted[i], input.value))));
    verdict.textContent = wrong.length === 0 ? '✓ right' : `✗ not right: ${wrong.join(', ')}`;
  };
  return make('form', { class: 'check', 'aria-label': `Your answer to exercise ${exercise.number}`, onsubmit: check },
    ...wanted.map(({ name }, i) => make('label', {}, name, inputs[i])),
    make('button', { type: 'submit' }, 'Check'), verdict);
}

/** A form before the answer of each exercise that has a reference. */
export function addChecks(text) {
  for (const exercise of references) {
    const heading = [...text.querySelectorAll('h2')].find((one) => one.textContent.startsWith(`${exercise.number}.`));
    let answer = heading?.nextElementSibling;
    while (answer && answer.tagName !== 'DETAILS' && answer.tagName !== 'H2') answer = answer.nextElementSibling;
    answer?.before(formOf(exercise));
  }
}
