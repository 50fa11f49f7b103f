/*
 * What the page's WebAssembly prints is golden/, to the byte; and the words on the stack do what the legacy program
 * does.
 */

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { packageOf, page, root, runWasm } from './support.mjs';

const golden = (...parts) => readFileSync(path.join(root, 'golden', ...parts));

for (const [folder, options] of [['1987', []], ['corrected', ['--fix', 'all']]]) {
  for (const one of readdirSync(path.join(root, 'golden', folder))) {
    test(`golden/${folder}/${one}`, async () => {
      const program = one.replace(/-.*/, '');
      const typed = golden(folder, one, 'input').toString();
      const ran = await runWasm('programs', [program, ...options], {}, typed, { asynchronous: true });
      assert.equal(ran.code, 0);
      assert.equal(ran.err, golden(folder, one, 'dialogue').toString());
      const all = readdirSync(path.join(root, 'golden', folder, one));
      const written = all.filter((name) => !['input', 'dialogue'].includes(name));
      assert.equal(written.length, 4);
      for (const name of written) {
        assert.deepEqual(Buffer.from(ran.module.FS.readFile(`/here/${name}`)), golden(folder, one, name), name);
      }
    });
  }
}

const filesOf = (ends) => Object.fromEntries(readdirSync(path.join(root, 'golden/armtol'))
  .filter((name) => ends.some((end) => name.endsWith(end))).map((name) => [name, golden('armtol', name)]));
const read = filesOf(['.csv', '.region']);
const readAndTallies = filesOf(['.csv', '.region', '.tally']);
const questions = golden('armtol', 'commands').toString().split('\n').map((line) => /^([a-z0-9-]+): *(.*)$/.exec(line))
  .filter(Boolean);

test('golden/armtol/commands has questions', () => assert.ok(questions.length > 15));

for (const [, name, question] of questions) {
  test(`golden/armtol/${name}`, async () => {
    const files = question.startsWith('merge ') ? readAndTallies : read;
    const ran = await runWasm('engine', ['armtol', ...question.split(/\s+/)], files);
    const status = ran.code === 0 ? '' : `exit status ${ran.code}\n`;
    assert.equal(ran.both + status, golden('armtol', name).toString());
  });
}

/*
 * The table of docs/lab-book/residue.md is the legacy program's, its diagonal set by hand: another program than the
 * library.
 */
test('words on the stack give what the legacy program gives with them', async () => {
  const rows = readFileSync(path.join(root, 'docs/lab-book/residue.md'), 'utf8').split('\n')
    .map((line) => /^\|.*\| `(x?[0-9a-f]+) (\d) (\d)` \|.*\| (\d+) of 66 \|/.exec(line)).filter(Boolean)
    .filter(([line]) => !line.includes('both programs'));
  assert.ok(rows.length >= 6);
  const { module } = await runWasm('engine', ['armtol', '--version'], {});
  module.FS.writeFile('/published.tsv', golden('published.tsv'));
  assert.equal(module.ccall('page_open', 'number', ['string'], ['/published.tsv']), 1);
  const float = (text) => (text.startsWith('x') ? parseInt(text.slice(1), 16) : text === '1' ? 0x3f800000 : 0);
  for (const [, first, second, third, expected] of rows) {
    const { cases } = JSON.parse(module.ccall('page_stack', 'string', ['number', 'number', 'number'],
      [first, second, third].map(float)));
    const results = cases.flatMap((one) => one.results);
    assert.equal(results.length, 66);
    assert.equal(results.filter(({ verdict }) => verdict.startsWith('agrees')).length, Number(expected), first);
  }
});

test('the lock file names no registry', () => {
  assert.doesNotMatch(readFileSync(path.join(root, 'src/page/make/package-lock.json'), 'utf8'), /https?:/);
  assert.ok(packageOf('esbuild-wasm'));
  assert.ok(readFileSync(path.join(page, 'index.html')).length < 3e6);
});
