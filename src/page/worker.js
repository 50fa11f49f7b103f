/* armtol in a worker: a whole command line, or a share of the arms that --verify draws. */

import factory from 'wasm/engine.cjs';

let module;
let said;
let stopped = false;

async function open(bytes, files) {
  said = { out: [], err: [] };
  // Byte by byte, so that armtol sees no terminal and draws no progress bar of its own.
  module = await factory({
    wasmBinary: bytes,
    stdin: () => null,
    stdout: (byte) => byte !== null && said.out.push(byte),
    stderr: (byte) => byte !== null && said.err.push(byte),
  });
  module.FS.mkdir('/here');
  module.FS.chdir('/here');
  for (const [name, data] of files) module.FS.writeFile(name, data);
}

function withArguments(name, words) {
  const all = ['armtol', ...words].map((word) => module.allocateUTF8(word));
  const argv = module._malloc(4 * (all.length + 1));
  module.HEAPU32.set([...all, 0], argv / 4);
  return module.ccall(name, 'number', ['number', 'number'], [all.length, argv]);
}

const decode = (bytes) => new TextDecoder().decode(Uint8Array.from(bytes));
const texts = () => ({ out: decode(said.out), err: decode(said.err) });

/* Step `part`, then part + parts, and so on; between two steps a stop is heard. */
function drawNext(job, at) {
  const first = at * job.step;
  if (stopped || first >= job.total) {
    const from = module._page_verify_counted();
    const counted = module.HEAPU8.slice(from, from + module._page_verify_size());
    postMessage({ kind: 'counted', counted }, [counted.buffer]);
    return;
  }
  const count = Math.min(job.step, job.total - first);
  module._page_verify_draw(first, count);
  postMessage({ kind: 'drawn', count });
  setTimeout(drawNext, 0, job, at + job.parts);
}

const acts = {
  async run({ bytes, files, words }) {
    await open(bytes, files);
    const code = withArguments('main', words);
    postMessage({ kind: 'ended', code, ...texts() });
  },
  async draw({ bytes, files, words, part, parts, total, step }) {
    await open(bytes, files);
    const code = withArguments('page_verify_begin', words);
    if (code === 0) drawNext({ parts, total, step }, part);
    else postMessage({ kind: 'ended', code, ...texts() });
  },
  end({ others }) {
    for (const counted of others) {
      const place = module._malloc(counted.length);
      module.HEAPU8.set(counted, place);
      module._page_verify_add(place);
      module._free(place);
    }
    const code = module._page_verify_end();
    postMessage({ kind: 'ended', code, ...texts() });
  },
  stop() {
    stopped = true;
  },
};

onmessage = ({ data }) => acts[data.act](data);
