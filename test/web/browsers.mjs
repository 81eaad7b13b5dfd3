// Headless browsers, and a server of files for them.

import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, normalize } from 'node:path';
import { pathToFileURL } from 'node:url';

export const modules = process.env.HTL_NODE_MODULES;

const { default: puppeteer } = await import(pathToFileURL(createRequire(join(modules, '/')).resolve('puppeteer-core')));

// `kind` is chromium or firefox, which draws nothing without a screen; files are saved into `downloads` if that is
// given.
export async function launch(kind, downloads) {
  if (kind === 'firefox')
    return puppeteer.launch({
      headless: !process.env.DISPLAY, browser: 'firefox', executablePath: '/usr/bin/firefox-esr',
      extraPrefsFirefox: {
        'browser.download.folderList': 2, 'browser.download.dir': downloads ?? '', 'webgl.force-enabled': true,
        'browser.helperApps.neverAsk.saveToDisk': 'application/octet-stream',
      },
    });
  const browser = await puppeteer.launch({
    headless: true, executablePath: '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
           '--disable-component-update', '--disable-sync', '--enable-unsafe-swiftshader'],
  });
  if (downloads) {
    const session = await browser.target().createCDPSession();
    await session.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
  }
  return browser;
}

// A page of the browser, and what it complained of.
export async function newPage(browser) {
  const page = await browser.newPage(), complaints = [];
  await page.setViewport({ width: 1300, height: 850 });
  page.on('console', message => {
    if (['error', 'warn'].includes(message.type()) && !/GPU stall|software WebGL|GroupMarker/.test(message.text()))
      complaints.push(message.text());
  });
  page.on('pageerror', error => complaints.push(error.message));
  return { page, complaints };
}

const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };

// With these headers pages may share memory between threads.
export const isolated = {
  'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp',
};

// Serves the files of a folder, and says where.
export function serve(folder, headers = {}) {
  const server = createServer((request, response) => {
    const path = join(folder, normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname)));
    if (!existsSync(path) || !statSync(path).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { ...headers, 'Content-Type': types[extname(path)] ?? 'application/octet-stream' });
    createReadStream(path).pipe(response);
  });
  return new Promise(resolve => server.listen(0, '127.0.0.1', () =>
    resolve({ address: `http://127.0.0.1:${server.address().port}`, close: () => server.close() })));
}
