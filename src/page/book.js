/* The lab book: its pages, made of the same Markdown when the page was built. */

import { pages } from 'page/pages.js';
import { by, make } from './dom.js';
import { addChecks } from './exercises.js';

/* What is wider than its place is scrolled, also by who has no mouse. */
function makeScrollable() {
  for (const wide of by('book-text').querySelectorAll('pre, table')) {
    if (wide.scrollWidth > wide.clientWidth) wide.tabIndex = 0;
    else wide.removeAttribute('tabindex');
  }
}

/** @param {string} name of a page @param {string} [heading] where to go on it */
export function openPage(name, heading) {
  const page = pages.find((one) => one.name === name) ?? pages[0];
  const text = by('book-text');
  if (text.dataset.page !== page.name) {
    text.dataset.page = page.name;
    text.innerHTML = page.html;
    if (page.name === 'exercises') addChecks(text);
    makeScrollable();
  }
  for (const link of by('book-pages').querySelectorAll('a')) {
    if (link.hash === `#book/${page.name}`) link.setAttribute('aria-current', 'page');
    else link.removeAttribute('aria-current');
  }
  const place = heading && text.querySelector(`[id="${CSS.escape(heading)}"]`);
  (place || by('book')).scrollIntoView();
}

export function startBook() {
  new ResizeObserver(makeScrollable).observe(by('book-text'));
  by('book-pages').append(...pages.map(({ name, title }) =>
    make('li', {}, make('a', { href: `#book/${name}` }, title))));
}
