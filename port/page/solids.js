/* solids: the stones as one mesh and one set of edges, each vertex with its block, so that a motion is a few sums. */
import * as THREE from 'three';
import { BLOCK } from './core.js';

/* Triangles of a face, whatever its shape: by its projection along its normal. */
function triangles(polygon) {
  if (polygon.length === 3) return [[0, 1, 2]];
  const n = new THREE.Vector3(), cross = new THREE.Vector3(), mid = new THREE.Vector3();
  polygon.forEach((p, k) => n.add(cross.crossVectors(p, polygon[(k + 1) % polygon.length])));
  if (polygon.length === 4) {
    const diagonal = mid.subVectors(polygon[2], polygon[0]), side = k => new THREE.Vector3().subVectors(polygon[k], polygon[0]);
    const one = cross.crossVectors(side(1), diagonal).dot(n);
    const other = cross.crossVectors(diagonal, side(3)).dot(n);
    if (one > 0 && other > 0) return [[0, 1, 2], [0, 2, 3]];
  }
  const e = new THREE.Vector3(Math.abs(n.x) < Math.abs(n.y) ? 1 : 0, Math.abs(n.x) < Math.abs(n.y) ? 0 : 1, 0);
  const u = new THREE.Vector3().crossVectors(e, n).normalize(), v = new THREE.Vector3().crossVectors(n, u).normalize();
  return THREE.ShapeUtils.triangulateShape(polygon.map(p => new THREE.Vector2(p.dot(u), p.dot(v))), []);
}

/* position, block of each corner drawn; the same of edges. */
export class Solids {
  constructor(shape) {
    const at = [], block = [], edge = [], edgeBlock = [], seen = new Set();
    const point = v => new THREE.Vector3().fromArray(shape.vertices, 3 * v);
    for (let b = 0; b < shape.blocks; b++) {
      const first = shape.rows[BLOCK.row * b + BLOCK.face], faces = shape.rows[BLOCK.row * b + BLOCK.faces];
      for (let f = first; f < first + faces; f++) {
        const corner = shape.corners.subarray(shape.faces[2 * f], shape.faces[2 * f] + shape.faces[2 * f + 1]);
        const polygon = Array.from(corner, point);
        for (const t of triangles(polygon)) for (const k of t) { at.push(corner[k]); block.push(b); }
        corner.forEach((v, k) => {
          const w = corner[(k + 1) % corner.length], key = Math.min(v, w) + ' ' + Math.max(v, w);
          if (seen.has(key)) return;
          seen.add(key);
          edge.push(v, w);
          edgeBlock.push(b, b);
        });
      }
    }
    this.shape = shape;
    this.corner = Int32Array.from(at);
    this.block = Int32Array.from(block);
    this.edge = Int32Array.from(edge);
    this.edgeBlock = Int32Array.from(edgeBlock);
    this.origin = this.findBox();
    this.faces = new THREE.BufferGeometry();
    this.faces.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * at.length), 3));
    this.faces.setAttribute('color', new THREE.BufferAttribute(new Float32Array(3 * at.length), 3));
    this.edges = new THREE.BufferGeometry();
    this.edges.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * edge.length), 3));
    this.place(null, 0);
  }
  /* The same stones elsewhere.     returns 1, 0: these are others */
  follow(shape) {
    const same = (a, b) => a.length === b.length && a.every((x, k) => x === b[k]);
    if (!same(shape.names, this.shape.names) || !same(shape.corners, this.shape.corners)) return 0;
    this.shape = shape;
    this.place(null, 0);
    return 1;
  }
  /* Middle and size of the scene; drawing is about the middle, for coordinates that are far from 0. */
  findBox() {
    this.box = new THREE.Box3().setFromArray(this.shape.vertices);
    if (this.box.isEmpty()) this.box.set(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
    this.size = this.box.getSize(new THREE.Vector3()).length();
    return this.box.getCenter(new THREE.Vector3());
  }
  /* Bring every corner to where it is after so much of a motion: x' = c + t v + R(t w) (x - c). motion null: at rest. */
  place(motion, t) {
    const moved = motion && t ? this.turned(motion, t) : this.shape.vertices;
    const put = (attribute, index) => {
      const to = attribute.array, o = this.origin;
      for (let k = 0; k < index.length; k++) {
        const v = 3 * index[k];
        to[3 * k] = moved[v] - o.x; to[3 * k + 1] = moved[v + 1] - o.y; to[3 * k + 2] = moved[v + 2] - o.z;
      }
      attribute.needsUpdate = true;
    };
    put(this.faces.attributes.position, this.corner);
    put(this.edges.attributes.position, this.edge);
    this.faces.computeBoundingSphere();
  }
  turned(motion, t) {
    const s = this.shape, out = s.vertices.slice(), c = new THREE.Vector3(), x = new THREE.Vector3(), w = new THREE.Vector3();
    for (let b = 0, v = 0; b < s.blocks; b++) {
      const end = v + s.rows[BLOCK.row * b + BLOCK.vertices], d = motion.subarray(6 * b, 6 * b + 6);
      if (d.every(y => y === 0)) { v = end; continue; }
      c.fromArray(s.rows, BLOCK.row * b + BLOCK.centroid);
      w.set(d[3], d[4], d[5]).multiplyScalar(t);
      const angle = w.length();
      if (angle > 0) w.divideScalar(angle);
      for (; v < end; v++) {
        x.fromArray(s.vertices, 3 * v).sub(c);
        if (angle > 0) x.applyAxisAngle(w, angle);
        out[3 * v] = c.x + x.x + t * d[0];
        out[3 * v + 1] = c.y + x.y + t * d[1];
        out[3 * v + 2] = c.z + x.z + t * d[2];
      }
    }
    return out;
  }
  /* How far the fastest corner goes for t = 1. */
  reach(motion) {
    const moved = this.turned(motion, 1e-3), was = this.shape.vertices;
    let most = 0;
    for (let k = 0; k < was.length; k += 3)
      most = Math.max(most, Math.hypot(moved[k] - was[k], moved[k + 1] - was[k + 1], moved[k + 2] - was[k + 2]));
    return most / 1e-3;
  }
  /* color(b): of block b, a THREE.Color */
  paint(color) {
    const to = this.faces.attributes.color, of = Array.from({ length: this.shape.blocks }, (_, b) => color(b));
    this.block.forEach((b, k) => to.setXYZ(k, of[b].r, of[b].g, of[b].b));
    to.needsUpdate = true;
  }
  dispose() { this.faces.dispose(); this.edges.dispose(); }
}
