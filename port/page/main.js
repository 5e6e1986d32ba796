/* main: the page. What is dragged is asked again in the next frame; what takes longer than a frame, as often as it can be. */
import { openCore, BLOCK, JOINT } from './core.js';
import { Model } from './model.js';
import { View } from './view.js';
import { Hands } from './hands.js';
import { toLink, fromLink, download, through } from './link.js';
import { SAYS, scaled, rowsOf, remarksOf, lineOf, wordsOf, marginText } from './words.js';

const $ = id => document.getElementById(id);
const bytesOf = id => Uint8Array.from(atob($(id).textContent.trim()), c => c.charCodeAt(0));
const examples = JSON.parse($('examples').textContent);
const still = matchMedia('(prefers-reduced-motion: reduce)');
const READS = '. This page reads OBJ and COMPAS JSON; of STL, PLY, glTF and others `stonepack convert` makes OBJ.';
let core, model, view, hands, spoken = '', due = null, free = 0;

/* ------------------------------------------------------------------------------------------------------------ the answer */

/* Ask before the next frame. build: stones were moved, taken out, held. */
function ask(build) {
  due = { build: !!build || !!(due && due.build) };
  if (view) view.draw(); else answer();
}
function answer() {
  if (!due || !model.shape) return;
  if (performance.now() < free) { setTimeout(() => view && view.draw(), 5); return; }
  const { build } = due, began = performance.now();
  due = null;
  try {
    if (build) { model.build(); if (view) view.show(model.shape, true); keepSelection(); }
    model.check();
  } catch (e) { model.verdict = ''; model.error = e.message; }
  if (view && model.verdict) view.tell(core.answer(), shownPush());
  tell();
  const end = performance.now(), took = end - began;
  free = end + (took > 40 ? took : 0);                  /* half of the time is for drawing */
}
function shownPush() {
  const p = model.pushForce() && model.state.push;
  return p ? { at: model.pushPoint(), along: p.along, share: p.share } : null;
}
function tell() {
  const v = model.verdict;
  document.body.dataset.verdict = v || 'none';
  $('verdict').textContent = SAYS[v];
  $('took').textContent = model.error
    || `${model.shape.blocks} stones, ${core.joints()} joints, checked in ${+model.took.toPrecision(2)} ms`;
  $('rows').replaceChildren(...(v ? rowsOf(core.report()) : []).flatMap(([a, b]) => [element('dt', a), element('dd', b)]));
  tellControls();
  tellStone();
  say((model.error || SAYS[v]) + (v && core.answer().weakest >= 0 ? '. Weakest joint ' + weakest() : ''));
}
function weakest() {
  const a = core.answer(), k = JOINT.row * a.weakest;
  return model.shape.names[a.rows[k]] + ' - ' + model.shape.names[a.rows[k + 1]];
}
/* What a screen reader says: when it changes, and once dragging rests. */
let saying = 0;
function say(text) {
  clearTimeout(saying);
  saying = setTimeout(() => { if (text !== spoken) $('say').textContent = spoken = text; }, 400);
}
const element = (tag, text) => Object.assign(document.createElement(tag), { textContent: text });

/* ----------------------------------------------------------------------------------------------------------- the controls */

function tellControls() {
  const s = model.state, push = model.pushForce(), own = s.mu === null && model.verdict ? ownFriction() : [];
  $('mu-out').textContent = s.mu !== null ? s.mu.toFixed(2) : own.length > 1 ? 'several' : own[0] ?? '';
  $('mu').value = s.mu === null ? (own.length ? own[0] : 0.7) : s.mu;
  $('tilt').value = s.tilt;
  $('azimuth').value = s.azimuth;
  $('tilt-out').textContent = s.tilt.toFixed(1) + '°';
  $('azimuth-out').textContent = Math.round(s.azimuth) + '°';
  $('push').value = s.push ? Math.min(2, s.push.share) : 0;
  $('push-out').textContent = push ? scaled(Math.hypot(...push), 'N') : 'none';
  $('pushed').textContent = push ? model.shape.names[model.number.get(s.push.block)] + ' is pushed'
    : chosen < 0 ? 'Choose a stone first.' : '';
  if (s.push) tellTowards(azimuthOf(s.push.along));
  $('push-azimuth-out').textContent = $('push-azimuth').value + '°';
  $('mu-own').disabled = s.mu === null;
  $('level').disabled = !s.tilt;
  $('ask-margin').disabled = $('no-push').disabled = !push;
  $('restore').disabled = !model.isChanged();
}
/* The slider of the push stands where the push points; its two ends are one direction. */
function tellTowards(degrees) {
  const now = +$('push-azimuth').value, off = Math.abs(((degrees - now) % 360 + 540) % 360 - 180);
  if (off > 0.5) $('push-azimuth').value = Math.round(degrees);
}
/* Friction of the joints as read, each value once. */
function ownFriction() {
  const { rows, joints } = core.answer(), all = new Set();
  for (let k = 0; k < joints && all.size < 2; k++) all.add(rows[JOINT.row * k + JOINT.mu]);
  return [...all];
}
function tellStone() {
  const b = selected(), x = b < 0 ? null : model.shape.rows.subarray(BLOCK.row * b, BLOCK.row * (b + 1));
  const list = $('stone'), names = model.shape.names.join('\n');
  if (list.dataset.of !== names) {
    list.replaceChildren(element('option', 'none'), ...model.shape.names.map(n => element('option', n)));
    list.dataset.of = names;
  }
  list.selectedIndex = b + 1;
  $('about').textContent = x ? (x[BLOCK.mass] > 0 ? scaled(1000 * x[BLOCK.mass], 'g') : 'no mass') + (x[BLOCK.fixed] === 63
    ? ', a support' : x[BLOCK.fixed] ? ', partly held' : '') : 'Click a stone, or choose one here.';
  $('hold').textContent = x && x[BLOCK.fixed] === 63 ? 'Let go' : 'Hold';
  for (const id of ['take', 'hold']) $(id).disabled = b < 0;
  for (const id of ['push', 'push-azimuth']) $(id).disabled = b < 0 && !model.state.push;
}
let chosen = -1;                                        /* its number as read, so that it stays the same stone */
const selected = () => chosen < 0 || !model.number.has(chosen) ? -1 : model.number.get(chosen);
function select(b) {
  chosen = b < 0 ? -1 : model.shape.rows[BLOCK.row * b];
  if (view) view.select(b);
  tellStone();
  tellControls();
}
function keepSelection() { if (view) { view.selected = selected(); view.paint(); } }
function next(step) {
  const n = model.shape.blocks;
  select((selected() + step + n + (selected() < 0 && step < 0 ? 1 : 0)) % n);
  say(model.shape.names[selected()] + ', ' + $('about').textContent);
}
function change(what) {
  if (chosen < 0) return;
  what(model.changeOf(chosen));
  ask(true);
}
function setPush(along, share) {
  const p = model.state.push, block = p ? p.block : chosen;
  if (block < 0) return;
  model.state.push = { block, along: along || (p ? p.along : level(0)), share, from: p ? p.from : null };
  ask();
}
/* The level direction of an azimuth, as `check --tilt` counts it: from x (y, where gravity is near x) towards the one
 * across. */
function level(degrees) {
  const g = model.shape.gravity, size = Math.hypot(...g), u = g.map(x => x / size), first = Math.abs(u[0]) > 0.9 ? 1 : 0;
  const a = u.map((x, k) => (k === first ? 1 : 0) - u[first] * x), n = Math.hypot(...a), h = a.map(x => x / n);
  const w = [0, 1, 2].map(k => h[(k + 1) % 3] * u[(k + 2) % 3] - h[(k + 2) % 3] * u[(k + 1) % 3]);
  const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180);
  return h.map((x, k) => c * x + s * w[k]);
}
/* The azimuth of a direction, in [0, 360): of what of it is level. */
function azimuthOf(along) {
  const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
  return (Math.atan2(dot(along, level(90)), dot(along, level(0))) * 180 / Math.PI + 360) % 360;
}
function askMargin() {
  if (!model.pushForce()) return;
  $('margin').textContent = marginText(core.margin());
}

/* -------------------------------------------------------------------------------------------------------------- the model */

function open(name, words, text, changes) {
  const keep = { ...model.state };
  chosen = -1;
  try {
    model.open(name, words, text, changes);
  } catch (e) {
    complain(e.message + (/\.(obj|json)$/i.test(name) ? '' : READS));
    if (keep.text.length && keep.text !== text) model.open(keep.name, keep.words, keep.text, keep);
    return false;
  }
  $('error').hidden = true;
  $('name').textContent = name;
  $('options').value = lineOf(words);
  if (view) view.show(model.shape);
  due = { build: false };
  free = 0;
  answer();
  tellRemarks();
  $('margin').textContent = '';
  return true;
}
function tellRemarks() {
  const all = model.verdict ? remarksOf(core.remarks()) : [];
  $('remarks').replaceChildren(...all.map(([text, words]) => {
    const li = element('li', text + ' ');
    if (words.length) {
      const b = element('button', lineOf(words));
      b.type = 'button';
      b.onclick = () => open(model.state.name, model.state.words.concat(words), model.state.text);
      li.append(b);
    }
    return li;
  }));
}
function openExample(k) {
  const e = examples[k];
  $('example').selectedIndex = k + 1;
  return open(e.file, e.words, new TextEncoder().encode(e.text));
}
async function openFile(file) {
  const bytes = file && await file.arrayBuffer()
    .catch(() => complain(file.name + ': can’t be read; one file is wanted, no folder'));
  if (bytes && open(file.name, [], new Uint8Array(bytes))) $('example').selectedIndex = 0;
}
const stem = () => model.state.name.replace(/^.*\//, '').replace(/\.[^.]*$/, '') || 'scene';
async function share() {
  const hash = await toLink(model.state);
  if (hash.length > 2e6) { complain('Too large for a link, of which browsers take 2 MB: save the scene instead'); return; }
  location.hash = hash;
  $('link').hidden = false;
  $('link').value = location.href;
  $('link').select();
  try { await navigator.clipboard.writeText(location.href); say('Link copied'); } catch (e) { say('Link ready to copy'); }
}

/* --------------------------------------------------------------------------------------------------------------- it begins */

function listen() {
  const number = (id, set) => $(id).addEventListener('input', () => { set(+$(id).value); ask(); });
  number('mu', x => { model.state.mu = x; });
  number('tilt', x => { model.state.tilt = x; });
  number('azimuth', x => { model.state.azimuth = x; });
  $('push').addEventListener('input', () => setPush(null, +$('push').value));
  $('push-azimuth').addEventListener('input', () =>
    setPush(level(+$('push-azimuth').value), (model.state.push || { share: 0.2 }).share));
  $('mu-own').onclick = () => { model.state.mu = null; ask(); };
  $('level').onclick = () => { model.state.tilt = model.state.azimuth = 0; ask(); };
  $('no-push').onclick = () => { model.state.push = null; $('margin').textContent = ''; ask(); };
  $('ask-margin').onclick = askMargin;
  $('stone').onchange = () => select($('stone').selectedIndex - 1);
  $('take').onclick = () => change(c => { c.out = true; });
  $('hold').onclick = () => change(c => { c.fixed = c.fixed === 63 ? 0 : 63; });
  $('restore').onclick = () => { model.restore(); if (view) view.show(model.shape, true); keepSelection(); ask(); };
  $('example').onchange = () => { if ($('example').selectedIndex) openExample($('example').selectedIndex - 1); };
  $('file').onchange = () => openFile($('file').files[0]);
  $('apply').onsubmit = e => { e.preventDefault(); open(model.state.name, wordsOf($('options').value), model.state.text); };
  $('save-scene').onclick = () => download(stem() + '-now.obj', core.scene(), 'text/plain');
  $('save-json').onclick = () => download(stem() + '.json', core.json(), 'application/json');
  $('save-svg').onclick = () => download(stem() + '.svg', core.picture(), 'image/svg+xml');
  $('save-png').onclick = async () => view && download(stem() + '.png', await view.picture(), 'image/png');
  $('share').onclick = share;
  for (const what of ['forces', 'motion']) $(what).onchange = () => view && view.see(what, $(what).checked);
  for (const r of document.querySelectorAll('[name=mode]')) r.onchange = () => hands && hands.setMode(r.value);
  addEventListener('dragover', e => { e.preventDefault(); document.body.dataset.over = '1'; });
  addEventListener('dragleave', e => { if (!e.relatedTarget) delete document.body.dataset.over; });
  addEventListener('drop', e => { e.preventDefault(); delete document.body.dataset.over; openFile(e.dataTransfer.files[0]); });
  addEventListener('hashchange', openLink);
}
/* The scene that the address holds.     returns 1, 0: none */
async function openLink() {
  const s = await fromLink(location.hash.slice(1));
  if (!s && location.hash.length > 8) complain('This link holds no scene, or not all of one');
  if (!s || (model.shape && JSON.stringify(await toLink(model.state)) === JSON.stringify(location.hash.slice(1)))) return !!s;
  const { name, words, text, ...changes } = s;
  return open(name, words, text, changes);
}
function complain(text) {
  $('error').textContent = text;
  $('error').hidden = false;
  $('error').scrollIntoView({ block: 'nearest' });
  say(text);
}
function startView() {
  try {
    view = new View($('view'), () => still.matches);
  } catch (e) {
    $('no-view').hidden = false;                        /* no WebGL: the answers are there, the picture is the program's */
    return;
  }
  view.before = answer;
  const dark = matchMedia('(prefers-color-scheme: dark)'), look = () => view.look(getComputedStyle(document.documentElement));
  dark.addEventListener('change', look);
  look();
  hands = new Hands(view, model, {
    select, next, take: () => change(c => { c.out = true; }),
    push: (block, along, share, at) => {
      const c = model.centroid(model.number.get(block));
      model.state.push = { block, along, share, from: at.map((x, k) => x - c[k]) };
      $('margin').textContent = '';
      ask();
    },
    move: (block, by) => { chosen = block; model.changeOf(block).by = by; ask(true); },
    moved: () => { if (view) view.draw(); },
  });
  view.show(model.shape);
  if (model.verdict) view.tell(core.answer(), shownPush());
}
async function start() {
  core = await openCore(await through(bytesOf('core'), new DecompressionStream('gzip')));
  model = new Model(core);
  $('example').append(...examples.map(e => element('option', e.title)));
  listen();
  if (!(await openLink())) {
    const why = $('error').textContent;
    openExample(0);
    if (why) complain(why + '. This is an example.');
  }
  if (window.early) await openFile(window.early);
  document.body.dataset.answered = Math.round(performance.now());       /* [ms] since the page was asked for */
  await new Promise(f => setTimeout(f));                                /* the answer is seen before the picture is made */
  startView();
  setInterval(() => { $('rate').textContent = view && view.rate() > 2 ? view.rate() + ' frames a second' : ''; }, 500);
  document.body.dataset.ready = Math.round(performance.now());
  window.stonepackPage = { core, model, view, hands, open, select, ask, share, examples };             /* for tests */
}
start().catch(e => { $('error').textContent = String(e); $('error').hidden = false; });
