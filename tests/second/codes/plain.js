'use strict';
// The code `plain` (CODE-PLAIN-1, CODE-PLAIN-2).

const { BitWriter } = require('../bits.js');
const prefix = require('./prefix.js');

const TABLE = { C: '0', S: '100', R: '101', L: '110', E: '111' };
const table = () => TABLE;
const CLAUSES = { truncated: 'CODE-PLAIN-2', trailing: 'CODE-PLAIN-2' };

module.exports = {
  encode(word, before) {
    const writer = new BitWriter();
    prefix.write(writer, word, before, table, 'CODE-PLAIN-1');
    return writer.done();
  },

  decode(bits, symbols, before) {
    return prefix.read(bits, 0, symbols, before, table, CLAUSES);
  },

  /** CODE-NAME-3. */
  mostSymbols: (bits) => bits + 1,
};
