/* page: times of the page in Chromium, as CSV.      node tests/bench/page.mjs build/page/stonepack.html chromium
 *
 * Walls of 64, 500 and 2,000 joints: from the drop to the verdict, one check, and frames a second while friction is dragged,
 * each of which is a check and a picture. Pictures are drawn by the processor here. */
import { execFileSync } from 'node:child_process';
import { resolve } from 'node:path';
import { Chromium } from '../checks/chromium.mjs';

const [page, program] = process.argv.slice(2), browser = new Chromium(program);
const median = x => x.sort((a, b) => a - b)[x.length >> 1];
const opened = [];
let tab;
for (let k = 0; k < 3; k++) {
  if (tab) await tab.close();
  tab = await browser.open('file://' + resolve(page));
  await tab.until('document.body && document.body.dataset.ready');
  opened.push([await tab.value('document.body.dataset.answered'), await tab.value('document.body.dataset.ready')].map(Number));
}
console.log('joints,drop_to_verdict_ms,check_ms,frames_per_second,checks_per_second');
for (const [rows, bricks] of [[4, 6], [12, 14], [23, 30]]) {
  const wall = execFileSync('build/stonepack', ['gen', 'wall', 'rows=' + rows, 'bricks=' + bricks], { maxBuffer: 1 << 26 });
  await tab.value(`window.wall = new File([Uint8Array.from(atob('${wall.toString('base64')}'), c => c.charCodeAt(0))],
    'wall.obj')`);
  const row = await tab.value(`(async () => {
    const p = window.stonepackPage, t = new DataTransfer(), mu = document.getElementById('mu'), took = [];
    p.model.state.name = '';
    t.items.add(window.wall);
    const start = performance.now();
    dispatchEvent(new DragEvent('drop', { dataTransfer: t, cancelable: true }));
    while (p.model.state.name !== 'wall.obj') await new Promise(f => setTimeout(f));
    const verdict = performance.now() - start;
    let frames = 0, checks = 0, k = 0;
    const check = p.model.check.bind(p.model), began = performance.now();
    p.model.check = () => { checks++; const v = check(); took.push(p.model.took); return v; };
    while (performance.now() - began < 4000) {
      mu.value = 0.7 + 0.1 * Math.sin(++k / 10);
      mu.dispatchEvent(new Event('input'));
      await new Promise(f => requestAnimationFrame(f));
      frames++;
    }
    const s = (performance.now() - began) / 1000;
    delete p.model.check;
    took.sort((a, b) => a - b);
    return [p.core.joints(), verdict.toFixed(0), took[took.length >> 1].toFixed(2), (frames / s).toFixed(1),
      (checks / s).toFixed(1)].join(',');
  })()`);
  console.log(row);
}
console.log(`# opened: ${median(opened.map(x => x[0]))} ms to the verdict, ${median(opened.map(x => x[1]))} ms to the picture`);
await browser.close();
