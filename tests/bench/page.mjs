/* page: times of the page in Chromium, as CSV.      node tests/bench/page.mjs build/page/stonepack.html chromium
 *
 * Walls of 64, 500 and 2,000 joints: from opening the page to the verdict on the wall that is dropped on it at once (median of
 * five), from a later drop to the verdict, one check, and frames a second while friction is dragged, each of which is a check and
 * a picture. Pictures are drawn by the processor here. */
import { execFileSync } from 'node:child_process';
import { resolve } from 'node:path';
import { Chromium } from '../checks/chromium.mjs';

const [page, program] = process.argv.slice(2), browser = new Chromium(program);
const median = x => x.sort((a, b) => a - b)[x.length >> 1], url = 'file://' + resolve(page);
const fileOf = wall => `new File([Uint8Array.from(atob('${wall.toString('base64')}'), c => c.charCodeAt(0))], 'wall.obj')`;
const dropOf = file => `(() => { const t = new DataTransfer(); t.items.add(${file});
  dispatchEvent(new DragEvent('drop', { dataTransfer: t, cancelable: true })); })()`;
/* [ms] from opening the page to the verdict on a wall dropped as soon as there is something to drop it on. */
async function atOnce(wall) {
  const first = `addEventListener('DOMContentLoaded', () => {
    const look = new MutationObserver(() => {
      if (document.getElementById('name').textContent === 'wall.obj') { window.told = performance.now(); look.disconnect(); } });
    look.observe(document.getElementById('verdict'), { childList: true });
    ${dropOf(fileOf(wall))}; })`;
  const tab = await browser.open(url, { first });
  await tab.until('window.told');
  const told = await tab.value('window.told');
  await tab.close();
  return told;
}
/* [joints, ms from a drop to the verdict, ms of a check, frames a second while friction is dragged] */
const dragged = (tab, wall) => tab.value(`(async () => {
  const p = window.stonepackPage, mu = document.getElementById('mu'), took = [];
  p.model.state.name = '';
  const start = performance.now();
  ${dropOf(fileOf(wall))};
  while (p.model.state.name !== 'wall.obj') await new Promise(f => setTimeout(f));
  const verdict = performance.now() - start;
  let frames = 0, k = 0;
  for (const began = performance.now(); performance.now() - began < 4000; frames++) {
    mu.value = 0.7 + 0.1 * Math.sin(++k / 10);
    mu.dispatchEvent(new Event('input'));
    await new Promise(f => requestAnimationFrame(f));
    took.push(p.model.took);
  }
  took.sort((a, b) => a - b);
  return [p.core.joints(), verdict, took[took.length >> 1], frames / 4]; })()`);

const opened = [];
let tab;
for (let k = 0; k < 3; k++) {
  if (tab) await tab.close();
  tab = await browser.open(url);
  await tab.until('document.body && document.body.dataset.ready');
  opened.push([await tab.value('document.body.dataset.answered'), await tab.value('document.body.dataset.ready')].map(Number));
}
console.log('joints,open_and_drop_to_verdict_ms,drop_to_verdict_ms,check_ms,frames_per_second,frames_per_second_of_a_phone');
for (const [rows, bricks] of [[4, 6], [8, 22], [22, 31]]) {
  const wall = execFileSync('build/stonepack', ['gen', 'wall', 'rows=' + rows, 'bricks=' + bricks], { maxBuffer: 1 << 26 });
  const begun = [];
  for (let k = 0; k < 5; k++) begun.push(await atOnce(wall));
  const [joints, drop, check, frames] = await dragged(tab, wall);
  const phone = await browser.open(url, { width: 390, height: 780, phone: true });
  await phone.until('document.body && document.body.dataset.ready');
  const [, , , small] = await dragged(phone, wall);
  await phone.close();
  console.log([joints, median(begun).toFixed(0), drop.toFixed(0), check.toFixed(2), frames.toFixed(1), small.toFixed(1)].join(','));
}
console.log(`# opened: ${median(opened.map(x => x[0]))} ms to the verdict, ${median(opened.map(x => x[1]))} ms to the picture`);
await browser.close();
