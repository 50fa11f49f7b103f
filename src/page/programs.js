/* intella and adpta, run as in 1987. */

import factory from 'wasm/programs.cjs';
import bytes from 'wasm/programs.wasm';

/**
 * @typedef {object} Terminal
 * @property {(room: number, take: (bytes: Uint8Array) => void) => void} read  waits for a line; no bytes: the end
 * @property {(bytes: Uint8Array) => void} write
 * @property {() => boolean} ready  whether read would not wait
 */

/**
 * @param {string} name intella or adpta
 * @param {string[]} options
 * @param {Map<string, Uint8Array>} files in the folder where the program starts; what it writes is added
 * @param {Terminal} terminal
 * @param {(files: Map<string, Uint8Array>) => void} changed called when there may be new files
 * @returns {Promise<number>} the exit code
 */
export async function run(name, options, files, terminal, changed) {
  const watched = {
    write: terminal.write,
    read: (room, take) => {
      collect();
      terminal.read(room, take);
    },
  };
  const module = await factory({ wasmBinary: bytes, terminal: watched });
  const { FS } = module;
  const input = FS.getStream(0);
  const readable = 1;
  const writable = 4;
  input.stream_ops = { ...input.stream_ops, poll: () => (terminal.ready() ? readable : 0) | writable };
  FS.mkdir('/here');
  FS.chdir('/here');
  for (const [file, data] of files) FS.writeFile(file, data);

  function collect() {
    for (const file of FS.readdir('/here').filter((entry) => !entry.startsWith('.'))) {
      if (FS.isFile(FS.stat(file).mode)) files.set(file, FS.readFile(file));
    }
    changed(files);
  }

  const words = [name, ...options].map((word) => module.allocateUTF8(word));
  const argv = module._malloc(4 * (words.length + 1));
  module.HEAPU32.set([...words, 0], argv / 4);
  const code = await module.ccall('main', 'number', ['number', 'number'], [words.length, argv], { async: true });
  collect();
  return code;
}
