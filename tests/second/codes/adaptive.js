'use strict';
// The codes `adaptive-k` (CODE-ADAPTIVE-1).

const { decodeWord, encodeWord } = require('./modelled.js');
const { Adaptive } = require('../models.js');

const fresh = (before) => new Adaptive(before === 'C' ? [1, 0, 0, 1, 1] : [1, 1, 1, 1, 1], 2, 4096);

/** INFO-CONTEXT-3: a model for each value of the last k symbols. The past begins with the implied symbol. */
function contexts(order, implied) {
  const models = new Map();
  let past = implied;
  return {
    get table() {
      if (!models.has(past)) models.set(past, fresh(past.at(-1)));
      return models.get(past);
    },
    after(symbol) {
      past = (past + symbol).slice(-order);
    },
  };
}

const adaptive = (order) => ({
  encode: (word, before) => encodeWord(word, contexts(order, before), 'CODE-ADAPTIVE-1'),
  decode: (bits, symbols, before) => decodeWord(bits, symbols, contexts(order, before)),

  /** CODE-NAME-3. */
  mostSymbols: (bits) => 1420 * bits + 2,
});

module.exports = { adaptive };
