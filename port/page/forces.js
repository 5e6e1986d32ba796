/* forces: what each joint passes on, as a rod along it; the weakest joint as a polygon; the push as an arrow. */
import * as THREE from 'three';
import { JOINT } from './core.js';

const UP = new THREE.Vector3(0, 1, 0);

export class Forces {
  constructor(size) {
    this.size = size;
    this.group = new THREE.Group();
    this.rods = null;
    this.over = { depthTest: false, transparent: true };
    this.rodColor = new THREE.MeshBasicMaterial({ ...this.over, opacity: 0.9 });
    this.weakColor = new THREE.MeshBasicMaterial({ ...this.over, opacity: 0.75, side: THREE.DoubleSide });
    this.weak = new THREE.Mesh(new THREE.BufferGeometry(), this.weakColor);
    this.pushColor = new THREE.MeshBasicMaterial({ ...this.over, opacity: 0.9 });
    this.shaft = new THREE.Mesh(new THREE.CylinderGeometry(1, 1, 1, 10).translate(0, 0.5, 0), this.pushColor);
    this.head = new THREE.Mesh(new THREE.ConeGeometry(1, 1, 16).translate(0, -0.5, 0), this.pushColor);
    this.arrow = new THREE.Group().add(this.shaft, this.head);
    this.shaft.renderOrder = this.head.renderOrder = this.weak.renderOrder = 3;
    this.group.add(this.weak, this.arrow);
    this.arrow.visible = this.weak.visible = false;
  }
  room(n) {
    if (this.rods && this.rods.instanceMatrix.count >= n) return;
    if (this.rods) { this.group.remove(this.rods); this.rods.dispose(); }
    this.rods = new THREE.InstancedMesh(new THREE.CylinderGeometry(1, 1, 1, 8), this.rodColor, Math.max(n, 16));
    this.rods.frustumCulled = false;
    this.rods.renderOrder = 2;
    this.group.add(this.rods);
  }
  /* answer: of the core; origin: middle of the scene; length: of the largest force drawn. */
  show(answer, origin, length) {
    const x = answer.rows, at = new THREE.Vector3(), f = new THREE.Vector3(), turn = new THREE.Quaternion();
    const matrix = new THREE.Matrix4(), scale = new THREE.Vector3();
    let most = 0, n = 0;
    this.room(answer.joints);
    for (let k = 0; k < answer.joints; k++)
      most = Math.max(most, Math.hypot(...x.subarray(JOINT.row * k + JOINT.force, JOINT.row * k + JOINT.force + 3)));
    for (let k = 0; k < answer.joints; k++) {
      f.fromArray(x, JOINT.row * k + JOINT.force);
      const share = most > 0 ? f.length() / most : 0;
      if (!(share > 1e-3)) continue;
      at.fromArray(x, JOINT.row * k + JOINT.at).sub(origin);
      turn.setFromUnitVectors(UP, f.normalize());
      const thick = length * (0.012 + 0.03 * Math.sqrt(share));
      this.rods.setMatrixAt(n++, matrix.compose(at, turn, scale.set(thick, length * share, thick)));
    }
    this.rods.count = n;
    this.rods.instanceMatrix.needsUpdate = true;
    this.showWeakest(answer, origin);
  }
  showWeakest(answer, origin) {
    const k = JOINT.row * answer.weakest, corners = [];
    this.hasWeak = answer.weakest >= 0 && answer.rows[k + JOINT.points] > 2;
    if (!this.hasWeak) return;
    const first = 3 * answer.rows[k + JOINT.point], points = answer.rows[k + JOINT.points];
    const corner = i => corners.push(answer.points[first + 3 * i] - origin.x, answer.points[first + 3 * i + 1] - origin.y,
      answer.points[first + 3 * i + 2] - origin.z);
    for (let i = 1; i + 1 < points; i++) { corner(0); corner(i); corner(i + 1); }
    this.weak.geometry.setAttribute('position', new THREE.Float32BufferAttribute(corners, 3));
    this.weak.geometry.computeBoundingSphere();
  }
  /* The push: from where, which way, how long; null: none. */
  push(from, along, length) {
    this.arrow.visible = !!from && length > 0;
    if (!this.arrow.visible) return;
    const head = Math.min(0.4 * length, 0.05 * this.size), thick = 0.006 * this.size;
    this.arrow.position.copy(from);
    this.arrow.quaternion.setFromUnitVectors(UP, along);
    this.shaft.scale.set(thick, length - head, thick);
    this.head.position.set(0, length, 0);
    this.head.scale.set(0.35 * head, head, 0.35 * head);
  }
  /* Are forces and weakest joint seen? They belong to the stones at rest. */
  still(seen) {
    if (this.rods) this.rods.visible = seen;
    this.weak.visible = seen && this.hasWeak;
  }
  colors(look) {
    this.rodColor.color.set(look.force);
    this.weakColor.color.set(look.weak);
    this.pushColor.color.set(look.push);
  }
  dispose() {
    if (this.rods) this.rods.dispose();
    this.weak.geometry.dispose();
    for (const part of [this.shaft, this.head]) part.geometry.dispose();
  }
}
