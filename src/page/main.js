/* The page: one part at a time is shown, the one that the address names. */

import { startArms } from './arms.js';
import { startAsk } from './ask.js';
import { startBench } from './bench.js';
import { openPage, startBook } from './book.js';
import { by } from './dom.js';
import { openEngine } from './engine.js';
import { startStack } from './stack.js';
import { startTerminal } from './terminal.js';

const parts = ['terminal', 'bench', 'stack', 'arms', 'book'];
const first = parts[0];

/* A part is made when it is first looked at. */
const starts = {
  terminal: startTerminal,
  bench: startBench,
  stack: startStack,
  arms: () => startAsk(startArms().draw),
  book: startBook,
};
const started = new Set();

function route() {
  const [part, page, heading] = decodeURIComponent(location.hash.slice(1)).split('/');
  const shown = parts.includes(part) ? part : first;
  for (const name of parts) by(name).hidden = name !== shown;
  for (const link of document.querySelectorAll('nav[aria-label="Parts"] a')) {
    if (link.hash === `#${shown}`) link.setAttribute('aria-current', 'page');
    else link.removeAttribute('aria-current');
  }
  if (!started.has(shown)) {
    started.add(shown);
    starts[shown]();
  }
  if (shown === 'book') openPage(page ?? 'index', heading);
}

await openEngine();
addEventListener('hashchange', () => {
  route();
  by('main').focus({ preventScroll: true });
});
route();
performance.mark('ready');
document.documentElement.dataset.ready = 'yes';
