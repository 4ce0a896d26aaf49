'use strict';
// The alphabet of words (EB-WORD-1).

const { reject } = require('../rejection.js');

const SYMBOLS = 'CLERS';

/** Another character is not in the alphabet of a code, by the clause that says how the code codes symbols. */
function rejectUnknown(word, clause) {
  const unknown = word.search(/[^CLERS]/);
  if (unknown >= 0) reject('not-in-alphabet', clause, { symbol: unknown });
}

module.exports = { SYMBOLS, rejectUnknown };
