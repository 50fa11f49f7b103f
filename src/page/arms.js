/* The arms of 1987 at the position typed, and a thousand of them made to tolerances. */

import { by, make, shown } from './dom.js';
import * as engine from './engine.js';
import { typedFor } from './published.js';
import { View, drawArm, drawCloud } from './scene.js';

const COUNT = 1000;
const SEED = 1987;
const armOf = { intella: 'intelledex605t', adpta: 'adeptone' };
const namesOf = { intella: ['x', 'y', 'z', 'gamma', 'beta', 'alpha'], adpta: ['x', 'y', 'z', 'theta'] };

function numbersOf(text) {
  const numbers = text.trim().split(/\s+/).map(Number);
  return numbers.every(Number.isFinite) ? numbers : [];
}

/** Views need WebGL; where a machine has none the numbers are still there. */
function viewOf(id, distance) {
  try {
    return new View(by(id), distance);
  } catch {
    by(id).replaceWith(make('p', { class: 'note' }, 'This browser shows no three dimensions (WebGL is off).'));
    return null;
  }
}

export function startArms() {
  const armView = viewOf('arm-view', 3);
  const cloudView = viewOf('cloud-view', 8);
  const program = () => by('arm-program').value;
  let drawn;

  function draw(frames) {
    if (frames.error) return;
    if (armView) drawArm(armView, frames.frames);
    const tool = frames.frames.at(-1);
    by('arm-said').textContent = `${frames.title}: ${frames.frames.length} frames, the base’s first; the tool is at ` +
      `(${[3, 7, 11].map((i) => shown(tool[i], 3)).join(', ')}) ${frames.unit}.`;
  }

  function drawShares() {
    if (!drawn) return;
    const kind = by('cloud-kind').value;
    const { errors } = drawn.cloud[kind];
    if (cloudView) drawCloud(cloudView, errors, drawn.accuracy);
    by('cloud-said').textContent = ['published', 'corrected'].map((name) => {
      const { within, length, angle } = drawn.cloud[name];
      return `Made to the ${name} tolerances (${shown(length)} mm and ${shown(angle)} rad for each parameter) ` +
        `${within} of ${COUNT} arms keep to the accuracy.`;
    }).join(' ');
  }

  function act() {
    const wish = numbersOf(by('arm-wish').value);
    const given = numbersOf(by('arm-accuracy').value);
    const names = namesOf[program()];
    const problem = by('arm-problem');
    problem.textContent = '';
    if (wish.length !== names.length) {
      problem.textContent = `Expected ${names.length} numbers for the position: ${names.join(' ')}.`;
      return;
    }
    const reached = engine.reach(program(), wish);
    if (reached.error) {
      problem.textContent = `The arm does not get there: ${reached.error}.`;
      return;
    }
    draw(engine.frames(armOf[program()], reached.q));
    if (given.length !== 7) {
      problem.textContent = 'Expected six tolerances and delta.';
      return;
    }
    const cloud = engine.cloud(program(), wish, given, COUNT, SEED);
    if (cloud.error) {
      problem.textContent = `No tolerances: ${cloud.error}.`;
      return;
    }
    drawn = { cloud, accuracy: given.slice(0, 6) };
    drawShares();
  }

  function typeCase() {
    const [wish, accuracy, delta] = typedFor(program(), 1);
    by('arm-wish').value = wish;
    by('arm-accuracy').value = `${accuracy} ${delta}`;
    by('arm-names').textContent = namesOf[program()].join(' ');
    act();
  }

  by('arm-program').addEventListener('change', typeCase);
  by('arm-form').addEventListener('submit', (event) => {
    event.preventDefault();
    act();
  });
  by('cloud-kind').addEventListener('change', drawShares);
  typeCase();
  return { draw };
}
