'use strict';
// The code `best` (CODE-BEST-1, CODE-BEST-2): the shortest of five, with a selector.

const { rejectUnknown } = require('./alphabet.js');
const context = require('./context.js');
const enumerative = require('./enumerative.js');
const golden = require('./golden.js');
const kingRossignac = require('./king_rossignac.js');
const plain = require('./plain.js');
const { BitWriter, bitAt, bitsFrom } = require('../bits.js');
const { Rejection, reject } = require('../rejection.js');

const CHOICES = [['0', context], ['100', enumerative], ['101', golden], ['110', kingRossignac], ['111', plain]];

/** The bits with the selector of the code that takes the fewest; a code that refuses the word is no choice. */
function encode(word, implied, stream, closings) {
  rejectUnknown(word, 'CODE-BEST-1');
  let best = null;
  let refusal = null;
  for (const [selector, code] of CHOICES) {
    try {
      const bits = code.encode(word, implied, stream, closings);
      const length = selector.length + bits.length;
      if (best === null || length < best.length) best = { selector, bits, length };
    } catch (fault) {
      if (!(fault instanceof Rejection)) throw fault;
      refusal = fault;
    }
  }
  if (best === null) throw refusal;
  const writer = new BitWriter();
  writer.write(best.selector);
  writer.append(best.bits);
  return writer.done();
}

function selected(bits) {
  for (const [selector, code] of CHOICES) {
    if (selector.length > bits.length) continue;
    if ([...selector].every((digit, place) => Number(digit) === bitAt(bits, place))) return [selector, code];
  }
  return reject('truncated-bits', 'CODE-BEST-2');
}

module.exports = {
  encode,

  decode(bits, symbols, implied, told) {
    const [selector, code] = selected(bits);
    const rest = bitsFrom(bits, selector.length);
    const word = code.decode(rest, symbols, implied, told);
    // CODE-BEST-2: the others are given the closings as they are told; only without any is a surface asked for.
    const stream = { word: implied + word, records: [], boundaryComponents: told.boundaryComponents };
    const [shortest] = selected(encode(word, implied, stream, told.closings));
    if (shortest !== selector) reject('not-canonical', 'CODE-BEST-2');
    return word;
  },

  /** CODE-NAME-3. */
  mostSymbols: (bits) =>
    Math.max(...CHOICES.map(([selector, code]) => code.mostSymbols(Math.max(bits - selector.length, 0)))),
};
