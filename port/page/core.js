/* core: the library and the program's reader as WebAssembly, behind plain calls. page.c says what each does. */
const FREE = 0, FIXED = 63;
export const VERDICTS = ['undecided', 'stable', 'unstable'];
export const BLOCK = { row: 10, read: 0, fixed: 1, mass: 2, centroid: 3, diameter: 6, face: 7, faces: 8, vertices: 9 };
export const JOINT = { row: 17, a: 0, b: 1, force: 2, at: 5, used: 8, tension: 9, normal: 10, point: 13, points: 14, area: 15,
  mu: 16 };

/* bytes: of the .wasm. It imports nothing. */
export async function openCore(bytes) {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const c = instance.exports, text = new TextDecoder(), write = new TextEncoder();
  c._initialize();
  const string = at => {
    if (!at) return '';
    const heap = new Uint8Array(c.memory.buffer);
    return text.decode(heap.subarray(at, heap.indexOf(0, at)));
  };
  const reals = (at, n) => at ? new Float64Array(c.memory.buffer, at, n) : new Float64Array(0);
  const ints = (at, n) => new Int32Array(c.memory.buffer, at, n);
  const count = k => c.page_count(k);

  /* words: options as on the command line; model: its bytes.     throws what the program would print */
  function open(words, path, model) {
    const head = write.encode(words.concat(path).map(w => w + '\0').join(''));
    const at = c.page_room(head.length + model.length);
    if (!at) throw new Error(path + ': out of memory');
    const room = new Uint8Array(c.memory.buffer, at, head.length + model.length);
    room.set(head);
    room.set(model, head.length);
    if (c.page_open(words.length, model.length)) throw new Error(string(c.page_error()));
  }
  /* The stones as they are now: copies, for drawing. */
  function shape() {
    const blocks = count(0), faces = count(2);
    return {
      blocks, rows: reals(c.page_blocks(), BLOCK.row * blocks).slice(),
      vertices: reals(c.page_vertices(), 3 * count(1)).slice(),
      faces: ints(c.page_faces(), 2 * faces).slice(), corners: ints(c.page_corners(), count(3)).slice(),
      names: Array.from({ length: blocks }, (_, b) => string(c.page_name(b))),
      gravity: Array.from(reals(c.page_gravity(), 3)),
    };
  }
  /* What the last check found: views into its memory, until the next call. */
  const answer = () => ({
    joints: count(4), rows: reals(c.page_joints(), JOINT.row * count(4)), points: reals(c.page_points(), 3 * count(5)),
    motion: reals(c.page_motion(), 6 * count(0)), weakest: c.page_weakest(), verified: c.page_verified() !== 0,
    gravity: Array.from(reals(c.page_gravity(), 3)),
  });
  function build() {
    if (c.page_build()) throw new Error(string(c.page_error()));
  }
  function check() {
    const verdict = c.page_check();
    if (verdict < 0) throw new Error(string(c.page_error()));
    return VERDICTS[verdict];
  }
  return {
    open, shape, answer, build, check,
    joints: () => count(4), readBlocks: () => count(6), held: b => c.page_held(b),
    friction: mu => c.page_friction(mu), tilt: (degrees, azimuth) => c.page_tilt(degrees, azimuth),
    push: (block, f, x) => c.page_push(block, f[0], f[1], f[2], x[0], x[1], x[2]),
    block: (b, by, out, fixed) => c.page_block(b, by[0], by[1], by[2], out ? 1 : 0, fixed),
    margin: () => c.page_margin(),
    report: () => string(c.page_report()), json: () => string(c.page_json()), remarks: () => string(c.page_remarks()),
    scene: () => string(c.page_scene()), picture: () => string(c.page_picture()),
    memory: () => c.memory.buffer.byteLength,
    imports: WebAssembly.Module.imports(new WebAssembly.Module(bytes)).length, FREE, FIXED,
  };
}
