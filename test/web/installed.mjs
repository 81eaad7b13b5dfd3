// The npm package as it is packed, installed into an empty folder.

import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

export const packed = join(process.env.HTL_WEB, readdirSync(process.env.HTL_WEB).find(name => name.endsWith('.tgz')));

export function installInto(folder) {
  mkdirSync(folder);
  writeFileSync(join(folder, 'package.json'), '{"private": true, "type": "module"}');
  execFileSync('npm', ['install', '--offline', '--silent', '--no-audit', '--no-fund', packed], { cwd: folder });
  return join(folder, 'node_modules/handle-tunnel-loops');
}
