/* The lab book as the page has it: HTML of the same Markdown, and what the exercises are checked with. */

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';

const order = ['index', 'report', 'reproduction', 'errata', 'residue', 'tolerances', 'inverse-kinematics', 'exercises',
  'reading', 'another-program', 'bounds', 'joint-orders'];

/* As the links to headings are written (tests/docs/links). */
function slug(text) {
  const plain = text.replace(/<[^>]*>/g, '').replace(/&[a-z#0-9]+;/g, '').toLowerCase();
  return plain.replace(/[^a-z0-9 _-]/g, '').replace(/ /g, '-');
}

function imageOf(folder, href) {
  const data = readFileSync(path.join(folder, href)).toString('base64');
  return `data:image/svg+xml;base64,${data}`;
}

/* Pages of the book are in the file; what else is linked to lies in the repository, and is named. */
function renderer(folder) {
  return {
    heading({ tokens, depth }) {
      const html = this.parser.parseInline(tokens);
      return `<h${depth} id="${slug(html)}">${html}</h${depth}>\n`;
    },
    link({ href, tokens }) {
      const html = this.parser.parseInline(tokens);
      const [, name, heading] = /^(?:([a-z-]+)\.md)?(?:#(.*))?$/.exec(href) ?? [];
      if (name && order.includes(name)) return `<a href="#book/${name}${heading ? `/${heading}` : ''}">${html}</a>`;
      return `<span class="elsewhere">${html}</span>`;
    },
    image({ href, text }) {
      return `<img alt="${text}" src="${imageOf(folder, href)}">`;
    },
    html({ text }) {
      return text.startsWith('<!--') ? '' : text;
    },
  };
}

function pageOf(marked, folder, name) {
  const text = readFileSync(path.join(folder, `${name}.md`), 'utf8').replace(/<!--[^]*?-->\n?/g, '');
  const title = /^# (.*)$/m.exec(text)[1];
  return { name, title, html: marked.parse(text) };
}

/* `name value tolerance` a line. The tenth has a matrix, and is left to the command line. */
function referenceOf(root, programs, number) {
  const file = `docs/lab-book/exercises/${number}.reference`;
  if (!existsSync(path.join(root, file))) return null;
  const environment = { ...process.env, PATH: `${programs}:${process.env.PATH}`, LC_ALL: 'C' };
  const text = execFileSync(file, { cwd: root, env: environment, encoding: 'utf8' });
  if (text.startsWith('#')) return null;
  const wanted = text.trim().split('\n').map((line) => {
    const [name, value, tolerance] = line.split(/\s+/);
    return { name, value, tolerance };
  });
  return { number, wanted };
}

/** @param {typeof import('marked').Marked} Marked @param {string} root the repository @param {string} programs built */
export function bookModule(Marked, root, programs) {
  const folder = path.join(root, 'docs/lab-book');
  const marked = new Marked({ renderer: renderer(folder), gfm: true });
  const pages = order.map((name) => pageOf(marked, folder, name));
  const numbers = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10];
  const references = numbers.map((number) => referenceOf(root, programs, number)).filter(Boolean);
  return `export const pages = ${JSON.stringify(pages)};\nexport const references = ${JSON.stringify(references)};\n`;
}
