'use strict';
// The codes of words by name (CODE-NAME-1), and the symbol that is implied (CODE-IMPLIED-1, CODE-IMPLIED-2).

const { adaptive } = require('./adaptive.js');
const best = require('./best.js');
const context = require('./context.js');
const enumerative = require('./enumerative.js');
const golden = require('./golden.js');
const huffman = require('./huffman.js');
const kingRossignac = require('./king_rossignac.js');
const { minimax } = require('./minimax.js');
const { MINIMAX_3, MINIMAX_8 } = require('./minimax_tables.js');
const plain = require('./plain.js');
const { closingsOf } = require('../closings.js');
const { Unsupported, reject } = require('../rejection.js');

const CODES = new Map([
  ['plain', plain],
  ['king-rossignac', kingRossignac],
  ['golden', golden],
  ['huffman', huffman],
  ['adaptive-1', adaptive(1)],
  ['adaptive-3', adaptive(3)],
  ['adaptive-6', adaptive(6)],
  ['minimax-3', minimax(MINIMAX_3)],
  ['minimax-8', minimax(MINIMAX_8)],
  ['context', context],
  ['enumerative', enumerative],
  ['best', best],
]);

function codeNamed(name) {
  if (!CODES.has(name)) throw new Unsupported(`code.${name}`); // ORCL-REPLY-3, ORCL-OP-6
  return CODES.get(name);
}

/** CODE-IMPLIED-1: the symbols that are not coded. */
function impliedIn(boundaryComponents) {
  return boundaryComponents === 0 ? 'C' : '';
}

/** CODE-IMPLIED-2. What a code rejects it blames on symbols counted without the implied one. */
function encodeWord(name, stream) {
  const code = codeNamed(name);
  const { word, boundaryComponents } = stream;
  const implied = impliedIn(boundaryComponents);
  if (!word.startsWith(implied)) reject('not-in-alphabet', 'CODE-IMPLIED-2', { symbol: 0 });
  const closings = closingsOf(word, stream.records); // CODE-HAND-2: refused, whether the code needs them or not
  return code.encode(word.slice(implied.length), implied, stream, closings);
}

function decodeWord(name, bits, told) {
  const { symbols, boundaryComponents } = told;
  const code = codeNamed(name);
  const implied = impliedIn(boundaryComponents);
  if (symbols < implied.length) reject('empty-word', 'CODE-IMPLIED-2');
  return implied + code.decode(bits, symbols - implied.length, implied, told);
}

module.exports = { CODES, codeNamed, encodeWord, decodeWord };
