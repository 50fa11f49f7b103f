/* What a terminal's driver does between the keyboard and a program: lines are edited, echoed, and handed over whole. */

const encoder = new TextEncoder();

export class Lines {
  /** @param {(text: string) => void} show @param {() => void} interrupted */
  constructor(show, interrupted) {
    this.show = show;
    this.interrupted = interrupted;
    this.forget();
  }

  /** What was typed and not read, and who waits for it. */
  forget() {
    this.line = '';
    this.queue = [];
    this.reader = null;
    this.script = [];
  }

  /** Lines that are typed one by one, each when somebody waits for it. */
  later(lines) {
    this.script = [...lines];
    this.prompt();
  }

  prompt() {
    if (this.reader && this.script.length > 0 && !this.ready) this.type(`${this.script.shift()}\n`);
  }

  /** Keys, or what is pasted. */
  type(text) {
    for (const key of text.replace(/\r\n?/g, '\n')) this.press(key);
  }

  press(key) {
    if (key === '\n') {
      this.show('\r\n');
      this.commit(this.line + '\n');
    } else if (key === '\x7f' || key === '\b') {
      if (this.line !== '') this.erase(1);
    } else if (key === '\x15') {
      this.erase([...this.line].length);
    } else if (key === '\x04') {
      this.commit(this.line);
    } else if (key === '\x03') {
      this.show('^C\r\n');
      this.forget();
      this.interrupted();
    } else {
      this.line += key;
      this.show(key < ' ' ? '^' + String.fromCharCode(key.charCodeAt(0) + 64) : key);
    }
  }

  erase(count) {
    const kept = [...this.line];
    const gone = kept.splice(kept.length - count, count);
    this.line = kept.join('');
    const width = gone.reduce((sum, key) => sum + (key < ' ' ? 2 : 1), 0);
    this.show('\b \b'.repeat(width));
  }

  commit(line) {
    this.line = '';
    this.queue.push(encoder.encode(line));
    this.serve();
  }

  /** One line, or what fits; takes no bytes for the end of input (Control-D). */
  read(room, take) {
    this.reader = { room, take };
    this.serve();
    this.prompt();
  }

  get ready() {
    return this.queue.length > 0;
  }

  serve() {
    if (!this.reader || this.queue.length === 0) return;
    const { room, take } = this.reader;
    const line = this.queue.shift();
    if (line.length > room) this.queue.unshift(line.subarray(room));
    this.reader = null;
    take(line.subarray(0, room));
  }
}
