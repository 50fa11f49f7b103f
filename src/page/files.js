/* The files that the programs wrote, as tabs. */

import { by, make, save } from './dom.js';

const decoder = new TextDecoder();

export class FileTabs {
  constructor() {
    this.list = by('file-tabs');
    this.panel = by('file-panel');
    this.files = new Map();
    this.open = '';
    this.list.addEventListener('keydown', (event) => this.key(event));
    by('file-save').addEventListener('click', () => save(this.open, this.files.get(this.open)));
    by('file-save-all').addEventListener('click', () => {
      for (const [name, data] of this.files) save(name, data);
    });
  }

  /** @param {Map<string, Uint8Array>} files */
  show(files) {
    this.files = new Map(files);
    const names = [...this.files.keys()].sort();
    if (!this.files.has(this.open)) this.open = names[0] ?? '';
    this.list.replaceChildren(...names.map((name) => this.tab(name)));
    by('files').hidden = names.length === 0;
    this.panel.textContent = this.open ? decoder.decode(this.files.get(this.open)) : '';
    this.panel.setAttribute('aria-label', this.open);
  }

  tab(name) {
    const chosen = name === this.open;
    return make('button', {
      type: 'button', role: 'tab', 'aria-selected': String(chosen), 'aria-controls': 'file-panel', 'data-name': name,
      tabindex: chosen ? '0' : '-1', onclick: () => this.choose(name),
    }, name);
  }

  choose(name) {
    this.open = name;
    this.show(this.files);
    this.list.querySelector('[aria-selected=true]').focus();
  }

  key(event) {
    const names = [...this.list.children].map((tab) => tab.dataset.name);
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    this.choose(names[(names.indexOf(this.open) + step + names.length) % names.length]);
  }
}
