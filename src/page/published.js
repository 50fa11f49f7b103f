/* golden/published.tsv, as far as the page types it. */

import { published } from './engine.js';

const rows = published.split('\n').filter((line) => line && !line.startsWith('#')).map((line) => line.split('\t'));

/** What a person types for a case of the paper: a line a question. */
export function typedFor(program, number) {
  const values = (role) => rows
    .filter(([of, at, is]) => is === role && ((of === program && at === String(number)) || of === '*'))
    .map(([, , , , value]) => String(Number(value)));
  return [values('position'), values('tolerance'), values('delta')].map((list) => list.join(' '));
}

/** @returns {{program: string, number: number}[]} */
export function cases() {
  const names = rows.filter(([program]) => program !== '*').map(([program, number]) => `${program} ${number}`);
  return [...new Set(names)].map((name) => {
    const [program, number] = name.split(' ');
    return { program, number: Number(number) };
  });
}
