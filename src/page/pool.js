/* armtol's command line, and --verify shared out among workers. */

import source from 'page/worker.bundle';
import { bytes } from './engine.js';

const STEP = 1 << 16;
const MOST_WORKERS = 8;

function start() {
  const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
  const worker = new Worker(url);
  URL.revokeObjectURL(url);
  return worker;
}

/** @typedef {{code: number, out: string, err: string}} Ended */

/** @param {string[]} words @param {[string, Uint8Array][]} files @returns {Promise<Ended>} */
export function runArmtol(words, files) {
  const worker = start();
  return new Promise((resolve, reject) => {
    worker.onmessage = ({ data }) => { worker.terminate(); resolve(data); };
    worker.onerror = reject;
    worker.postMessage({ act: 'run', bytes, files, words });
  });
}

/**
 * The same with --verify TOTAL: each worker draws every so many steps of arms; the counts are added up, so that the
 * answer is the one that a single worker gives.
 * @param {(done: number) => void} progress
 * @returns {{ended: Promise<Ended>, stop: () => void}}
 */
export function verifyArmtol(words, files, total, progress) {
  const parts = Math.max(1, Math.min(MOST_WORKERS, navigator.hardwareConcurrency || 1, Math.ceil(total / STEP)));
  const workers = Array.from({ length: parts }, start);
  const others = [];
  let done = 0;
  const ended = new Promise((resolve, reject) => {
    workers.forEach((worker, part) => {
      worker.onerror = reject;
      worker.onmessage = ({ data }) => {
        if (data.kind === 'drawn') {
          done += data.count;
          progress(done);
        } else if (data.kind === 'counted') {
          others[part] = data.counted;
          if (others.filter(Boolean).length === parts) workers[0].postMessage({ act: 'end', others: others.slice(1) });
        } else {
          resolve(data);
        }
      };
      worker.postMessage({ act: 'draw', bytes, files, words, part, parts, total, step: STEP });
    });
  }).finally(() => workers.forEach((worker) => worker.terminate()));
  return { ended, stop: () => workers.forEach((worker) => worker.postMessage({ act: 'stop' })) };
}
