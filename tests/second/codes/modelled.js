'use strict';
// Words coded by the coder of chapter 2: the symbols C, L, E, R, S are numbered 0 to 4 (EB-WORD-1).

const { Decoder, Encoder } = require('../arithmetic.js');
const { reject } = require('../rejection.js');
const { SYMBOLS, rejectUnknown } = require('./alphabet.js');

/** `contexts` has the `table` that the next symbol meets, and is told each symbol by `after`. */
function encodeWord(word, contexts, clause) {
  rejectUnknown(word, clause);
  const encoder = new Encoder();
  for (let place = 0; place < word.length; place += 1) {
    const number = SYMBOLS.indexOf(word[place]);
    if (!encoder.put(contexts.table, number)) reject('not-in-alphabet', 'INFO-MODEL-5', { symbol: place });
    contexts.after(word[place]);
  }
  return encoder.done();
}

function decodeWord(bits, symbols, contexts) {
  const decoder = new Decoder(bits);
  const word = [];
  while (word.length < symbols) {
    const symbol = SYMBOLS[decoder.take(contexts.table)];
    contexts.after(symbol);
    word.push(symbol);
  }
  decoder.finish();
  return word.join('');
}

module.exports = { encodeWord, decodeWord };
