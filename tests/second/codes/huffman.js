'use strict';
// The code `huffman` (CODE-HUFFMAN-1 to CODE-HUFFMAN-3).

const { BitWriter, bitAt } = require('../bits.js');
const prefix = require('./prefix.js');
const { reject } = require('../rejection.js');
const { rejectUnknown } = require('./alphabet.js');

const SYMBOLS = [...'CLERS'];
const TABLE_BITS = 15;
const CLAUSES = { truncated: 'INFO-PREFIX-3', trailing: 'INFO-PREFIX-3' };

/** INFO-HUFFMAN-1: the depth of each symbol in the tree of these counts; CODE-HUFFMAN-2: a symbol alone has 1. */
function lengthsOf(counts) {
  const lengths = counts.map(() => 0);
  let trees = counts.flatMap((weight, symbol) => (weight > 0 ? [{ weight, number: symbol, leaves: [symbol] }] : []));
  if (trees.length === 1) lengths[trees[0].number] = 1;
  for (let number = counts.length; trees.length > 1; number += 1) {
    trees.sort((one, other) => one.weight - other.weight || one.number - other.number);
    const [one, other, ...rest] = trees;
    const leaves = [...one.leaves, ...other.leaves];
    for (const leaf of leaves) lengths[leaf] += 1;
    trees = [...rest, { weight: one.weight + other.weight, number, leaves }];
  }
  return lengths;
}

/** INFO-KRAFT-2, INFO-KRAFT-3: the canonical codewords of lengths, of which 0 is none. */
function codewordsOf(lengths) {
  const symbols = lengths.map((_, symbol) => symbol).filter((symbol) => lengths[symbol] > 0);
  symbols.sort((one, other) => lengths[one] - lengths[other] || one - other);
  const table = {};
  let sum = 0; // in 128ths
  for (const symbol of symbols) {
    const length = lengths[symbol];
    if (sum + 2 ** (7 - length) > 128) reject('bad-table', 'INFO-KRAFT-2');
    table[SYMBOLS[symbol]] = (sum >> (7 - length)).toString(2).padStart(length, '0');
    sum += 2 ** (7 - length);
  }
  return table;
}

function countsOf(word) {
  const counts = SYMBOLS.map(() => 0);
  for (const symbol of word) counts[SYMBOLS.indexOf(symbol)] += 1;
  return counts;
}

module.exports = {
  encode(word, before) {
    rejectUnknown(word, 'CODE-HUFFMAN-1');
    const lengths = lengthsOf(countsOf(word));
    const table = codewordsOf(lengths);
    const writer = new BitWriter();
    for (const length of lengths) writer.write(length.toString(2).padStart(3, '0'));
    prefix.write(writer, word, before, () => table, 'CODE-HUFFMAN-1');
    return writer.done();
  },

  decode(bits, symbols, before) {
    if (bits.length < TABLE_BITS) reject('truncated-bits', 'CODE-HUFFMAN-3');
    const lengths = SYMBOLS.map((_, symbol) =>
      4 * bitAt(bits, 3 * symbol) + 2 * bitAt(bits, 3 * symbol + 1) + bitAt(bits, 3 * symbol + 2));
    const table = codewordsOf(lengths);
    const word = prefix.read(bits, TABLE_BITS, symbols, before, () => table, CLAUSES);
    const expected = lengthsOf(countsOf(word));
    if (expected.some((length, symbol) => length !== lengths[symbol])) reject('not-canonical', 'CODE-HUFFMAN-3');
    return word;
  },

  /** CODE-NAME-3. */
  mostSymbols: (bits) => Math.max(bits - TABLE_BITS, 0) + 1,
};
