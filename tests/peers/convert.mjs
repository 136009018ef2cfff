// node convert.mjs NODE_MODULES FROM TO: QTI 2.1 items of a folder as QTI 3, which the player plays.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'fs';

const [, , modules, from, to] = process.argv;
const { convertQti2toQti3 } = await import(`${modules}/@citolab/qti-convert/dist/qti-converter-node/index.js`);
mkdirSync(to, { recursive: true });
for (const file of readdirSync(from))
  writeFileSync(`${to}/${file}`, await convertQti2toQti3(readFileSync(`${from}/${file}`, 'utf8')));
