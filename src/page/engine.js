/* The C code that answers at once: what the page shows is computed there. */

import factory from 'wasm/engine.cjs';
import bytes from 'wasm/engine.wasm';
import published from 'golden/published.tsv';

/** @typedef {{quantity: string, published: string, computed: string, verdict: string}} Result */
/** @typedef {{program: string, number: number, distance: number, angle: number, results: Result[]}} Case */

export { bytes, published };

let module;

/** Before anything else here. */
export async function openEngine() {
  module = await factory({ wasmBinary: bytes });
  module.FS.writeFile('/published.tsv', published);
  if (!call('page_open', 'number', '/published.tsv')) throw new Error('the published numbers cannot be read');
}

function typeOf(argument) {
  return typeof argument === 'string' ? 'string' : typeof argument === 'number' ? 'number' : 'array';
}

/* Numbers in a list go as doubles. */
function asBytes(argument) {
  return Array.isArray(argument) ? new Uint8Array(Float64Array.from(argument).buffer) : argument;
}

function call(name, result, ...given) {
  return module.ccall(name, result, given.map(typeOf), given.map(asBytes));
}

function told(name, ...given) {
  return JSON.parse(call(name, 'string', ...given));
}

/** @returns {{id: string, slip: string, touches: string}[]} */
export const errata = () => told('page_errata').errata;

/** @param {string[]} corrected names of errata @returns {Case[]} */
export const bench = (corrected) => told('page_bench', corrected.join(' ')).cases;

/** @param {number[]} words three, 32 bits each @returns {Case[]} */
export const stack = (words) => told('page_stack', ...words).cases;

/** What a float sees that stands on the word, nan and infinity too; and the word of a float. */
export const floatOf = (word) => new Float32Array(Uint32Array.of(word).buffer)[0];
export const wordOf = (value) => new Uint32Array(Float32Array.of(value).buffer)[0];

const bitsOf = (value) => new BigUint64Array(Float64Array.of(value).buffer)[0];
export const upperHalf = (value) => Number(bitsOf(value) >> 32n);
export const lowerHalf = (value) => Number(bitsOf(value) & 0xffffffffn);
export const toolAlpha = () => call('page_tool_alpha', 'number');
export const toolResidue = () => [0, 1, 2].map((place) => call('page_tool_residue', 'number', place));

export const arms = () => told('page_arms').arms;
export const frames = (arm, q) => (q ? told('page_frames', arm, q, q.length) : told('page_frames', arm, 0, 0));
export const reach = (program, wish) => told('page_reach', program, wish);
export const cloud = (program, wish, given, count, seed) => told('page_cloud', program, wish, given, count, seed);

/** A file that frames() can be asked for. */
export const keep = (name, data) => module.FS.writeFile(name, data);

/** How many of the published numbers come out. */
export function agreeing(cases) {
  return cases.flatMap((one) => one.results).filter((result) => result.verdict.startsWith('agrees')).length;
}

export const countOf = (cases) => cases.reduce((sum, one) => sum + one.results.length, 0);
