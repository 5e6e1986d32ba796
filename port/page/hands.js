/* hands: pointer and keys on the picture. What they do is chosen beside it: turn the view, push a stone, move a stone. */
import * as THREE from 'three';

export class Hands {
  /* to: what the page does: select(block), push(block, along, share, at), move(block, by), moved(), take(), next(step) */
  constructor(view, model, to) {
    this.view = view;
    this.model = model;
    this.to = to;
    this.mode = 'turn';
    this.held = null;
    const c = view.canvas;
    c.addEventListener('pointerdown', e => this.down(e));
    c.addEventListener('pointermove', e => this.drag(e));
    for (const end of ['pointerup', 'pointercancel']) c.addEventListener(end, e => this.up(e));
    c.addEventListener('keydown', e => { if (this.key(e)) e.preventDefault(); });
  }
  setMode(mode) { this.mode = mode; this.view.turn.enabled = true; this.view.canvas.dataset.mode = mode; }
  down(e) {
    const hit = this.view.shape && e.isPrimary ? this.view.pick(e.clientX, e.clientY) : null;
    this.start = { x: e.clientX, y: e.clientY };
    this.held = null;
    if (!hit) return;
    this.held = { ...hit, moved: false, base: this.model.shape.rows[10 * hit.block] };
    if (this.mode === 'turn') return;
    this.view.turn.enabled = false;                     /* the stone is dragged, not the view */
    this.view.canvas.setPointerCapture(e.pointerId);
    this.to.select(hit.block);
    if (this.mode === 'move') this.held.from = this.model.changeOf(this.held.base).by.slice();
  }
  drag(e) {
    const h = this.held;
    if (!h || this.mode === 'turn' || Math.hypot(e.clientX - this.start.x, e.clientY - this.start.y) < 3 && !h.moved) return;
    const plane = this.mode === 'push' ? 'facing' : e.shiftKey ? 'upright' : 'level';
    const from = this.view.meet(this.start.x, this.start.y, h.at, plane);
    const at = this.view.meet(e.clientX, e.clientY, h.at, plane);
    if (!at || !from) return;
    h.moved = true;
    const by = at.sub(from);
    if (this.mode === 'push') this.pull(h, by);
    else {
      if (plane === 'upright') by.copy(this.view.up).multiplyScalar(by.dot(this.view.up));
      this.to.move(h.base, h.from.map((x, k) => x + by.getComponent(k)));
    }
  }
  /* A quarter of the scene's size pushes with twice the stone's weight. */
  pull(h, by) {
    const length = by.length();
    if (length > 0) this.to.push(h.base, by.divideScalar(length).toArray(), 8 * length / this.view.solids.size, h.at.toArray());
  }
  up(e) {
    const h = this.held, still = this.start && Math.hypot(e.clientX - this.start.x, e.clientY - this.start.y) < 4;
    this.view.turn.enabled = true;
    this.held = null;
    if (still && e.type === 'pointerup') this.to.select(h ? h.block : -1);
    else if (h && h.moved) this.to.moved();
  }
  /* returns 1: the key was for us */
  key(e) {
    if (e.ctrlKey || e.metaKey || e.altKey) return 0;
    const side = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
    if (side && e.shiftKey) return this.nudge(side[0], side[1], 0);
    if (side) return this.view.step(side[0], side[1], 1), 1;
    if (e.key === 'PageUp' || e.key === 'PageDown') return this.nudge(0, 0, e.key === 'PageUp' ? 1 : -1);
    if (e.key === '+' || e.key === '=') return this.view.step(0, 0, 1.15), 1;
    if (e.key === '-') return this.view.step(0, 0, 1 / 1.15), 1;
    if (e.key === '0' || e.key === 'Home') return this.view.home(), 1;
    if (e.key === 'n' || e.key === 'p') return this.to.next(e.key === 'n' ? 1 : -1), 1;
    if (e.key === 'Delete' || e.key === 'x') return this.to.take(), 1;
    return 0;
  }
  /* Move the selected stone to the right, away, up: by 2 % of its size, along the level axis nearest to that. */
  nudge(right, away, up) {
    const b = this.view.selected;
    if (b < 0) return 1;
    const v = this.view, x = new THREE.Vector3().setFromMatrixColumn(v.camera.matrixWorld, 0);
    const across = x.applyQuaternion(v.world.quaternion.clone().invert());
    across.addScaledVector(v.up, -across.dot(v.up)).normalize();
    const k = [0, 1, 2].sort((i, j) => Math.abs(across.getComponent(j)) - Math.abs(across.getComponent(i)))[0];
    const axis = new THREE.Vector3().setComponent(k, Math.sign(across.getComponent(k)));
    const by = axis.clone().multiplyScalar(right).addScaledVector(new THREE.Vector3().crossVectors(v.up, axis), away)
      .addScaledVector(v.up, up).multiplyScalar(0.02 * v.shape.rows[10 * b + 6]);
    const base = v.shape.rows[10 * b];
    this.to.move(base, this.model.changeOf(base).by.map((c, i) => c + by.getComponent(i)));
    this.to.moved();
    return 1;
  }
}
