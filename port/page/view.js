/* view: the scene in 3D, drawn when something changed. Up on the screen is against gravity as read; tilted, the scene tilts. */
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { BLOCK } from './core.js';
import { Solids } from './solids.js';
import { Forces } from './forces.js';

const UP = new THREE.Vector3(0, 1, 0), SWING = 2600;                    /* [ms] of one showing of a motion */

export class View {
  constructor(canvas, still) {
    this.canvas = canvas;
    this.still = still;                                                 /* () => 1: nothing moves by itself */
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 100);
    this.turn = new OrbitControls(this.camera, canvas);
    this.turn.enableDamping = false;
    this.turn.addEventListener('change', () => this.draw());
    this.scene = new THREE.Scene();
    this.world = new THREE.Group();                                     /* the model, about its middle, tilted */
    const sun = new THREE.DirectionalLight(0xffffff, 2.1);
    sun.position.set(2, 4, 3);
    this.light = new THREE.HemisphereLight(0xffffff, 0x888888, 1.6);
    this.scene.add(this.world, sun, this.light);
    this.stone = new THREE.MeshLambertMaterial({ vertexColors: true, flatShading: true, polygonOffset: true,
      polygonOffsetFactor: 1, polygonOffsetUnits: 1, side: THREE.DoubleSide });
    this.line = new THREE.LineBasicMaterial({ transparent: true, opacity: 0.75 });
    this.seeing = { forces: true, motion: true };
    this.selected = -1;
    this.frames = [];
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }
  resize() {
    const box = this.canvas.parentElement.getBoundingClientRect();
    if (!(box.width > 0 && box.height > 0)) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(box.width, box.height, false);
    const before = Math.min(1, this.camera.aspect);
    this.camera.aspect = box.width / box.height;
    this.camera.updateProjectionMatrix();
    if (this.solids) this.step(0, 0, Math.min(1, this.camera.aspect) / before);         /* what was in view stays there */
    this.draw();
  }
  /* Colours of the page's style. */
  look(style) {
    this.colors = Object.fromEntries(['stone', 'support', 'moving', 'selected', 'edge', 'force', 'weak', 'push', 'table']
      .map(name => [name, style.getPropertyValue('--' + name).trim()]));
    this.line.color.set(this.colors.edge);
    if (this.table) this.table.material.color.set(this.colors.table);
    if (this.forces) this.forces.colors(this.colors);
    if (this.solids) this.paint();
    this.draw();
  }
  /* The stones of another model, or of the same changed. keep: the camera stays. */
  show(shape, keep) {
    if (keep && this.solids && this.solids.follow(shape)) { this.shape = shape; this.answer = null; this.speed = 0; return; }
    const origin = keep && this.solids ? this.solids.origin.clone() : null;
    this.clear();
    this.solids = new Solids(shape);
    if (origin) { this.solids.origin = origin; this.solids.place(null, 0); }
    this.shape = shape;
    this.forces = new Forces(this.solids.size);
    this.forces.colors(this.colors);
    this.body = new THREE.Mesh(this.solids.faces, this.stone);
    this.body.frustumCulled = false;
    this.outline = new THREE.LineSegments(this.solids.edges, this.line);
    this.outline.frustumCulled = false;
    this.up = new THREE.Vector3().fromArray(shape.gravity).negate().normalize();
    if (!(this.up.length() > 0)) this.up.set(0, 0, 1);
    this.world.add(this.body, this.outline, this.forces.group);
    this.addTable();
    this.answer = null;
    this.world.quaternion.setFromUnitVectors(this.up, UP);
    if (!keep) this.home();
    this.paint();
  }
  clear() {
    this.world.clear();
    if (this.solids) { this.solids.dispose(); this.forces.dispose(); this.table.geometry.dispose(); }
  }
  /* A disc under the lowest stone, so that level and tilt are seen. */
  addTable() {
    const s = this.solids, low = this.shape.vertices.reduce((least, _, k) => k % 3 ? least : Math.min(least,
      this.up.dot(new THREE.Vector3().fromArray(this.shape.vertices, k).sub(s.origin))), 0);
    const color = this.table ? this.table.material.color : new THREE.Color(this.colors.table);
    this.table = new THREE.Mesh(new THREE.CircleGeometry(0.62 * s.size, 64),
      new THREE.MeshBasicMaterial({ color, transparent: true, opacity: 0.5, side: THREE.DoubleSide, depthWrite: false }));
    this.table.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), this.up);
    this.table.position.copy(this.up).multiplyScalar(low - 0.002 * s.size);
    this.world.add(this.table);
  }
  /* From the front left and above, all of it in view. The longer side in plan is the front. */
  home() {
    const size = this.solids.size, box = new THREE.Box3(), x = new THREE.Vector3();
    for (let k = 0; k < this.shape.vertices.length; k += 3)
      box.expandByPoint(x.fromArray(this.shape.vertices, k).sub(this.solids.origin).applyQuaternion(this.world.quaternion));
    const side = box.getSize(new THREE.Vector3()), turned = side.z > side.x ? Math.PI / 2 : 0;
    const far = 0.56 * size / Math.sin(THREE.MathUtils.degToRad(35 / 2)) / Math.min(1, this.camera.aspect);
    this.camera.near = far / 100;
    this.camera.far = 20 * far;
    this.camera.updateProjectionMatrix();
    this.turn.target.set(0, 0, 0);
    this.camera.position.setFromSphericalCoords(far, 1.2, turned - 0.5);
    this.turn.update();
    this.draw();
  }
  /* Turn by so many steps to the right and up, come nearer by a factor. */
  step(right, up, factor) {
    const at = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.turn.target));
    at.theta += 0.12 * right;
    at.phi = THREE.MathUtils.clamp(at.phi - 0.12 * up, 0.02, Math.PI - 0.02);
    at.radius /= factor;
    this.camera.position.setFromSpherical(at).add(this.turn.target);
    this.turn.update();
    this.draw();
  }
  /* What a check said: forces, weakest joint, motion; gravity turns the scene. */
  tell(answer, push) {
    const s = this.solids, g = new THREE.Vector3().fromArray(answer.gravity).negate();
    this.answer = { ...answer, motion: answer.motion.slice() };
    if (g.length() > 0) this.world.quaternion.setFromUnitVectors(g.normalize(), UP);
    this.forces.show(answer, s.origin, 0.16 * s.size);
    this.showPush(push);
    this.speed = this.answer.motion.length ? s.reach(this.answer.motion) : 0;
    this.began = this.began && this.speed ? this.began : performance.now();
    this.paint();
    this.placeMotion();
    this.draw();
  }
  showPush(push) {
    if (!push) { this.forces.push(null); return; }
    const along = new THREE.Vector3().fromArray(push.along), length = 0.12 * this.solids.size * Math.min(2.5, 0.4 + push.share);
    const at = new THREE.Vector3().fromArray(push.at).sub(this.solids.origin);
    this.forces.push(at.addScaledVector(along, -length), along, length);
  }
  moves(b) {
    const m = this.answer && this.answer.motion;
    return m && m.length > 6 * b && this.speed > 0 && m.subarray(6 * b, 6 * b + 6).some(x => Math.abs(x) > 1e-6);
  }
  paint() {
    const c = Object.fromEntries(Object.entries(this.colors).map(([k, x]) => [k, new THREE.Color(x)]));
    this.solids.paint(b => b === this.selected ? c.selected : this.shape.rows[BLOCK.row * b + BLOCK.fixed] === 63 ? c.support
      : this.moves(b) ? c.moving : c.stone);
  }
  select(b) { this.selected = b; this.paint(); this.draw(); }
  see(what, on) {
    this.seeing[what] = on;
    this.began = performance.now();
    this.placeMotion();
    this.draw();
  }
  /* Where the motion is now: it begins slowly, stays a moment, and begins anew. */
  placeMotion() {
    const moving = this.speed > 0 && this.seeing.motion;
    this.forces.still(this.seeing.forces && !moving);
    if (!moving) { if (this.out) this.solids.place(null, 0); this.out = 0; return; }
    const t = this.still() ? 0.8 : Math.min(1, ((performance.now() - this.began) % SWING) / (0.75 * SWING));
    this.out = t * t * 0.12 * this.solids.size / this.speed;
    this.solids.place(this.answer.motion, this.out);
  }
  isMoving() { return this.speed > 0 && this.seeing.motion && !this.still(); }
  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(now => {
      this.waiting = 0;
      if (this.before) this.before();                                   /* questions of this frame */
      if (!this.solids) return;
      if (this.isMoving()) { this.placeMotion(); this.draw(); }
      this.renderer.render(this.scene, this.camera);
      this.frames.push(now);
      while (now - this.frames[0] > 1000) this.frames.shift();
    });
  }
  /* Frames of the last second. */
  rate() { return this.frames.length; }
  /* The stone under a place of the canvas: { block, at } in the model's axes, or null. */
  pick(x, y) {
    const ray = this.ray(x, y), hit = ray.intersectObject(this.body, false)[0];
    return hit ? { block: this.solids.block[3 * hit.faceIndex], at: this.toModel(hit.point) } : null;
  }
  ray(x, y) {
    const box = this.canvas.getBoundingClientRect(), ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(2 * (x - box.left) / box.width - 1, 1 - 2 * (y - box.top) / box.height), this.camera);
    return ray;
  }
  toModel(p) { return this.world.worldToLocal(p.clone()).add(this.solids.origin); }
  /* Where the ray through a place meets a plane through a point of the model: level, upright facing the eye, or facing it.
   * null: it does not. */
  meet(x, y, through, plane) {
    const at = this.world.localToWorld(through.clone().sub(this.solids.origin));
    const eye = this.camera.getWorldDirection(new THREE.Vector3());
    const level = this.up.clone().applyQuaternion(this.world.quaternion);
    const normal = plane === 'level' && Math.abs(eye.dot(level)) > 0.12 ? level
      : plane === 'upright' ? eye.clone().addScaledVector(level, -eye.dot(level)).normalize() : eye;
    const flat = new THREE.Plane().setFromNormalAndCoplanarPoint(normal, at);
    const hit = this.ray(x, y).ray.intersectPlane(flat, new THREE.Vector3());
    return hit ? this.toModel(hit) : null;
  }
  picture() {
    this.renderer.render(this.scene, this.camera);
    return new Promise(done => this.canvas.toBlob(done, 'image/png'));
  }
}
