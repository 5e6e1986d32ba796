/* model: what is asked of the core: a model, and what was changed of it. Everything a link holds is in `state`. */
import { BLOCK } from './core.js';

const NOTHING = () => ({ mu: null, tilt: 0, azimuth: 0, push: null, change: {} });

export class Model {
  constructor(core) {
    this.core = core;
    this.state = { name: '', words: [], text: new Uint8Array(0), ...NOTHING() };
    this.shape = null;
    this.verdict = '';
    this.took = 0;
    this.error = '';
  }
  /* Open a model, with what was changed of it before (of a link), or nothing. */
  open(name, words, text, changes) {
    this.core.open(words, name, text);
    const tilt = word => words.includes('--tilt') ? (words[words.indexOf('--tilt') + 1] + ',0').split(',')[word] : 0;
    this.state = { name, words, text, ...NOTHING(), tilt: +tilt(0), azimuth: +tilt(1), ...changes };
    for (const b of Object.keys(this.state.change)) if (!(+b < this.core.readBlocks())) delete this.state.change[b];
    this.build();
  }
  /* After stones were moved, taken out, held or let go. */
  build() {
    for (const [b, c] of Object.entries(this.state.change)) this.core.block(+b, c.by, c.out, c.fixed);
    this.apply();
    this.core.build();
    this.shape = this.core.shape();
    this.number = new Map(Array.from({ length: this.shape.blocks }, (_, k) => [this.shape.rows[BLOCK.row * k], k]));
  }
  apply() {
    const s = this.state, force = this.pushForce();
    this.core.friction(s.mu === null ? -1 : s.mu);
    this.core.tilt(s.tilt, s.azimuth);
    this.core.push(force ? s.push.block : -1, force || [0, 0, 0], force ? this.pushPoint() : [0, 0, 0]);
  }
  /* Weight of a block, by its number now [N]. */
  weight(k) { return this.shape.rows[BLOCK.row * k + BLOCK.mass] * Math.hypot(...this.shape.gravity); }
  centroid(k) {
    const at = BLOCK.row * k + BLOCK.centroid;
    return Array.from(this.shape.rows.subarray(at, at + 3));
  }
  /* The force of the push [N], null: none. */
  pushForce() {
    const p = this.state.push, k = p && this.number ? this.number.get(p.block) : undefined;
    if (k === undefined || !(p.share > 0)) return null;
    return p.along.map(x => x * p.share * this.weight(k));
  }
  pushPoint() {
    const p = this.state.push, c = this.centroid(this.number.get(p.block));
    return p.from ? c.map((x, i) => x + p.from[i]) : c;
  }
  /* The change of a block, by its number as read. */
  changeOf(b) {
    return this.state.change[b] || (this.state.change[b] = { by: [0, 0, 0], out: false, fixed: this.core.held(b) });
  }
  isChanged() { return Object.keys(this.state.change).length > 0; }
  restore() {
    for (const b of Object.keys(this.state.change)) this.core.block(+b, [0, 0, 0], false, this.core.held(+b));
    this.state.change = {};
    this.build();
  }
  /* Ask. Verdict, milliseconds, or the error in words. */
  check() {
    const start = performance.now();
    this.error = '';
    try {
      this.apply();
      this.verdict = this.core.check();
    } catch (e) {
      this.verdict = '';
      this.error = e.message;
    }
    this.took = performance.now() - start;
    return this.verdict;
  }
}
