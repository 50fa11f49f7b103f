/* What the tests of the page share: the WebAssembly run in node as a shell runs programs, and the browser. */

import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { readFileSync } from 'node:fs';

export const root = path.resolve(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '../..');
export const page = path.resolve(process.env.BUILD ?? path.join(root, 'build'), 'page');
const require = createRequire(path.join(page, 'npm/node_modules/x.js'));

export const packageOf = (name) => require(name);
export const packageFile = (name) => require.resolve(name);
export const index = path.join(page, 'index.html');
export const address = pathToFileURL(index).href;

/**
 * @param {'programs'|'engine'} name of the module
 * @param {string[]} words of the command line
 * @param {Object<string, Buffer>} files in the folder where it runs
 * @returns {Promise<{code: number, out: string, err: string, both: string, module: object}>}
 */
export async function runWasm(name, words, files, input = '', { asynchronous = false } = {}) {
  const factory = require(path.join(page, `wasm/${name}.cjs`));
  const typed = Buffer.from(input);
  const said = { out: [], err: [], both: [] };
  let at = 0;
  const take = (stream) => (byte) => {
    if (byte === null) return;
    said[stream].push(byte);
    said.both.push(byte);
  };
  const module = await factory({
    wasmBinary: readFileSync(path.join(page, `wasm/${name}.wasm`)),
    stdin: () => (at < typed.length ? typed[at++] : null),
    stdout: take('out'),
    stderr: take('err'),
  });
  module.FS.mkdir('/here');
  module.FS.chdir('/here');
  for (const [file, data] of Object.entries(files)) module.FS.writeFile(file, data);
  const strings = words.map((word) => module.allocateUTF8(word));
  const argv = module._malloc(4 * (strings.length + 1));
  module.HEAPU32.set([...strings, 0], argv / 4);
  const types = ['number', 'number'];
  const code = await module.ccall('main', 'number', types, [strings.length, argv], { async: asynchronous });
  const text = (bytes) => Buffer.from(bytes).toString('utf8');
  return { code, out: text(said.out), err: text(said.err), both: text(said.both), module };
}
