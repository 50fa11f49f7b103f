/* Elements, briefly. */

/** The element of that id. */
export const by = (id) => document.getElementById(id);

/**
 * A new element. Properties that begin with `on` are listeners; the others are attributes.
 * @param {string} tag @param {Object<string, any>} [attributes] @param {...(Node|string)} children
 */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

/** Offers data as a file to be kept. */
export function save(name, data) {
  const link = make('a', { href: URL.createObjectURL(new Blob([data])), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** A link into the lab book. */
export const toBook = (page, text) => make('a', { href: `#book/${page}` }, text);

/** So many decimals; what is no number is said to be none. */
export const shown = (value, decimals = 6) => (Number.isFinite(value) ? value.toFixed(decimals) : 'no number');
