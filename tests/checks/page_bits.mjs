/* page_bits: does the core of the page say what the program says, to the last bit?   node page_bits.mjs CORE.wasm PROGRAM
 *
 * Of the ten examples and of ways to change them, `check --json --forces` of the program is compared with the page's as text,
 * but for times and bytes, which are those of another machine. Ends with `N passed, N failed`. */
import { readFileSync, writeFileSync, mkdtempSync, rmSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openCore } from '../../port/page/core.js';

const [wasm, program] = process.argv.slice(2), bytes = readFileSync(wasm), core = await openCore(bytes);
const folder = mkdtempSync(join(tmpdir(), 'stonepack-bits-'));
let passed = 0, failed = 0;
function test(name, good, more = '') {
  if (good) passed++; else { failed++; console.log('FAILED  ' + name + ' ' + more); }
}
const plain = json => json.replace(/"(seconds|peak_bytes|memory_bytes)": ?[-+.e0-9]+/g, '"$1":0')
  .replace(/^\{"scene":\s*"[^"]*"/, '{');
const native = (words, file) =>
  spawnSync(program, ['check', '--json', '--forces', ...words, file], { encoding: 'utf8' }).stdout;
function differ(a, b) {
  let k = 0;
  while (k < a.length && a[k] === b[k]) k++;
  return `page ...${a.slice(Math.max(0, k - 40), k + 60)}\n    program ...${b.slice(Math.max(0, k - 40), k + 60)}`;
}
function same(name, words, file) {
  const page = plain(core.json()), here = plain(native(words, file));
  test(name, page.length > 100 && page === here, page === here ? '' : differ(page, here));
}
/* What the page's scene is when the program reads it. */
function sameScene(name, words = []) {
  const file = join(folder, 'now.obj');
  writeFileSync(file, core.scene());
  const page = JSON.parse(core.json()), here = JSON.parse(native(words, file));
  const told = x => JSON.stringify([x.verdict, x.interfaces, x.forces]);
  test(name, told(page) === told(here), page.verdict + ' ' + here.verdict);
}

test('it imports nothing', core.imports === 0, String(core.imports));
const examples = readFileSync('port/page/examples.txt', 'utf8').split('\n').filter(l => l && !l.startsWith('#'))
  .map(l => l.split('|').map(x => x.trim()));
test('ten examples', examples.length === 10);
for (const [title, options, file] of examples) {
  const words = options ? options.split(/\s+/) : [];
  core.open(words, file, readFileSync(file));
  core.check();
  same(title, words, file);
  core.friction(0.3);
  core.tilt(4, 30);
  core.check();
  same(title + ', friction 0.3, tilt 4', [...words, '--mu', '0.3', '--tilt', '4,30'], file);
  core.friction(-1);
  core.tilt(0, 0);
  core.check();
  same(title + ', as it was', words, file);
  sameScene(title + ', written and read');
}
/* A stone moved, taken out, held; a push. */
core.open([], 'wall', readFileSync('tests/scenes/wall.obj'));
const last = core.readBlocks() - 1, none = [0, 0, 0];
core.block(last, none, true, 0);
core.build();
core.check();
test('one stone less', core.shape().blocks === last);
sameScene('one stone less, written and read');
core.block(last, [0, 0.01, 0], false, 0);
core.build();
core.check();
sameScene('a stone moved level, written and read');
test('it still touches', core.joints() >= 42, String(core.joints()));
core.block(last, [0, 0, 1], false, 0);
core.build();
test('a stone in the air falls', core.check() === 'unstable');
core.block(last, [0, 0, 1], false, core.FIXED);
core.build();
test('held it does not', core.check() === 'stable');
core.block(last, none, false, 0);
core.build();
core.push(last, [1, 0, 0], Array.from(core.shape().rows.slice(10 * last + 3, 10 * last + 6)));
test('a push of 1 N is borne', core.check() === 'stable');
sameScene('a push, written and read');
const most = core.margin(), at = Array.from(core.shape().rows.slice(10 * last + 3, 10 * last + 6));
test('and some more', most > 1 && most < 1e6, String(most));
core.push(last, [0.999 * most, 0, 0], at);
test('0.999 of its limit is borne', core.check() === 'stable');
core.push(last, [1.001 * most, 0, 0], at);
test('1.001 of its limit is not', core.check() === 'unstable');

/* Loads and strength of joints. */
const loaded = readFileSync('tests/scenes/two-cubes.obj', 'utf8') + '#@ cohesion 1000\n#@ load b1 50 0 0 0.8 0.5 1.9\n'
  + '#@ live b1 0 10 0 0 0 3 couple\n#@ mass b1 20 0.7 0.5 2\n';
writeFileSync(join(folder, 'loaded.obj'), loaded);
core.open([], 'loaded.obj', Buffer.from(loaded));
core.check();
same('loads and strength', [], join(folder, 'loaded.obj'));
core.block(1, [0.1, 0, 0], false, 0);
core.build();
test('a load moves with its stone', /^#@ load b1 50 0 0 0\.9 0\.5 1\.9$/m.test(core.scene()));
core.block(1, [0, 0, 0], true, 0);
core.build();
test('and goes with it', !/^#@ (load|live|mass)/m.test(core.scene()));

function refused(text, words = []) {
  try { core.open(words, 'bad.obj', Buffer.from(text)); return ''; } catch (e) { return e.message; }
}
test('a bad line is told with its number', /^bad\.obj:2: /.test(refused('o a\nv 1 2\n')), refused('o a\nv 1 2\n'));
test('no text is refused', /not a text file/.test(refused('\x00\x01')));
const unknown = refused('o a\n', ['--nonsense', '1']);
test('an option that the program does not know is refused', /unknown option '--nonsense'/.test(unknown), unknown);
core.open([], 'wall', readFileSync('tests/scenes/wall.obj'));
core.check();
same('after refusals', [], 'tests/scenes/wall.obj');
/* A page is open for hours: what was made is freed. */
function hours(times) {
  for (let k = 0; k < times; k++) {
    core.open([], 'a.obj', readFileSync(k % 2 ? 'tests/scenes/wall.obj' : 'tests/scenes/arch.obj'));
    for (let j = 0; j < 4; j++) {
      core.block(5, [0.001 * j, 0, 0], j === 3, 0);
      core.build();
      core.push(4, [10 * j, 0, 0], [0, 0, 0]);
      core.tilt(j, 40 * k);
      core.check();
      core.margin();
      core.shape();
    }
    core.report(), core.json(), core.scene(), core.picture(), core.remarks(), refused('o a\nv 1 2\n');
  }
  return core.memory();
}
test('memory does not grow', hours(20) === hours(120), String(core.memory()));
rmSync(folder, { recursive: true });
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
