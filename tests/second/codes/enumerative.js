'use strict';
// The code `enumerative` (CODE-ENUM-1 to CODE-ENUM-3, CODE-ENUM-5).

const { sphereOf, treeWord } = require('./tree_word.js');
const { decodeMessage, encodeMessage } = require('../arithmetic.js');
const { reject } = require('../rejection.js');
const { decodeStream } = require('../unwind.js');
const { encodeSurface } = require('../walk.js');

/** INFO-ENUM-6, for zeros and ones. */
class Urn {
  constructor(zeros, ones) {
    this.left = [zeros, ones];
  }

  get total() {
    return this.left[0] + this.left[1];
  }

  slot(symbol) {
    if (this.left[symbol] === 0) return null;
    return symbol === 0 ? [0, this.left[0]] : [this.left[0], this.total];
  }

  find(target) {
    return target < this.left[0] ? 0 : 1;
  }

  advance(symbol) {
    this.left[symbol] -= 1;
  }
}

const refuse = () => reject('not-representable', 'CODE-ENUM-1');

module.exports = {
  encode(coded, implied, stream, closings) {
    if (implied === '' || closings.length > 0) refuse();
    const surface = decodeStream(stream);
    if (surface.faces !== stream.word.length + 1) refuse(); // several components
    const inner = treeWord(surface).slice(2, -2); // CODE-ENUM-2
    return encodeMessage(new Urn(3 * inner.length / 4, inner.length / 4), inner);
  },

  decode(bits, symbols, implied, { closings }) {
    const faces = symbols + implied.length + 1;
    if (implied === '' || closings.length > 0 || faces % 2 !== 0 || faces < 4) refuse();
    const ones = faces / 2 - 2;
    const inner = decodeMessage(new Urn(3 * ones, ones), bits, 4 * ones);
    const { word } = encodeSurface(sphereOf([1, 0, ...inner, 0, 0]));
    return word.slice(implied.length);
  },

  /** CODE-ENUM-5. */
  mostSymbols: (bits) => bits + 3,
};
