/* link: all that is asked, in the part of an address behind #: deflated JSON, letters that an address may hold. */

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

/* From a state of model.js to letters, and back; null: no such link. */
export async function toLink(state) {
  const { text, ...rest } = state, model = letters(text);
  const json = new TextEncoder().encode(JSON.stringify({ ...rest, model }));
  const packed = await through(json, new CompressionStream('deflate-raw'));
  return letters(packed).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}
export async function fromLink(hash) {
  if (hash.length < 8) return null;
  try {
    const packed = bytesOf(hash.replaceAll('-', '+').replaceAll('_', '/'));
    const json = await through(packed, new DecompressionStream('deflate-raw'));
    const { model, ...rest } = JSON.parse(new TextDecoder().decode(json));
    return { ...rest, text: bytesOf(model) };
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
