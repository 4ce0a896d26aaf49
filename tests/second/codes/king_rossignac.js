'use strict';
// The code `king-rossignac` (CODE-KR-1 to CODE-KR-3).

const { BitWriter, bitAt } = require('../bits.js');
const prefix = require('./prefix.js');
const { reject } = require('../rejection.js');

const AFTER_C = { C: '0', S: '10', R: '11' };
const CODES = [
  { C: '0', S: '100', R: '101', L: '110', E: '111' },
  { C: '00', S: '111', R: '10', L: '110', E: '01' },
  { C: '00', S: '010', R: '011', L: '10', E: '11' },
];
const SELECTORS = ['00', '01', '10'];
const CLAUSES = { truncated: 'CODE-KR-3', trailing: 'CODE-KR-3' };

const tableOf = (code) => (before) => (before === 'C' ? AFTER_C : CODES[code]);

/** CODE-KR-2: the code whose codewords are the shortest together, and of several the first. */
function shortest(word, before) {
  const lengths = CODES.map((_, code) => prefix.lengthOf(word, before, tableOf(code)));
  return lengths.indexOf(Math.min(...lengths));
}

module.exports = {
  encode(word, before) {
    prefix.write(new BitWriter(), word, before, tableOf(0), 'CODE-KR-1'); // a codeword in one is one in all
    const code = shortest(word, before);
    const writer = new BitWriter();
    writer.write(SELECTORS[code]);
    prefix.write(writer, word, before, tableOf(code), 'CODE-KR-1');
    return writer.done();
  },

  decode(bits, symbols, before) {
    if (bits.length < 2) reject('truncated-bits', 'CODE-KR-3', { symbol: 0 });
    const code = 2 * bitAt(bits, 0) + bitAt(bits, 1);
    if (code === 3) reject('not-canonical', 'CODE-KR-3');
    const word = prefix.read(bits, 2, symbols, before, tableOf(code), CLAUSES);
    if (shortest(word, before) !== code) reject('not-canonical', 'CODE-KR-3');
    return word;
  },

  /** CODE-KR-7. */
  mostSymbols: (bits) => Math.max(bits - 2, 0) + 1,
};
