/* The terminal: a small shell, and the two programs of 1987 in it. */

import { Terminal } from '@xterm/xterm';
import { by, make } from './dom.js';
import { FileTabs } from './files.js';
import { Lines } from './lines.js';
import { run } from './programs.js';
import { cases, typedFor } from './published.js';

const decoder = new TextDecoder();
const greeting = 'Type intella or adpta, and answer what it asks. Type help for more.\r\n';
const help = [
  'intella [OPTION]...   the Intelledex 605T: six numbers for the position, six tolerances, delta',
  'adpta [OPTION]...     the Adept AdeptOne: four numbers, six tolerances, delta',
  '                      --fix all corrects the errata, --list-errata names them, --help tells the rest',
  'ls                    the files that they wrote',
  'cat FILE              what is in one',
  'rm FILE               removes it',
  'clear                 an empty screen',
  'Control-C             stops a program',
].join('\r\n');

class Shell {
  constructor(terminal) {
    this.terminal = terminal;
    this.files = new Map();
    this.tabs = new FileTabs();
    this.lines = new Lines((text) => terminal.write(text), () => this.interrupt());
    this.generation = 0;
    this.running = false;
    terminal.onData((text) => this.lines.type(text));
  }

  /** Prompts, and runs what is typed, for as long as nobody interrupts. */
  async loop() {
    const mine = ++this.generation;
    while (mine === this.generation) {
      this.terminal.write('$ ');
      const line = await new Promise((resolve) => this.lines.read(4096, resolve));
      if (mine !== this.generation) return;
      const [command, ...rest] = decoder.decode(line).trim().split(/\s+/);
      await this.execute(command, rest, mine);
    }
  }

  /* A program that is interrupted waits for a line that never comes; nothing refers to it any more. */
  interrupt() {
    this.busy(false);
    void this.loop();
  }

  async execute(command, words, mine) {
    if (command === 'intella' || command === 'adpta') {
      await this.program(command, words, mine);
    } else if (command === 'help') {
      this.terminal.write(help + '\r\n');
    } else if (command === 'ls') {
      this.terminal.write([...this.files.keys()].sort().map((name) => name + '\r\n').join(''));
    } else if (command === 'clear') {
      this.terminal.clear();
    } else if (command === 'cat' || command === 'rm') {
      for (const name of words) this.with(command, name);
    } else if (command !== '') {
      this.terminal.write(`${command}: not found; type help\r\n`);
    }
  }

  with(command, name) {
    const data = this.files.get(name);
    if (!data) {
      this.terminal.write(`${command}: ${name}: no such file\r\n`);
    } else if (command === 'cat') {
      this.terminal.write(decoder.decode(data).replace(/\n/g, '\r\n'));
    } else {
      this.files.delete(name);
      this.tabs.show(this.files);
    }
  }

  async program(name, options, mine) {
    const live = () => mine === this.generation;
    this.busy(true);
    const code = await run(name, options, this.files, {
      read: (room, take) => live() && this.lines.read(room, take),
      write: (bytes) => live() && this.terminal.write(decoder.decode(bytes).replace(/\n/g, '\r\n')),
      ready: () => this.lines.ready,
    }, (files) => live() && this.tabs.show(files));
    if (!live()) return;
    this.busy(false);
    by('terminal-status').textContent = code === 0 ? `${name} is done.` : `${name} ended with exit status ${code}.`;
  }

  busy(running) {
    this.running = running;
    by('terminal-status').textContent = running ? 'The program waits for your answers.' : '';
  }

  /** A case of the paper, typed. What runs is interrupted first. */
  type(program, number) {
    if (this.running || this.lines.line !== '') this.lines.press('\x03');
    this.lines.later([program, ...typedFor(program, number)]);
  }
}

function themeOf(element) {
  const style = getComputedStyle(element);
  const background = style.getPropertyValue('--paper').trim();
  const foreground = style.getPropertyValue('--ink').trim();
  return { background, foreground, cursor: foreground, cursorAccent: background };
}

/** Fits the columns to the place there is; the programs' lines need no more than 80. */
function fit(terminal, place) {
  const screen = place.querySelector('.xterm-screen');
  if (!screen || !place.clientWidth) return;
  const cell = screen.clientWidth / terminal.cols;
  const columns = Math.max(20, Math.min(100, Math.floor((place.clientWidth - 20) / cell)));
  if (columns !== terminal.cols && Number.isFinite(columns)) terminal.resize(columns, terminal.rows);
}

export function startTerminal() {
  const place = by('screen');
  const terminal = new Terminal({
    rows: 24, cols: 80, fontSize: 14, screenReaderMode: true, cursorBlink: false, scrollback: 2000,
    fontFamily: 'ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace', theme: themeOf(place),
  });
  terminal.open(place);
  // Tab leaves the terminal, as it leaves every field: nobody is to be caught in it.
  terminal.attachCustomKeyEventHandler((event) => event.key !== 'Tab');
  terminal.textarea.setAttribute('aria-label', 'Terminal: type the answers here');
  const refit = () => fit(terminal, place);
  new ResizeObserver(refit).observe(place);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    terminal.options.theme = themeOf(place);
  });
  terminal.write(greeting);
  const shell = new Shell(terminal);
  void shell.loop();
  by('paper-cases').append(...cases().map(({ program, number }) => make('button', {
    type: 'button', onclick: () => { shell.type(program, number); terminal.focus(); },
  }, `${program}, case ${number}`)));
  return terminal;
}
