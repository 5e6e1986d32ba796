/* page_steps: does the page of a build order show its steps?      node page_steps.js SEQUENCE.html
 *
 * A browser is imitated as in page.js. The order is of an arch that falls at some step. */
'use strict';
const fs = require('fs'), html = fs.readFileSync(process.argv[2], 'utf8');
let failed = 0;
function check(good, what) { if (!good) { failed++; console.log('page_steps: ' + what); } }
const between = (from, to) => { const i = html.indexOf(from) + from.length; return html.slice(i, html.indexOf(to, i)); };
check(!/\b(?:src|href)=|@import|https?:(?!\/\/www\.w3\.org\/2000\/svg)/.test(html), 'something is fetched');
for (const tag of ['html', 'body', 'table', 'tbody', 'dl', 'canvas', 'h1', 'ol', 'svg'])
  check(html.split('<' + tag).length === html.split('</' + tag + '>').length, 'unbalanced ' + tag);

const listeners = {}, on = name => (what, f) => { (listeners[name] = listeners[name] || {})[what] = f; };
let image = null, texts = [];
const pen = { createImageData: (width, height) => ({ width, height, data: new Uint8ClampedArray(4 * width * height) }),
  putImageData: im => { image = im; texts = []; }, strokeText() {}, fillText: t => { texts.push(t); } };
for (const f of ['beginPath', 'moveTo', 'lineTo', 'closePath', 'arc', 'fill', 'stroke']) pen[f] = () => {};
const element = id => ({ addEventListener: on(id), value: '0', checked: false });
const elements = { scene: { textContent: between('id="scene">', '</script>') },
  view: Object.assign(element('view'), { width: 700, height: 420, getContext: () => pen, setPointerCapture() {}, scrollIntoView() {} }) };
for (const id of ['motion', 'labels', 'home', 'step', 'said']) if (html.includes('id="' + id + '"')) elements[id] = element(id);
const names = Array.from(between('<ol id="names" hidden>', '</ol>').matchAll(/<li>(.*?)<\/li>/g), m => ({ textContent: m[1] }));
const body = { rows: [], addEventListener: on('body') };
global.document = { getElementById: id => elements[id], querySelector: q => q === '#steps tbody' ? body : null,
  querySelectorAll: q => q === '#names li' ? names : [] };
new Function(html.slice(html.lastIndexOf('<script>\n') + 9, html.lastIndexOf('</script>')))();

const painted = () => { let n = 0; for (let k = 3; k < image.data.length; k += 4) n += image.data[k] > 0; return n; };
/* Pixels whose colours stand to each other as those of a mark, whatever the light. */
const of = (r, g, b) => {
  let n = 0;
  for (let k = 0; k < image.data.length; k += 4) {
    const [x, y, z] = image.data.subarray(k, k + 3);
    n += image.data[k + 3] > 0 && Math.abs(y / x - g / r) < 0.04 && Math.abs(z / x - b / r) < 0.04;
  }
  return n;
};
const count = JSON.parse(elements.scene.textContent).s.length;
const go = k => { elements.step.value = String(k); listeners.step.input(); };
const first = JSON.parse(elements.scene.textContent).s.findIndex(s => s[1] === 1) + 1;
check(first > 1 && elements.said.textContent.startsWith(first + ': ') && / it falls; hold /.test(elements.said.textContent),
  'it begins with ' + elements.said.textContent);
check(of(250, 190, 90) > 100, 'who must be held has no colour');
check(texts.length >= 1 && texts.every(t => names.some(n => t.startsWith(n.textContent))), 'names: ' + texts);
go(1);
const few = painted();
check(/ comes, it stands$/.test(elements.said.textContent) && of(165, 200, 235) > 100, 'the new block: ' + elements.said.textContent);
go(count);
check(painted() > 1.5 * few, 'no more blocks at the end');
listeners.body.click({ target: { tagName: 'BUTTON', textContent: String(first + 2) } });
check(elements.said.textContent.startsWith(first + 2 + ': '), 'a row of the table shows ' + elements.said.textContent);
check(of(226, 140, 128) > 100, 'what moves has no colour');
const still = Buffer.from(image.data);
elements.motion.value = '1'; listeners.motion.input();
check(Buffer.compare(still, Buffer.from(image.data)) !== 0, 'nothing moves');
elements.motion.value = '0'; listeners.motion.input();
check(Buffer.compare(still, Buffer.from(image.data)) === 0, 'and back');
console.log(failed ? failed + ' failed' : 'page_steps: steps, marks, motion');
process.exit(failed ? 1 : 0);
