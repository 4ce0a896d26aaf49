'use strict';
// The code `golden` (CODE-GOLDEN-1 to CODE-GOLDEN-3).

const { decodeWord, encodeWord } = require('./modelled.js');
const { Static } = require('../models.js');

const FIBONACCI = [0, 1];
while (FIBONACCI.length <= 24) FIBONACCI.push(FIBONACCI.at(-1) + FIBONACCI.at(-2));

/** CODE-GOLDEN-2: the table of symbols that cost so many units; null is not in the alphabet. */
const tableOf = (units) => new Static(units.map((unit) => (unit === null ? 0 : FIBONACCI[24 - unit])));

// C, L, E, R, S (CODE-GOLDEN-1)
const AFTER_C = tableOf([1, null, null, 3, 4]);
const ELSEWHERE = tableOf([2, 4, 3, 4, 5]);

/** CODE-GOLDEN-3: the context is the symbol before, the implied one included. */
const tables = (before) => {
  let last = before;
  return {
    get table() {
      return last === 'C' ? AFTER_C : ELSEWHERE;
    },
    after(symbol) {
      last = symbol;
    },
  };
};

module.exports = {
  encode: (word, before) => encodeWord(word, tables(before), 'CODE-GOLDEN-1'),
  decode: (bits, symbols, before) => decodeWord(bits, symbols, tables(before)),

  /** CODE-NAME-3. */
  mostSymbols: (bits) => Math.floor(bits / Math.log2((1 + Math.sqrt(5)) / 2)) + 2,
};
