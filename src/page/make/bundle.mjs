/*
 * bundle.mjs ROOT BUILD: BUILD/page/index.html, one file with everything in it, of src/page, of BUILD/page/wasm
 * (compile) and of the packages in BUILD/page/npm. BUILD has the programs too: the exercises' references need them.
 */

import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { bookModule } from './pages.mjs';

const [root, build] = process.argv.slice(2).map((folder) => path.resolve(folder));
const out = path.join(build, 'page');
const source = path.join(root, 'src/page');
const packages = path.join(out, 'npm/node_modules');
const require = createRequire(path.join(packages, 'x.js'));
const esbuild = require('esbuild-wasm');
const { Marked } = await import(pathToFileURL(path.join(packages, 'marked/lib/marked.esm.js')));

const read = (...parts) => readFileSync(path.join(...parts), 'utf8');

const shared = {
  bundle: true, minify: true, write: false, logLevel: 'warning', target: 'es2022', legalComments: 'none',
  nodePaths: [packages, out, root], external: ['fs', 'path', 'crypto'], absWorkingDir: source,
  loader: { '.wasm': 'binary', '.tsv': 'text', '.bundle': 'text' },
};

function bundle(entry, format) {
  return esbuild.buildSync({ ...shared, entryPoints: [path.join(source, entry)], format }).outputFiles[0].text;
}

/* What ends a script or a comment in HTML must not stand in one. */
const inScript = (text) => text.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');

function licences() {
  const used = ['@xterm/xterm', 'three', 'marked'];
  const texts = used.map((name) => {
    const folder = path.join(packages, name);
    return `${name}\n\n${read(folder, readdirSync(folder).find((file) => /^licen[cs]e/i.test(file)))}`;
  });
  const expat = `expat\n\n${read(out, 'expat/expat/COPYING')}`;
  return [`armtol\n\n${read(root, 'LICENSE')}`, ...texts, expat].join('\n\n').replace(/--+/g, '—');
}

function policyFor(script) {
  const hash = createHash('sha256').update(script).digest('base64');
  return [
    "default-src 'none'", `script-src 'sha256-${hash}' 'wasm-unsafe-eval' blob:`, 'worker-src blob:',
    "style-src 'unsafe-inline'", 'img-src data:', "connect-src 'none'", "base-uri 'none'", "form-action 'none'",
  ].join('; ');
}

mkdirSync(path.join(out, 'page'), { recursive: true });
writeFileSync(path.join(out, 'page/pages.js'), bookModule(Marked, root, build));
writeFileSync(path.join(out, 'page/worker.bundle'), bundle('worker.js', 'iife'));

const script = inScript(bundle('main.js', 'esm'));
const own = esbuild.transformSync(read(source, 'page.css'), { loader: 'css', minify: true }).code;
const style = read(packages, '@xterm/xterm/css/xterm.css') + own;
const version = /^project\(armtol VERSION ([0-9.]*)/m.exec(read(root, 'CMakeLists.txt'))[1];
const filled = { POLICY: policyFor(script), STYLE: style, VERSION: version, SCRIPT: script, LICENCES: licences() };
const html = read(source, 'page.html').replace(/@(POLICY|STYLE|VERSION|SCRIPT|LICENCES)@/g, (_, name) => filled[name]);
writeFileSync(path.join(out, 'index.html'), html);
console.log(`${path.join(out, 'index.html')}: ${Buffer.byteLength(html)} bytes`);
