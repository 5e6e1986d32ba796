/* words: what the page says of an answer. The rows are those of the program's report. */
export const SAYS = { stable: 'It stands', unstable: 'It falls', undecided: 'Not decided', '': 'Not answered' };

/* 1234.5, "N": "1.23 kN" */
export function scaled(x, unit) {
  const names = ['n', 'µ', 'm', '', 'k', 'M', 'G'];
  let k = 3, y = Math.abs(x);
  while (y >= 999.5 && k < 6) { y /= 1000; k++; }
  while (y > 0 && y < 0.9995 && k > 0) { y *= 1000; k--; }
  return (x < 0 ? '-' : '') + +y.toPrecision(3) + ' ' + names[k] + unit;
}

/* Rows of a report, [label, text]; but the first line, remarks, which the page shows otherwise, and the program's time. */
export function rowsOf(report) {
  const rows = [];
  for (const line of report.split('\n').slice(1)) {
    const label = line.slice(2, 17).trim(), text = line.slice(17);
    if (label && label !== 'remark' && label !== 'cost') rows.push([label, text]);
  }
  return rows;
}

/* Remarks of the JSON: [sentence, words of the option that helps or []]. */
export const remarksOf = json => JSON.parse(json).remarks.map(r => [r.text, optionWords(r.option)]);

/* Words of an option as typed; one of several choices ("--unit mm, cm or in") is none. */
export function optionWords(text) {
  const words = (text || '').trim().split(/\s+/);
  return words.length === 2 && /^--[a-z-]+$/.test(words[0]) && !/[,.]{2}|,$|NAME/.test(words[1]) ? words : [];
}

/* Options as typed in one line: words, "quoted ones" whole. */
export const wordsOf = line => (line.match(/"[^"]*"|\S+/g) || []).map(w => w.replace(/^"(.*)"$/, '$1'));
export const lineOf = words => words.map(w => /\s/.test(w) ? '"' + w + '"' : w).join(' ');

/* How a margin of the push is told. */
export function marginText(m) {
  return m === Infinity ? 'it bears any multiple of this push' : m === -1 ? 'how much more was not decided'
    : m === -2 ? 'no multiple of this push holds it' : 'it bears ' + +m.toPrecision(4) + ' times this push';
}
