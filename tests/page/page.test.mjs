/*
 * The page in Chromium, opened as a file, by real clicks and keys. What it shows is held against the programs of the
 * build.
 */

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { address, packageFile, packageOf, page as built, root } from './support.mjs';

const { chromium } = packageOf('playwright-core');
const axe = readFileSync(packageFile('axe-core/axe.min.js'), 'utf8');
const programs = path.dirname(built);
const scratch = mkdtempSync(path.join(tmpdir(), 'armtol-page-'));
const shots = path.join(built, 'shots');
const goldenFile = (...parts) => readFileSync(path.join(root, 'golden', ...parts), 'utf8');

let browser;

before(async () => {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    // a container has no namespaces for the sandbox and no graphics card
    args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader'],
  });
});
after(() => browser.close());

/** A page at that part; what goes wrong in it, and every request that leaves the file, fails the test at its end. */
async function withPage(part, act, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 1000 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(60000);
  const wrong = [];
  page.on('pageerror', (error) => wrong.push(error.message));
  page.on('console', (message) => message.type() === 'error' && wrong.push(message.text()));
  page.on('request', (request) => /^(file|blob|data):/.test(request.url()) || wrong.push(request.url()));
  try {
    await page.goto(`${address}#${part}`);
    await page.waitForSelector('html[data-ready=yes]');
    await act(page, wrong);
    assert.deepEqual(wrong, []);
  } finally {
    await context.close();
  }
}

const screenOf = (page) => page.evaluate(() => [...document.querySelectorAll('.xterm-rows > div')]
  .map((row) => row.textContent.replace(/\u00a0/g, ' ').trimEnd()).join('\n'));

async function waitForScreen(page, text) {
  for (let i = 0; i < 300; i++) {
    if ((await screenOf(page)).includes(text)) return;
    await page.waitForTimeout(100);
  }
  assert.fail(`${text} is not on the screen:\n${await screenOf(page)}`);
}

async function fileOf(page, name) {
  await page.click(`[role=tab]:text-is("${name}")`);
  return page.textContent('#file-panel');
}

for (const [program, prefix] of [['intella', 'int'], ['adpta', 'adpt']]) {
  for (const number of [1, 2]) {
    const what = `terminal: a click on ${program}, case ${number}, gives the files of golden/`;
    test(what, () => withPage('terminal', async (page) => {
      await page.click(`text=${program}, case ${number}`);
      await page.waitForFunction((name) =>
        document.getElementById('terminal-status').textContent === `${name} is done.`, program);
      for (const kind of ['a', 'at', 'tol', 'mach']) {
        const name = `${prefix}${kind}.1`;
        assert.equal(await fileOf(page, name), goldenFile('1987', `${program}-${number}`, name));
      }
    }));
  }
}

test('terminal: typed, a wrong answer is asked again, keys edit the line', () => withPage('terminal', async (page) => {
  await page.click('#screen');
  await page.keyboard.type('adpta --fix all\n');
  await waitForScreen(page, 'enter desired position:');
  await page.keyboard.type('200 abc 0 0\n');
  await waitForScreen(page, 'y: "abc" is not a number');
  await page.keyboard.type('9000 0 0 0\n');
  await waitForScreen(page, 'out of reach');
  await page.keyboard.type('200 2009');
  await page.keyboard.press('Backspace');
  await page.keyboard.type(' 0 0\n.5 .5 .5 .1 .1 .1\n');
  await waitForScreen(page, 'enter desired delta:');
  await page.keyboard.type('.1\n');
  await page.waitForFunction(() => document.getElementById('terminal-status').textContent === 'adpta is done.');
  assert.equal(await fileOf(page, 'adptmach.1'), goldenFile('corrected', 'adpta-1', 'adptmach.1'));
}));

test('terminal: pasted lines, a file saved, Control-C', () => withPage('terminal', async (page) => {
  await page.click('#screen');
  await page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData('text/plain', text);
    const pasted = new ClipboardEvent('paste', { clipboardData: data, bubbles: true });
    document.querySelector('.xterm-helper-textarea').dispatchEvent(pasted);
  }, `adpta\n${goldenFile('1987', 'adpta-2', 'input')}`);
  await page.waitForFunction(() => document.getElementById('terminal-status').textContent === 'adpta is done.');
  await page.click('[role=tab]:text-is("adpttol.1")');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#file-save')]);
  const kept = path.join(scratch, download.suggestedFilename());
  await download.saveAs(kept);
  assert.equal(readFileSync(kept, 'utf8'), goldenFile('1987', 'adpta-2', 'adpttol.1'));
  await page.click('#screen');
  await page.keyboard.type('intella\n');
  await waitForScreen(page, 'enter desired position:');
  await page.keyboard.press('Control+C');
  await page.keyboard.type('ls\n');
  await waitForScreen(page, 'adptmach.1');
}));

const countOn = async (page, id) => Number(/(\d+) of 66/.exec(await page.textContent(id))[1]);

/* The program reproduce counts apart from the page, from the files that the programs write. */
test('bench: all 66 numbers, and as many as with --fix for each erratum', () => withPage('bench', async (page) => {
  assert.equal(await countOn(page, '#bench-count'), 66);
  assert.equal(await page.locator('#bench-tables tbody tr').count(), 66);
  const listed = execFileSync(path.join(programs, 'intella'), ['--list-errata'], { encoding: 'utf8' });
  const boxes = page.locator('#bench-switches input[type=checkbox]');
  const ids = await boxes.evaluateAll((all) => all.map((box) => box.value));
  assert.ok(ids.length >= 14);
  for (const id of ids) assert.ok(listed.includes(id), id);
  for (const id of ['skew-residue', 'labels', 'root-of-ratio']) {
    await page.check(`#erratum-${id}`);
    assert.equal(await countOn(page, '#bench-count'), 66 - differing(id), id);
    await page.uncheck(`#erratum-${id}`);
  }
  await page.focus('#erratum-mtransf-typo');
  await page.keyboard.press('Space');
  assert.ok(await page.isChecked('#erratum-mtransf-typo'));
  const missed = page.locator('#bench-tables tr.missed');
  assert.ok((await missed.count()) > 0);
  assert.match(await missed.first().textContent(), /≠.*differs/);
  await page.click('#bench-all');
  const bars = await page.textContent('#bench-bars');
  for (const [program, number] of [['intella', '1'], ['adpta', '2']]) {
    const lines = textsOf(program, number, 'all').matchAll(/A bound on .* = +([0-9.]+)/g);
    const bounds = [...lines].map((found) => found[1]);
    assert.equal(bounds.length, 2);
    assert.ok(bars.includes(`${program} ${number}, these switches${bounds[0]} mm`), bounds[0]);
    assert.ok(bars.includes(`${program} ${number}, all corrected${bounds[1]} rad`), bounds[1]);
  }
}));

/* What the program of the build writes for a case of the paper, with an erratum corrected: tolerances, then parts. */
function textsOf(program, number, fix) {
  const prefix = { intella: 'int', adpta: 'adpt' }[program];
  const input = goldenFile('1987', `${program}-${number}`, 'input');
  const { status } = spawnSync(path.join(programs, program), ['--fix', fix, '-o', scratch], { input });
  assert.equal(status, 0);
  return ['tol', 'mach'].map((kind) => readFileSync(path.join(scratch, `${prefix}${kind}.1`), 'utf8')).join('');
}

/* How many published numbers an erratum's correction changes. */
function differing(id) {
  const rows = goldenFile('published.tsv').split('\n').map((line) => line.split('\t'));
  const published = rows.filter(([, , role]) => role === 'result');
  const texts = {};
  for (const program of ['intella', 'adpta']) {
    for (const number of ['1', '2']) texts[program + number] = textsOf(program, number, id);
  }
  return published.filter(([program, number, , quantity, value, remark]) => {
    const label = quantity.replace(/\[(\d)\.\.\d\]/, '[$1]');
    const at = texts[program + number].indexOf(`${label} = `);
    const found = texts[program + number].slice(at + label.length + 3).trim().split(/\s/)[0];
    return (remark === 'unsigned' ? found.replace('-', '') : found) !== value;
  }).length;
}

/* The figures are those of the lab book's line-up, which the legacy program gives. */
test('stack: the machines, a word typed, a slider moved', () => withPage('stack', async (page) => {
  const lineUp = { m68020: 66, vax: 64, little: 60, zero: 61 };
  for (const [id, count] of Object.entries(lineUp)) {
    await page.click(`#preset-${id}`);
    assert.equal(await countOn(page, '#stack-count'), count, id);
  }
  assert.equal(await page.locator('#stack-numbers tr').count(), 5);
  assert.equal(await page.locator('#stack-numbers tr.missed').count(), 5);
  await page.click('#preset-zero');
  await page.fill('#word-0', '3ff921fa');
  await page.fill('#word-1', '3f800000');
  assert.equal(await countOn(page, '#stack-count'), 66);
  assert.equal(await page.getAttribute('#preset-m68020', 'aria-pressed'), 'true');
  await page.fill('#word-0', 'xyz');
  assert.equal(await page.getAttribute('#word-0', 'aria-invalid'), 'true');
  await page.click('#preset-m68020');
  await page.focus('#slider-0');
  await page.keyboard.press('Home');
  assert.ok((await countOn(page, '#stack-count')) < 66);
  assert.match(await page.textContent('#seen-0'), /-4$/);
}));

test('arms: the share inside is that of yield; the views are drawn', () => withPage('arms', async (page) => {
  const said = await page.textContent('#cloud-said');
  const [published, corrected] = [...said.matchAll(/(\d+) of 1000/g)].map((found) => Number(found[1]));
  const rows = execFileSync(path.join(programs, 'yield'), ['--samples', '1000', '--seed', '1987', '--format', 'tsv',
    path.join(root, 'golden/published.tsv')], { encoding: 'utf8' });
  const share = `(${published / 10}|${(published / 10).toFixed(1)}|${published})`;
  assert.match(rows, new RegExp(`adpta\\s+1[^\\n]*\\b${share}\\b`));
  assert.equal(corrected, 1000);
  for (const id of ['arm-view', 'cloud-view']) {
    const before = await page.locator(`#${id}`).screenshot();
    await page.focus(`#${id}`);
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    assert.notDeepEqual(await page.locator(`#${id}`).screenshot(), before);
  }
  await page.fill('#arm-wish', '5000 0 0 0');
  await page.click('text=Move, and make the arms');
  assert.match(await page.textContent('#arm-problem'), /does not get there/);
}));

const native = (...words) => spawnSync(path.join(programs, 'armtol'), words, { cwd: scratch, encoding: 'utf8' });

async function ask(page, command) {
  await page.fill('#ask-command', command);
  await page.click('#ask-run');
  await page.waitForSelector('#ask-run:enabled');
}

test('armtol: shards merge to one count; a stop tells what was drawn', () => withPage('arms', async (page) => {
  const command = 'puma560 --joints 0,0.8,-2.5,0,0.8,0 --accuracy .5,.5,.5,.002,.002,.002';
  await ask(page, `${command} --verify 300000`);
  assert.equal(await page.textContent('#ask-output'), native(...command.split(' '), '--verify', '300000').stdout);
  await page.fill('#ask-command', `${command} --verify 10000000`);
  await page.click('#ask-run');
  await page.waitForFunction(() => document.getElementById('ask-progress').value > 0);
  await page.click('#ask-stop');
  await page.waitForSelector('#ask-run:enabled');
  assert.match(await page.textContent('#ask-output'), /armtol|arms/);
  assert.doesNotMatch(await page.textContent('#ask-output'), /\b10000000\b/);
  await ask(page, 'nobody --joints 0 --accuracy 1,1,1,1,1,1');
  const said = await page.textContent('#ask-message');
  assert.match(said, /nobody is neither a built-in arm .* nor a file\s+exit status 2/);
}));

/** Drops a file on the page, as a mouse does. */
const drop = (page, name, text) => page.evaluate(([file, content]) => {
  const data = new DataTransfer();
  data.items.add(new File([content], file));
  const drop = new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true });
  document.getElementById('ask-drop').dispatchEvent(drop);
}, [name, text]);

const urdf = `<robot name="two"><link name="base"/><link name="upper"/><link name="tip"/>
<joint name="one" type="revolute"><parent link="base"/><child link="upper"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1"/></joint>
<joint name="two" type="revolute"><parent link="upper"/><child link="tip"/><origin xyz="0.5 0 0.1"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="2"/></joint></robot>`;

test('armtol: a table, a URDF, and wrong files, told as the program does', () => withPage('arms', async (page) => {
  const broken = 'kind,joint,a,alpha,d,theta,beta\nnpr,revolute,abc,0,0,0,0\n';
  const files = {
    'crane.csv': goldenFile('armtol', 'crane.csv'), 'two.urdf': urdf,
    'broken.csv': broken, 'broken.urdf': urdf.slice(0, 200),
  };
  for (const [name, text] of Object.entries(files)) {
    writeFileSync(path.join(scratch, name), text);
    const told = native(name, '--show');
    await page.evaluate(() => {
      for (const id of ['ask-output', 'ask-message']) document.getElementById(id).textContent = '';
    });
    await drop(page, name, text);
    await page.waitForFunction(() =>
      document.getElementById('ask-output').textContent + document.getElementById('ask-message').textContent);
    assert.equal(told.status, name.startsWith('broken') ? 2 : 0, told.stderr);
    assert.equal(await page.textContent('#ask-output'), told.stdout, name);
    const ended = told.status ? `exit status ${told.status}` : '';
    assert.equal(await page.textContent('#ask-message'), told.stderr + ended, name);
  }
}));

const book = 'lab book: linked from where one stands; pages, figures and headings; exercises check themselves';
test(book, () => withPage('stack', async (page) => {
  await page.click('text=The detective story');
  await page.waitForSelector('#book-text h1:text-is("The word on the stack")');
  assert.ok(await page.evaluate(() => [...document.querySelectorAll('#book-text img')]
    .every((image) => image.complete && image.naturalWidth > 0)));
  const links = await page.locator('#book-pages a').evaluateAll((all) => all.map((link) => link.hash));
  assert.equal(links.length, 12);
  for (const hash of links) {
    await page.click(`#book-pages a[href="${hash}"]`);
    await page.waitForSelector(`#book-text[data-page="${hash.split('/')[1]}"] h1`);
    const dead = await page.locator('#book-text a').evaluateAll((all) =>
      all.map((link) => link.getAttribute('href')).filter((to) => !to.startsWith('#book/')));
    assert.deepEqual(dead, []);
  }
  await page.click('#book-pages a[href="#book/exercises"]');
  const check = page.locator('form.check').nth(1);
  const answers = [
    ['bounds', '2'], ['parts', '1.41'], ['corrected', '2'], ['erratum', 'root-of-ratio'], ['metres', '30'],
  ];
  for (const [name, value] of answers) {
    await check.getByLabel(name).fill(value);
  }
  await check.getByRole('button').click();
  assert.equal(await check.locator('.verdict').textContent(), '✗ not right: metres');
  await check.getByLabel('metres').fill('31.62');
  await page.keyboard.press('Enter');
  assert.equal(await check.locator('.verdict').textContent(), '✓ right');
}));

test('the keyboard alone gets to every part and out of the terminal', () => withPage('terminal', async (page) => {
  await page.focus('.xterm-helper-textarea');
  await page.keyboard.press('Shift+Tab');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'adpta, case 2');
  for (const part of ['bench', 'stack', 'arms', 'book']) {
    await page.focus('nav a[href="#terminal"]');
    for (let i = 0; i < 6 && (await page.evaluate(() => document.activeElement.hash)) !== `#${part}`; i++) {
      await page.keyboard.press('Tab');
    }
    await page.keyboard.press('Enter');
    await page.waitForSelector(`#${part}:not([hidden])`);
  }
}));

test('the policy in the file forbids the network', () => withPage('terminal', async (page, wrong) => {
  const refused = await page.evaluate(() => new Promise((resolve) => {
    addEventListener('securitypolicyviolation', (event) => resolve(event.effectiveDirective));
    fetch('http://127.0.0.1:9/').catch(() => {});
  }));
  assert.equal(refused, 'connect-src');
  wrong.length = 0; // the browser tells of it, as it should
}));

for (const [look, options] of [
  ['light', { colorScheme: 'light' }], ['dark', { colorScheme: 'dark' }],
  ['narrow', { viewport: { width: 360, height: 740 }, colorScheme: 'light', reducedMotion: 'reduce' }],
]) {
  test(`axe finds nothing serious, and nothing is wider than the window: ${look}`, async () => {
    for (const part of ['terminal', 'bench', 'stack', 'arms', 'book/residue', 'book/exercises']) {
      await withPage(part, async (page) => {
        if (part === 'terminal') await page.click('text=adpta, case 1');
        if (part === 'bench') await page.check('#erratum-mtransf-typo');
        await page.waitForTimeout(500);
        await page.screenshot({ path: path.join(shots, `${look}-${part.replace('/', '-')}.png`), fullPage: true });
        await page.evaluate(axe);
        const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
        const serious = violations.filter(({ impact }) => ['serious', 'critical'].includes(impact))
          .map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).slice(0, 3).join(' | ')}`);
        assert.deepEqual(serious, [], part);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${part} is too wide`);
      }, options);
    }
  });
}

test('it is interactive soon', () => withPage('terminal', async (page) => {
  const ready = await page.evaluate(() => Math.round(performance.getEntriesByName('ready')[0].startTime));
  console.log(`# interactive after ${ready} ms`);
  assert.ok(ready < 10000); // 2 s on an idle machine; a busy one may take longer
}));
