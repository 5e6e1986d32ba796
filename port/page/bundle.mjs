/* bundle: one HTML file of page.html, its style, the scripts with three.js, ten examples and the core.
 *      node bundle.mjs MODULES CORE.wasm OUT.html        MODULES: a folder that has node_modules */
import { createRequire } from 'node:module';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const [modules, core, out] = process.argv.slice(2), here = dirname(fileURLToPath(import.meta.url));
const { buildSync } = createRequire(resolve(modules, 'x.js'))('esbuild');
const read = name => readFileSync(join(here, name), 'utf8');

const script = buildSync({ entryPoints: [join(here, 'main.js')], bundle: true, minify: true, write: false, format: 'iife',
  target: 'es2022', legalComments: 'eof', nodePaths: [resolve(modules, 'node_modules')] }).outputFiles[0].text;
const css = { contents: read('page.css'), loader: 'css' };
const style = buildSync({ stdin: css, minify: true, write: false }).outputFiles[0].text;
const examples = read('examples.txt').split('\n').filter(l => l && !l.startsWith('#')).map(line => {
  const [title, words, file] = line.split('|').map(x => x.trim());
  return { title, words: words ? words.split(/\s+/) : [], file, text: readFileSync(file, 'utf8') };
});
const licence = readFileSync(resolve(modules, 'node_modules/three/LICENSE'), 'utf8');
const parts = { LICENCE: 'three.js, which is in this file:\n' + licence, STYLE: style,
  EXAMPLES: JSON.stringify(examples).replaceAll('<', '\\u003c'), SCRIPT: script.replaceAll('</script', '<\\/script'),
  CORE: gzipSync(readFileSync(core), { level: 9 }).toString('base64') };
writeFileSync(out, read('page.html').replace(/@(LICENCE|STYLE|EXAMPLES|CORE|SCRIPT)@/g, (_, name) => parts[name]));
