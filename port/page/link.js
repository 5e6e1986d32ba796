/* link: all that is asked, in the part of an address behind #: JSON, deflated, with a checksum, letters that an address may hold. */

/* Bytes through a stream that packs or unpacks. */
export async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}
const letters = bytes => {
  let s = '';
  for (let k = 0; k < bytes.length; k += 8192) s += String.fromCharCode(...bytes.subarray(k, k + 8192));
  return btoa(s);
};
const bytesOf = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));

const number = (x, low, high) => Number.isFinite(x) && x >= low && x <= high;
const triple = x => Array.isArray(x) && x.length === 3 && x.every(v => number(v, -1e12, 1e12));
const isChange = c => c && triple(c.by) && typeof c.out === 'boolean' && Number.isInteger(c.fixed) && number(c.fixed, 0, 63);
const isPush = p => p && Number.isInteger(p.block) && triple(p.along) && number(p.share, 0, 1e6)
  && (p.from === null || triple(p.from));
const LARGEST = 1 << 26;                                /* bytes that a link may unfold to */

/* A state as the page makes them, and nothing else: a link may come from anyone.     returns null: it is none */
function stateOf(s) {
  const good = s && typeof s.name === 'string' && Array.isArray(s.words) && s.words.every(w => typeof w === 'string')
    && typeof s.model === 'string' && (s.mu === null || number(s.mu, 0, 1e6)) && number(s.tilt, -360, 360)
    && number(s.azimuth, -360, 360) && (s.push === null || isPush(s.push)) && s.change && typeof s.change === 'object'
    && Object.entries(s.change).every(([b, c]) => /^\d+$/.test(b) && isChange(c));
  return good ? { name: s.name, words: s.words, text: bytesOf(s.model), mu: s.mu, tilt: s.tilt, azimuth: s.azimuth, push: s.push,
    change: s.change } : null;
}
/* A packed stream, as far as LARGEST. */
async function unpacked(bytes) {
  const from = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')).getReader(), parts = [];
  for (let size = 0, part; !(part = await from.read()).done;) {
    parts.push(part.value);
    if ((size += part.value.length) > LARGEST) { await from.cancel(); throw new Error('too large'); }
  }
  return new Response(new Blob(parts)).text();
}

/* From a state of model.js to letters, and back; null: no such link. */
export async function toLink(state) {
  const { text, ...rest } = state, model = letters(text);
  const json = new TextEncoder().encode(JSON.stringify({ ...rest, model }));
  const packed = await through(json, new CompressionStream('deflate'));
  return letters(packed).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}
export async function fromLink(hash) {
  if (hash.length < 8) return null;
  try {
    return stateOf(JSON.parse(await unpacked(bytesOf(hash.replaceAll('-', '+').replaceAll('_', '/')))));
  } catch (e) {
    return null;
  }
}

/* Offer text or a blob as a file. */
export function download(name, what, type) {
  const a = document.createElement('a'), url = URL.createObjectURL(what instanceof Blob ? what : new Blob([what], { type }));
  a.href = url;
  a.download = name;
  a.click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}
