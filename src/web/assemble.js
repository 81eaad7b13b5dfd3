// Puts the page into one file: assemble.js TEMPLATE OUTPUT WORD=FILE..., where @WORD@ stands for the text of a file.

import { readFileSync, writeFileSync } from 'node:fs';

const [template, output, ...pieces] = process.argv.slice(2);
const texts = Object.fromEntries(pieces.map(piece => {
  const at = piece.indexOf('=');
  return [piece.slice(0, at), readFileSync(piece.slice(at + 1), 'utf8')];
}));
const page = readFileSync(template, 'utf8').replace(/@(\w+)@/g, (_, word) => {
  if (!(word in texts))
    throw new Error(`no text is given for @${word}@`);
  // What would end the script element in which it stands; no other place has these letters.
  return texts[word].trimEnd().replaceAll('</script', '<\\/script');
});
writeFileSync(output, page);
