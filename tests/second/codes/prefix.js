'use strict';
// Codewords that follow one another (INFO-PREFIX-2, INFO-PREFIX-3).

const { bitAt } = require('../bits.js');
const { reject } = require('../rejection.js');

/**
 * The codewords of a word, one after another. `table(before)` has the codewords after a symbol; a symbol without one
 * breaks the clause that gives the codewords.
 */
function write(writer, word, before, table, clause) {
  let last = before;
  for (let place = 0; place < word.length; place += 1) {
    const codeword = table(last)[word[place]];
    if (codeword === undefined) reject('not-in-alphabet', clause, { symbol: place });
    writer.write(codeword);
    last = word[place];
  }
}

/** The length of what `write` writes. */
function lengthOf(word, before, table) {
  let last = before;
  let length = 0;
  for (const symbol of word) {
    length += table(last)[symbol].length;
    last = symbol;
  }
  return length;
}

/**
 * Reads so many symbols from a place in the bits, and nothing may follow. Symbols are blamed by their place among
 * those that are coded.
 */
function read(bits, start, symbols, before, table, clauses) {
  const word = [];
  let place = start;
  let last = before;
  while (word.length < symbols) {
    const codewords = Object.entries(table(last));
    let digits = '';
    let found;
    while (found === undefined) {
      if (place >= bits.length) reject('truncated-bits', clauses.truncated, { symbol: word.length });
      digits += bitAt(bits, place);
      place += 1;
      found = codewords.find(([, codeword]) => codeword === digits);
      if (found === undefined && !codewords.some(([, codeword]) => codeword.startsWith(digits))) {
        reject('not-canonical', 'INFO-PREFIX-3', { symbol: word.length });
      }
    }
    [last] = found;
    word.push(last);
  }
  if (place < bits.length) reject('trailing-bits', clauses.trailing);
  return word.join('');
}

module.exports = { write, read, lengthOf };
