/* The lab book: its pages, made of the same Markdown when the page was built. */

import { pages } from 'page/pages.js';
import { by, make } from './dom.js';
import { addChecks } from './exercises.js';

/** @param {string} name of a page @param {string} [heading] where to go on it */
export function openPage(name, heading) {
  const page = pages.find((one) => one.name === name) ?? pages[0];
  const text = by('book-text');
  if (text.dataset.page !== page.name) {
    text.dataset.page = page.name;
    text.innerHTML = page.html;
    if (page.name === 'exercises') addChecks(text);
  }
  for (const link of by('book-pages').querySelectorAll('a')) {
    if (link.hash === `#book/${page.name}`) link.setAttribute('aria-current', 'page');
    else link.removeAttribute('aria-current');
  }
  const place = heading && text.querySelector(`[id="${CSS.escape(heading)}"]`);
  (place || by('book')).scrollIntoView();
}

export function startBook() {
  by('book-pages').append(...pages.map(({ name, title }) => make('li', {}, make('a', { href: `#book/${name}` }, title))));
}
