/* chromium: a browser without a screen, told by its own protocol over a pipe. Nothing of npm is needed. */
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export class Chromium {
  constructor(program) {
    this.home = mkdtempSync(join(tmpdir(), 'stonepack-page-'));
    this.process = spawn(program, ['--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--remote-debugging-pipe',
      '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--hide-scrollbars',
      '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--user-data-dir=' + this.home],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    this.waiting = new Map();
    this.heard = [];
    this.number = 0;
    let rest = '';
    this.process.stdio[4].setEncoding('utf8');
    this.process.stdio[4].on('data', data => {
      const parts = (rest + data).split('\0');
      rest = parts.pop();
      for (const part of parts) this.hear(JSON.parse(part));
    });
    this.process.on('exit', () => { for (const w of this.waiting.values()) w.reject(new Error('the browser is gone')); });
  }
  hear(message) {
    const w = this.waiting.get(message.id);
    if (!w) { for (const f of this.heard) f(message); return; }
    this.waiting.delete(message.id);
    if (message.error) w.reject(new Error(w.method + ': ' + message.error.message));
    else w.resolve(message.result);
  }
  send(method, params = {}, sessionId) {
    const id = ++this.number;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + '\0');
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject, method }));
  }
  /* how: { width, height, phone, dark, still, first: a script before the page's own } */
  async open(url, how = {}) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const tab = new Tab(this, sessionId, targetId);
    await tab.begin(url, how);
    return tab;
  }
  async close() {
    await this.send('Browser.close').catch(() => {});
    await new Promise(done => this.process.exitCode === null ? this.process.once('exit', done) : done());
    rmSync(this.home, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}

const said = details => details.exception?.description || details.text;

class Tab {
  constructor(browser, session, target) {
    Object.assign(this, { browser, session, target, errors: [], fetched: [] });
    browser.heard.push(m => m.sessionId === session && this.hear(m.method, m.params));
  }
  send(method, params) { return this.browser.send(method, params, this.session); }
  hear(method, p) {
    if (method === 'Runtime.exceptionThrown') this.errors.push(said(p.exceptionDetails));
    if (method === 'Runtime.consoleAPICalled' && p.type === 'error')
      this.errors.push(p.args.map(a => a.value || a.description).join(' '));
    if (method === 'Log.entryAdded' && p.entry.level === 'error') this.errors.push(p.entry.text);
    if (method === 'Network.requestWillBeSent' && !/^(file|data|blob):/.test(p.request.url)) this.fetched.push(p.request.url);
  }
  async begin(url, { width = 1280, height = 800, phone = false, dark = false, still = false, first = '' }) {
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await this.send(domain + '.enable');
    await this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: phone });
    await this.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
      { name: 'prefers-reduced-motion', value: still ? 'reduce' : 'no-preference' }] });
    if (first) await this.send('Page.addScriptToEvaluateOnNewDocument', { source: first });
    await this.send('Page.navigate', { url });
  }
  /* The value of an expression; a promise is waited for. */
  async value(expression) {
    const r = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (r.exceptionDetails) throw new Error(expression + ': ' + said(r.exceptionDetails));
    return r.result.value;
  }
  /* Wait until it is true; a minute is granted.     returns whether it came true */
  async until(expression) {
    for (const end = Date.now() + 60000; Date.now() < end; await new Promise(f => setTimeout(f, 50)))
      if (await this.value('!!(' + expression + ')')) return true;
    return false;
  }
  frames(n = 2) {
    return this.value(`new Promise(done => { let n = ${n}; const f = () => n-- ? requestAnimationFrame(f) : done(1); f(); })`);
  }
  mouse(type, x, y, more = {}) {
    const buttons = type === 'mouseReleased' ? 0 : 1;
    return this.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons, clickCount: 1, ...more });
  }
  async drag(from, to, steps = 6) {
    await this.mouse('mousePressed', from[0], from[1]);
    for (let k = 1; k <= steps; k++)
      await this.mouse('mouseMoved', from[0] + (to[0] - from[0]) * k / steps, from[1] + (to[1] - from[1]) * k / steps);
    await this.frames();
    await this.mouse('mouseReleased', to[0], to[1]);
    await this.frames();
  }
  /* Fingers, each [from, to]. */
  async touch(...fingers) {
    const at = k => fingers.map(([a, b], id) => ({ x: a[0] + (b[0] - a[0]) * k / 6, y: a[1] + (b[1] - a[1]) * k / 6, id }));
    await this.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 2 });
    await this.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(0) });
    for (let k = 1; k <= 6; k++) await this.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(k) });
    await this.frames();
    await this.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await this.frames();
  }
  async key(key, code = key) {
    const known = { ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Delete: 46, Tab: 9 };
    const text = key.length === 1 ? key : undefined;
    const p = { key, code, windowsVirtualKeyCode: known[key] || key.toUpperCase().charCodeAt(0), text };
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', ...p });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', ...p });
    await this.frames();
  }
  async screen() { return Buffer.from((await this.send('Page.captureScreenshot', { format: 'png' })).data, 'base64'); }
  close() { return this.browser.send('Target.closeTarget', { targetId: this.target }); }
}
