/* page_browser: the page in a browser.       node page_browser.mjs PAGE.html CHROMIUM [FOLDER for screens]
 *
 * Loads, decides, drags, draws; keys, drop, link, exports; no error on the console, nothing fetched. Times are told and judge
 * nothing. Ends with `N passed, N failed`. */
import { randomBytes } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { Chromium } from './chromium.mjs';
import { fromLink, toLink } from '../../port/page/link.js';

const [page, program, screens] = process.argv.slice(2), url = 'file://' + resolve(page), browser = new Chromium(program);
let passed = 0, failed = 0;
function test(name, good, more = '') {
  if (good) passed++; else { failed++; console.log('FAILED  ' + name + ' ' + more); }
}
async function shot(tab, name) {
  if (!screens) return;
  mkdirSync(screens, { recursive: true });
  writeFileSync(join(screens, name + '.png'), await tab.screen());
}
const P = 'window.stonepackPage', ready = tab => tab.until('document.body && document.body.dataset.ready');
const verdict = tab => tab.value('document.body.dataset.verdict');
/* Share of the picture that is not empty, and a number that differs where pictures differ. */
const drawn = tab => tab.value(`(() => { const v = ${P}.view, c = document.createElement('canvas'), from = v.canvas;
  v.renderer.render(v.scene, v.camera); c.width = 200; c.height = 150; const pen = c.getContext('2d');
  pen.drawImage(from, 0, 0, 200, 150); const d = pen.getImageData(0, 0, 200, 150).data; let n = 0, h = 0;
  for (let k = 0; k < d.length; k += 4) { if (d[k + 3] > 200) n++; h = (h * 31 + d[k] + 7 * d[k + 3]) % 1000000007; }
  return { share: n / 30000, hash: h }; })()`);
/* Where a stone is on the screen: its middle if that is what is hit there, else a place where it is. */
const place = (tab, b) => tab.value(`(() => { const v = ${P}.view, box = v.canvas.getBoundingClientRect();
  for (let i = 1; i < 60; i++) for (let j = 1; j < 60; j++) {
    const x = box.left + box.width * i / 60, y = box.top + box.height * j / 60, h = v.pick(x, y);
    if (h && h.block === ${b}) return [x, y]; } return null; })()`);
const set = (tab, id, x) => tab.value(`(() => { const e = document.getElementById('${id}');
  e.value = ${JSON.stringify(String(x))};
  e.dispatchEvent(new Event('input', { bubbles: true })); e.dispatchEvent(new Event('change', { bubbles: true })); })()`);
const press = (tab, id) => tab.value(`document.getElementById('${id}').click()`);
const example = (tab, k) => tab.value(`(() => { const e = document.getElementById('example'); e.selectedIndex = ${k} + 1;
  e.dispatchEvent(new Event('change')); })()`);
const drop = (tab, name, file) => tab.value(`(() => { const t = new DataTransfer();
  t.items.add(new File([Uint8Array.from(atob('${Buffer.from(file).toString('base64')}'), c => c.charCodeAt(0))], '${name}'));
  window.dropped = performance.now();
  dispatchEvent(new DragEvent('drop', { dataTransfer: t, bubbles: true, cancelable: true })); })()`);

/* Wait until the page has not been scrolled for ten pictures. */
const rests = tab => tab.value(`new Promise(done => { let y = scrollY, n = 0;
  const f = () => { n = scrollY === y ? n + 1 : 0; y = scrollY; n < 10 ? requestAnimationFrame(f) : done(1); }; f(); })`);

async function begins() {
  const tab = await browser.open(url);
  test('it loads', await ready(tab));
  test('WebGL draws here', await tab.value(`!!${P}.view`));
  test('an arch stands', await verdict(tab) === 'stable');
  await tab.frames();
  const first = await drawn(tab);
  test('it is drawn', first.share > 0.03 && first.share < 0.9, JSON.stringify(first));
  console.log('from opening to the first verdict: ' + await tab.value('document.body.dataset.answered')
    + ' ms, to the picture: ' + await tab.value('document.body.dataset.ready') + ' ms');
  await shot(tab, 'desktop-light');
  return tab;
}
async function decides(tab) {
  const texts = JSON.parse(await tab.value(`JSON.stringify(${P}.examples.map(e => e.title))`)), found = [];
  for (let k = 0; k < texts.length; k++) {
    await example(tab, k);
    await tab.frames();
    found.push(await verdict(tab));
    test(texts[k] + ' is drawn', (await drawn(tab)).share > 0.02);
    if (k) await shot(tab, 'example-' + k);
  }
  test('nine of ten examples stand', found.every((v, k) => v === (k === 1 ? 'unstable' : 'stable')), found.join(' '));
  await example(tab, 1);
  await tab.frames();
  const one = await drawn(tab);
  await new Promise(f => setTimeout(f, 700));
  test('what falls is seen to move', one.hash !== (await drawn(tab)).hash);
  await press(tab, 'motion');
  await tab.frames(3);
  const rest = (await drawn(tab)).hash;
  await tab.frames(6);
  test('and rests when that is not asked', rest === (await drawn(tab)).hash);
  await press(tab, 'motion');
}
async function changes(tab) {
  await example(tab, 0);
  await set(tab, 'mu', 0.1);
  await tab.frames();
  test('without friction it falls', await verdict(tab) === 'unstable');
  test('a screen reader is told', await tab.until(`document.getElementById('say').textContent.includes('It falls')`));
  await press(tab, 'mu-own');
  await tab.frames();
  test('with its own it stands', await verdict(tab) === 'stable');
  await set(tab, 'tilt', 40);
  await tab.frames();
  test('tilted it falls', await verdict(tab) === 'unstable');
  await press(tab, 'level');
  await tab.frames();
  await set(tab, 'stone', 'b8');
  await set(tab, 'push', 2);
  await tab.frames();
  test('pushed it falls', await verdict(tab) === 'unstable');
  await press(tab, 'ask-margin');
  test('how much it bears is told', /bears 0\.\d+ times/.test(await tab.value(`document.getElementById('margin').textContent`)),
    await tab.value(`document.getElementById('margin').textContent`));
  await shot(tab, 'pushed');
  await press(tab, 'no-push');
  await press(tab, 'take');
  await tab.frames();
  test('with a stone less it falls', await verdict(tab) === 'unstable');
  await press(tab, 'restore');
  await tab.frames();
  test('as it was it stands', await verdict(tab) === 'stable');
}
async function drags(tab) {
  await example(tab, 5);
  await tab.frames();
  const before = await drawn(tab), last = await tab.value(`${P}.model.shape.blocks - 1`);
  let at = await place(tab, last);
  await tab.drag(at, [at[0] + 120, at[1] + 30]);
  test('a drag turns the view', before.hash !== (await drawn(tab)).hash);
  await tab.value(`document.querySelector('[value=move]').click(), ${P}.view.home()`);
  await tab.frames();
  at = await place(tab, last);
  await tab.drag(at, [at[0] + 12, at[1]]);
  const by = await tab.value(`${P}.model.state.change[${last}].by`);
  test('a drag moves a stone, level', Math.hypot(by[0], by[1]) > 0 && Math.abs(by[2]) < 1e-9, String(by));
  at = await place(tab, last);
  await tab.drag(at, [at[0] + 400, at[1]]);
  test('pulled off it falls', await verdict(tab) === 'unstable');
  await shot(tab, 'moved');
  await press(tab, 'restore');
  await tab.value(`document.querySelector('[value=push]').click()`);
  await tab.frames();
  at = await place(tab, last);
  await tab.drag(at, [at[0] + 90, at[1] + 10]);
  test('a drag pushes', await tab.value(`${P}.model.state.push.share`) > 0.05);
  test('and the arrow is drawn', await tab.value(`${P}.view.forces.arrow.visible`));
  const along = await tab.value(`${P}.model.state.push.along`);
  const degrees = +await tab.value(`document.getElementById('push-azimuth').value`);
  const across = Math.atan2(along[1], along[0]) * 180 / Math.PI;
  test('and its slider points there', Math.abs(((degrees - across) % 360 + 540) % 360 - 180) <= 0.51, degrees + ' ' + across);
  await tab.value(`document.querySelector('[value=turn]').click()`);
}
async function keys(tab) {
  await example(tab, 0);
  await tab.frames();
  await tab.value(`document.getElementById('view').focus()`);
  const before = (await drawn(tab)).hash;
  await tab.key('ArrowLeft');
  test('an arrow key turns the view', before !== (await drawn(tab)).hash);
  await tab.key('0', 'Digit0');
  test('0 goes back', before === (await drawn(tab)).hash);
  for (let k = 0; k < 5; k++) await tab.key('n', 'KeyN');
  test('n chooses stones', await tab.value(`document.getElementById('stone').selectedIndex`) === 5);
  test('and says which', await tab.until(`/^b4, /.test(document.getElementById('say').textContent)`));
  await tab.key('Delete');
  test('Delete takes it out', await verdict(tab) === 'unstable');
  await press(tab, 'restore');
  await tab.frames();
  await tab.key('Tab');
  test('Tab leaves the picture', await tab.value(`document.activeElement.id !== 'view'`));
  const bare = await tab.value(`Array.from(document.querySelectorAll('input, select, button'))
    .filter(e => !(e.labels && e.labels.length) && !e.getAttribute('aria-label') && !e.textContent.trim())
    .map(e => e.id).join(' ')`);
  test('every control has a name', bare === '', bare);
}
async function files(tab) {
  await drop(tab, 'wall.obj', readFileSync('tests/scenes/wall.obj'));
  test('a model is dropped and answered', await tab.until(`document.getElementById('name').textContent === 'wall.obj'`)
    && await verdict(tab) === 'stable');
  console.log('from a drop to its verdict: ' + Math.round(await tab.value('performance.now() - window.dropped')) + ' ms');
  await drop(tab, 'bad.obj', 'o a\nv 1 2\n');
  test('a bad one is told with its line', await tab.until(`/bad\\.obj:2:/.test(document.getElementById('error').textContent)`));
  test('and the model before is still there', await tab.value(`${P}.model.state.name`) === 'wall.obj'
    && await verdict(tab) === 'stable');
  await drop(tab, 'mesh.stl', 'solid a\n');
  test('of another form is told what helps', await tab.until(`/mesh\\.stl.*reads OBJ.*convert/.test(
    document.getElementById('error').textContent)`));
  await tab.value(`(() => { const t = new DataTransfer(), f = new File(['x'], 'folder');
    f.arrayBuffer = () => Promise.reject(new DOMException('', 'NotFoundError'));
    const e = new DragEvent('drop', { cancelable: true }); Object.defineProperty(e, 'dataTransfer', { value: { files: [f] } });
    dispatchEvent(e); })()`);
  test('a folder is told', await tab.until(`/folder: can’t be read/.test(document.getElementById('error').textContent)`));
  await drop(tab, 'rhino.obj', readFileSync('tests/examples/arch.obj'));
  await tab.until(`document.getElementById('name').textContent === 'rhino.obj'`);
  const help = () => tab.value(`Array.from(document.querySelectorAll('#remarks button'), b => b.textContent).join(' ')`);
  test('a remark offers its option', (await help()).includes('--up y'), await help());
  await set(tab, 'options', '--unit mm --up y --fixed Springer*');
  await tab.value(`document.getElementById('apply').requestSubmit()`);
  test('with options it stands', await verdict(tab) === 'stable', await verdict(tab));
  const told = what => tab.value(`${P}.core.${what}()`), json = await told('json'), obj = await told('scene');
  const svg = await told('picture');
  test('JSON, scene and picture are whole', JSON.parse(json).verdict === 'stable'
    && /^o Voussoir_01$/m.test(obj) && /<\/svg>\s*$/.test(svg));
  await drop(tab, 'again.obj', obj);
  await tab.until(`document.getElementById('name').textContent === 'again.obj'`);
  test('the scene reads back', await verdict(tab) === 'stable' && JSON.parse(await told('json')).interfaces === 12);
}
/* A model that is dropped while the page is still being made ready. */
async function early() {
  const wall = readFileSync('tests/scenes/wall.obj').toString('base64');
  const tab = await browser.open(url, { first: `addEventListener('DOMContentLoaded', () => { const t = new DataTransfer();
    t.items.add(new File([Uint8Array.from(atob('${wall}'), c => c.charCodeAt(0))], 'early.obj'));
    dispatchEvent(new DragEvent('drop', { dataTransfer: t, cancelable: true })); })` });
  test('dropped before the page is ready', await ready(tab) && await tab.value(`${P}.model.state.name`) === 'early.obj'
    && await verdict(tab) === 'stable');
  test('no error on its console', tab.errors.length === 0, tab.errors.join('; '));
  await tab.close();
}
async function link(tab) {
  await example(tab, 5);
  await set(tab, 'mu', 0.21);
  await set(tab, 'tilt', 7);
  await tab.frames();
  await tab.value(`${P}.share()`);
  const other = await browser.open(await tab.value('location.href'));
  await ready(other);
  test('a link holds the scene', await other.value(`${P}.model.state.name`) === 'tests/scenes/wall.obj'
    && await other.value(`${P}.core.json()`) === await tab.value(`${P}.core.json()`));
  test('no error on its console', other.errors.length === 0, other.errors.join('; '));
  await other.close();
  const noise = randomBytes(2500000).toString('base64').replace(/.{1000}/g, '$&\n# ');
  await drop(tab, 'large.obj', readFileSync('tests/scenes/wall.obj', 'latin1') + '\n# ' + noise + '\n');
  await tab.until(`document.getElementById('name').textContent === 'large.obj'`);
  const before = await tab.value('location.href.length');
  await tab.value(`${P}.share()`);
  const told = await tab.value(`document.getElementById('error').textContent`);
  test('what is too large for a link is told', /Too large for a link/.test(told) && await tab.value('location.href.length') === before);
}
/* A link may come from anyone: what the page did not make is told, and an example is there. */
async function forged() {
  const wall = { name: 'x.obj', words: [], text: readFileSync('tests/scenes/wall.obj'), mu: null, tilt: 0, azimuth: 0, push: null,
    change: {} };
  const bad = { 'no words': { words: 5 }, 'mu in letters': { mu: '<img src=x onerror=window.hit=1>' }, 'no name': { name: 7 },
    'a move of no numbers': { change: { 0: { by: null, out: false, fixed: 0 } } }, 'a push of nothing': { push: { block: 'x' } },
    'no change': { change: null }, 'a push without end': { push: { block: 1, along: [1, 0, 0], share: 1e300, from: null } } };
  const links = [['letters', 'AAAA_AAAA-AAAA'], ['half a link', (await toLink(wall)).slice(0, 300)]];
  for (const [name, change] of Object.entries(bad)) links.push([name, await toLink({ ...wall, ...change })]);
  test('a link of the page is one', (await fromLink(await toLink(wall)))?.name === wall.name);
  for (const [name, hash] of links) test('no link: ' + name, await fromLink(hash) === null);
  for (const [name, hash] of [links[0], links[3]]) {
    const tab = await browser.open(url + '#' + hash);
    const error = `document.getElementById('error')`;
    const said = await ready(tab) && await tab.value(`${error}.hidden ? '' : ${error}.textContent`);
    test('a forged link: ' + name, /example/.test(said) && await verdict(tab) === 'stable' && tab.errors.length === 0,
      said + ' ' + tab.errors.join('; '));
    await tab.close();
  }
}
/* Names and file names are text, wherever they are shown. */
async function names(tab) {
  const evil = '<img/src=x/onerror=window.hit=1>&"', cube = readFileSync('tests/scenes/wall.obj', 'latin1');
  const first = /^o (\S+)/m.exec(cube)[1];
  await drop(tab, '<img src=x onerror=window.hit=1>.obj', cube.replaceAll(first, evil));
  test('a name of marks is a name', await tab.until(`${P}.model.shape.names.includes(${JSON.stringify(evil)})`));
  await tab.frames(3);
  test('and no element', await tab.value(`!window.hit && document.querySelectorAll('img').length === 0`));
  test('nor in the picture', await tab.value(`(() => { const d = new DOMParser().parseFromString(${P}.core.picture(),
    'image/svg+xml'); return !d.querySelector('parsererror, img, script'); })()`));
  test('nor in the JSON', await tab.value(`!!JSON.parse(${P}.core.json())`));
}
/* What is on the screen at all of it: nothing sticks out sideways, all stones are in view. */
const within = tab => tab.value(`Array.from(document.querySelectorAll('header *, .panel *'), e => [e, e.getBoundingClientRect()])
  .filter(([e, r]) => r.width && getComputedStyle(e).clipPath === 'none' && !e.closest('.skip, .unseen')
    && (r.right > innerWidth + 0.5 || r.left < -0.5)).map(([e]) => e.id || e.tagName).join(' ')`);
const inView = tab => tab.value(`(() => { const v = ${P}.view, at = v.camera.position.clone(); let most = 0;
  for (let k = 0; k < v.shape.vertices.length; k += 3) {
    at.fromArray(v.shape.vertices, k).sub(v.solids.origin).applyQuaternion(v.world.quaternion).project(v.camera);
    most = Math.max(most, Math.abs(at.x), Math.abs(at.y)); } return most; })()`);
async function sizes() {
  for (const [name, width, height, phone] of [['phone-light', 390, 780, true], ['phone-narrow', 320, 568, true],
    ['phone-landscape', 780, 390, true], ['tablet', 820, 1180, true], ['desktop-wide', 1920, 1080, false]]) {
    const tab = await browser.open(url, { width, height, phone, still: true });
    await ready(tab);
    await tab.frames(3);
    test(name + ': nothing sticks out', await within(tab) === '', await within(tab));
    test(name + ': all stones are in view', await inView(tab) < 1, String(await inView(tab)));
    await shot(tab, name);
    await tab.send('Emulation.setDeviceMetricsOverride', { width: height, height: width, deviceScaleFactor: 1, mobile: phone });
    await tab.frames(4);
    test(name + ', turned: all stones stay in view', await inView(tab) < 1, String(await inView(tab)));
    test(name + ', turned: nothing sticks out', await within(tab) === '', await within(tab));
    await tab.close();
  }
}
async function small() {
  const tab = await browser.open(url, { width: 390, height: 780, phone: true, dark: true, still: true });
  await ready(tab);
  await tab.frames(3);
  test('a phone needs no sideways scroll', await tab.value('document.documentElement.scrollWidth <= innerWidth'));
  test('and shows picture and verdict at once', await tab.value(`
    document.getElementById('verdict').getBoundingClientRect().bottom < innerHeight
    && document.getElementById('view').getBoundingClientRect().height > 200`));
  test('it is drawn', (await drawn(tab)).share > 0.03);
  await shot(tab, 'phone-dark');
  await example(tab, 1);
  await tab.frames(3);
  const one = (await drawn(tab)).hash;
  await tab.frames(6);
  test('who wants less motion sees a state, not a motion', one === (await drawn(tab)).hash
    && await verdict(tab) === 'unstable');
  await shot(tab, 'phone-dark-falls');
  const eye = () => tab.value(`${P}.view.camera.position.toArray().concat(${P}.view.camera.position.length())`);
  const from = await eye();
  await tab.touch([[200, 300], [280, 310]]);
  const turned = await eye();
  test('a finger turns the view', Math.abs(turned[0] - from[0]) > 0.1 && Math.abs(turned[3] - from[3]) < 1e-6);
  await tab.touch([[180, 300], [130, 300]], [[220, 300], [270, 300]]);
  test('two fingers come nearer', (await eye())[3] < 0.8 * turned[3]);
  await tab.value(`document.querySelector('[value=move]').click(), ${P}.view.home()`);
  await tab.frames();
  const stone = await place(tab, 8);
  await tab.touch([stone, [stone[0] + 40, stone[1]]]);
  test('a finger moves a stone', await tab.value(`Math.hypot(...${P}.model.state.change[8].by) > 0.01`));
  await tab.value(`document.querySelector('[value=turn]').click()`);
  await press(tab, 'restore');
  await tab.touch([[200, 700], [200, 560]]);
  test('a finger below the picture scrolls the page', await tab.until('scrollY > 50'));
  await rests(tab);                                     /* what still glides would go on after the next line */
  await tab.value('scrollTo(0, 600)');
  await tab.frames();
  await shot(tab, 'phone-dark-below');
  await drop(tab, 'bad.obj', 'o a\nv 1 2\n');
  await tab.until(`/bad\\.obj:2:/.test(document.getElementById('error').textContent)`);
  await rests(tab);
  const seen = JSON.parse(await tab.value(`(() => {
    const r = document.getElementById('error').getBoundingClientRect();
    const on = document.elementFromPoint(r.left + r.width / 2, r.top + r.height / 2);
    return JSON.stringify({ top: r.top, below: innerHeight - r.bottom, on: on && on.id, scrolled: scrollY }); })()`));
  test('what is refused is told where it is seen', seen.top >= 0 && seen.below >= 0 && seen.on === 'error', JSON.stringify(seen));
  test('no error on its console', tab.errors.length === 0, tab.errors.join('; '));
  await tab.close();
}
async function dark() {
  const tab = await browser.open(url, { dark: true });
  await ready(tab);
  await tab.frames(3);
  test('dark has other colours', await tab.value(`getComputedStyle(document.body).backgroundColor`) === 'rgb(22, 24, 28)');
  await shot(tab, 'desktop-dark');
  await tab.close();
}
async function flat() {
  const tab = await browser.open(url, { first: 'HTMLCanvasElement.prototype.getContext = () => null' });
  await ready(tab);
  test('without WebGL it answers', await verdict(tab) === 'stable'
    && await tab.value(`!document.getElementById('no-view').hidden`));
  await set(tab, 'mu', 0.1);
  test('at every change', await verdict(tab) === 'unstable');
  await set(tab, 'stone', 'b3');
  await press(tab, 'take');
  test('of stones, too', await tab.value(`${P}.model.shape.blocks`) === 16);
  await tab.close();
}
try {
  const tab = await begins();
  for (const part of [decides, changes, drags, keys, files, link, names]) await part(tab);
  test('no error on the console', tab.errors.length === 0, tab.errors.join('; '));
  test('nothing is fetched', tab.fetched.length === 0, tab.fetched.join(' '));
  await early();
  await forged();
  await sizes();
  await small();
  await dark();
  await flat();
} catch (e) {
  test('the browser answers', false, e.stack);
}
await browser.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
