/* armtol: any arm, built in or from a file, by its command line. */

import { by, make } from './dom.js';
import * as engine from './engine.js';
import { runArmtol, verifyArmtol } from './pool.js';

const MOST = 1e7;
const ACCURACY = '.5,.5,.5,.01,.01,.01';

/* In the middle of its limits, where a joint has any; slightly off, so that axes are not aligned by accident. */
function middleOf(joints) {
  return joints.map(({ low, high }, i) => (low === null || high === null ? 0.3 + 0.2 * i : low + 0.55 * (high - low)))
    .map((value) => Number(value.toPrecision(3)));
}

export function startAsk(drawFrames) {
  const files = new Map();
  const command = by('ask-command');
  const output = by('ask-output');
  const message = by('ask-message');
  const bar = by('ask-progress');
  let stop = null;

  const listed = () => [...files].map(([name, data]) => [name, data]);
  const words = () => command.value.trim().split(/\s+/).filter(Boolean);

  function tell({ code, out, err }) {
    output.textContent = out;
    message.textContent = err + (code === 0 ? '' : `exit status ${code}`);
  }

  function running(work) {
    by('ask-run').disabled = work;
    by('ask-stop').hidden = !work;
    bar.hidden = !work;
  }

  /* The arm that is asked about, at the joint values of the command. */
  function drawAsked() {
    const [arm, ...rest] = words();
    const at = rest.indexOf('--joints');
    const turn = rest.includes('--degrees') ? Math.PI / 180 : 1;
    const joints = engine.frames(arm).joints ?? [];
    const unitOf = (i) => (joints[i]?.kind === 'revolute' ? turn : 1);
    const q = at < 0 ? null : rest[at + 1]?.split(',').map((text, i) => Number(text) * unitOf(i));
    drawFrames(engine.frames(arm, q));
  }

  async function ask() {
    const asked = words();
    const at = asked.indexOf('--verify');
    const total = at < 0 ? 0 : Number(asked[at + 1]);
    output.textContent = '';
    message.textContent = '';
    drawAsked();
    running(true);
    bar.removeAttribute('value');
    const shared = Number.isInteger(total) && total > 0 && total <= MOST && !asked.includes('--budget');
    if (total > MOST) {
      tell({ code: 2, out: '', err: `This page draws at most ${MOST} arms; the program armtol draws more.\n` });
    } else if (shared) {
      const job = verifyArmtol(asked, listed(), total, (done) => {
        bar.value = done / total;
        bar.textContent = `${done} of ${total}`;
      });
      stop = job.stop;
      tell(await job.ended);
    } else {
      tell(await runArmtol(asked, listed()));
    }
    stop = null;
    running(false);
  }

  function example(arm) {
    const { joints = [] } = engine.frames(arm);
    command.value = `${arm} --joints ${middleOf(joints).join(',')} --accuracy ${ACCURACY} --verify 100000`;
  }

  async function take(file) {
    const name = file.name.replace(/\s+/g, '_');
    files.set(name, new Uint8Array(await file.arrayBuffer()));
    engine.keep(name, files.get(name));
    const shown = await runArmtol([name, '--show'], listed());
    tell(shown);
    if (shown.code !== 0) return;
    example(name);
    drawAsked();
  }

  by('ask-arm').append(...engine.arms().map(({ name, title }) => make('option', { value: name }, `${name}: ${title}`)));
  by('ask-arm').addEventListener('change', () => { example(by('ask-arm').value); drawAsked(); });
  by('ask-form').addEventListener('submit', (event) => { event.preventDefault(); void ask(); });
  by('ask-stop').addEventListener('click', () => stop?.());
  by('ask-file').addEventListener('change', () => { if (by('ask-file').files[0]) void take(by('ask-file').files[0]); });
  const zone = by('ask-drop');
  zone.addEventListener('dragover', (event) => { event.preventDefault(); zone.classList.add('over'); });
  zone.addEventListener('dragleave', () => zone.classList.remove('over'));
  zone.addEventListener('drop', (event) => {
    event.preventDefault();
    zone.classList.remove('over');
    if (event.dataTransfer.files[0]) void take(event.dataTransfer.files[0]);
  });
  by('ask-arm').value = 'puma560';
  example('puma560');
}
