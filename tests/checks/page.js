/* page: does the script of a report draw, turn, move and sort?      node page.js REPORT.html [IMAGE.ppm]
 *
 * A browser is imitated as far as the script asks for one: elements by id, a canvas whose image is kept. The report is of a scene
 * that falls. */
'use strict';
const fs = require('fs'), html = fs.readFileSync(process.argv[2], 'utf8');
let failed = 0;
function check(good, what) { if (!good) { failed++; console.log('page: ' + what); } }
const between = (from, to) => { const i = html.indexOf(from) + from.length; return html.slice(i, html.indexOf(to, i)); };

/* Stands alone, well formed as far as it goes. */
check(!/\b(?:src|href)=|@import|url\(|https?:/.test(html), 'something is fetched');
for (const tag of ['html', 'body', 'table', 'tbody', 'dl', 'canvas', 'h1', 'ol'])
  check(html.split('<' + tag).length === html.split('</' + tag + '>').length, 'unbalanced ' + tag);
check(/prefers-color-scheme: dark/.test(html), 'no dark colours');

const listeners = {}, on = (name) => (what, f) => { (listeners[name] = listeners[name] || {})[what] = f; };
let image = null, strokes = 0, texts = [];
const pen = { createImageData: (width, height) => ({ width, height, data: new Uint8ClampedArray(4 * width * height) }),
  putImageData: im => { image = im; }, stroke: () => { strokes++; }, strokeText() {}, fillText: t => { texts.push(t); } };
for (const f of ['beginPath', 'moveTo', 'lineTo', 'closePath', 'arc', 'fill']) pen[f] = () => {};
const element = id => ({ addEventListener: on(id), focus() {} });
const elements = { scene: { textContent: between('id="scene">', '</script>') },
  view: Object.assign(element('view'), { width: 700, height: 420, getContext: () => pen, setPointerCapture() {} }) };
for (const id of ['motion', 'forces', 'labels', 'home'])
  elements[id] = Object.assign(element(id), { value: '0', checked: id === 'forces' });
const names = Array.from(between('<ol id="names" hidden>', '</ol>').matchAll(/<li>(.*?)<\/li>/g), m => ({ textContent: m[1] }));
const cells = Array.from(between('<tbody>', '</tbody>').matchAll(/<tr>(.*?)<\/tr>/g),
  m => ({ children: Array.from(m[1].matchAll(/<td>(.*?)<\/td>/g), c => ({ textContent: c[1].replace(/<.*?>/g, '') })) }));
const body = { rows: cells.slice(), addEventListener: on('body'),
  appendChild(r) { this.rows.splice(this.rows.indexOf(r), 1); this.rows.push(r); } };
const heads = Array.from({ length: 7 }, (_, k) => ({ addEventListener: on('head' + k),
  parentNode: { a: null, getAttribute() { return this.a; }, setAttribute(n, v) { this.a = v; }, removeAttribute() { this.a = null; } } }));
global.document = { getElementById: id => elements[id], querySelector: () => body,
  querySelectorAll: q => q === '#names li' ? names : q === '#joints th' ? heads.map(h => h.parentNode) : heads };
new Function(between('<script>\n', '</script>'))();

const painted = () => { let n = 0; for (let k = 3; k < image.data.length; k += 4) n += image.data[k] > 0; return n; };
const reds = () => { let n = 0; for (let k = 0; k < image.data.length; k += 4) n += image.data[k] > 1.35 * image.data[k + 1]; return n; };
const same = (a, b) => Buffer.compare(Buffer.from(a.data.buffer), Buffer.from(b.data.buffer)) === 0;
const key = k => { let kept = true; listeners.view.keydown({ key: k, preventDefault() { kept = false; } }); return !kept; };
if (process.argv[3]) {
  const rgb = [];
  for (let k = 0; k < image.data.length; k += 4) for (let c = 0; c < 3; c++) rgb.push(image.data[k + 3] ? image.data[k + c] : 250);
  fs.writeFileSync(process.argv[3], Buffer.concat([Buffer.from(`P6 ${image.width} ${image.height} 255\n`), Buffer.from(rgb)]));
}
const first = image, share = painted() / (700 * 420);
check(share > 0.05 && share < 0.9, 'it covers ' + share + ' of the canvas');
const given = JSON.parse(elements.scene.textContent).a.length;          /* of very many the longest of their places */
check(given > 2000 ? strokes > 50 && strokes < given / 2 : strokes > names.length / 2, strokes + ' strokes for ' + given + ' forces');
check(key('ArrowLeft') && !same(first, image), 'an arrow key turns nothing');
check(key('ArrowRight') && painted() === (image = first, painted()), 'and back');
key('+'); check(painted() > 1.1 * (() => { const i = image; image = first; const n = painted(); image = i; return n; })(), 'plus does not zoom');
key('0'); check(same(first, image), '0 does not go back');
check(!key('Tab'), 'Tab is kept from leaving the picture');
const before = reds();
elements.motion.value = '1'; listeners.motion.input();
check(!same(first, image) && reds() > before + 1000, 'nothing moves');
elements.motion.value = '0'; elements.forces.checked = false; strokes = 0; listeners.forces.input();
check(same(first, image) && strokes < 4, 'forces stay');
elements.labels.checked = true; listeners.labels.input();
check(texts.length > 1 && texts.every(t => names.some(n => n.textContent === t.replace(' (behind)', ''))), 'names: ' + texts);
listeners.head4.click();
const column = body.rows.map(r => +r.children[4].textContent);
check(column.length === cells.length && column.every((x, i) => !i || x <= column[i - 1]), 'sorted: ' + column);
listeners.head4.click();
check(body.rows[0].children[4].textContent === String(column.length ? cells.map(r => r.children[4].textContent)
  .sort((a, b) => a - b)[0] : ''), 'sorted the other way');
strokes = 0; listeners.body.click({ target: { tagName: 'BUTTON', textContent: '0' } });
check(strokes >= 2, 'a joint is not shown');
console.log(failed ? failed + ' failed' : 'page: draws, turns, moves, sorts');
process.exit(failed ? 1 : 0);
