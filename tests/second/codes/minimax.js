'use strict';
// The codes `minimax-k` (CODE-MINIMAX-1 to CODE-MINIMAX-5).

const { decodeWord, encodeWord } = require('./modelled.js');
const { Static } = require('../models.js');
const { reject } = require('../rejection.js');
const { SYMBOLS, rejectUnknown } = require('./alphabet.js');

/** The contexts of a code: each has its table, and for each symbol the number of the context after it, or -1. */
function contextsOf(rows) {
  return rows.map((row) => {
    const entries = row.split(/ +/).map((entry) => (entry === '-' ? [0, -1] : entry.split('>').map(Number)));
    return { table: new Static(entries.map(([frequency]) => frequency)), after: entries.map(([, context]) => context) };
  });
}

function minimax(rows) {
  const contexts = contextsOf(rows);

  /** CODE-MINIMAX-4: from context 0, or after an implied C from the context that C leads to. */
  const walk = (before) => {
    let here = before === 'C' ? contexts[0].after[0] : 0;
    return {
      get table() {
        return contexts[here].table;
      },
      after(symbol) {
        here = contexts[here].after[SYMBOLS.indexOf(symbol)];
      },
    };
  };

  return {
    encode(word, before) {
      const walked = walk(before);
      rejectUnknown(word, 'CODE-MINIMAX-4');
      for (let place = 0; place < word.length; place += 1) {
        if (walked.table.slot(SYMBOLS.indexOf(word[place])) === null) {
          reject('not-representable', 'CODE-MINIMAX-5', { symbol: place });
        }
        walked.after(word[place]);
      }
      return encodeWord(word, walk(before), 'CODE-MINIMAX-4');
    },

    decode: (bits, symbols, before) => decodeWord(bits, symbols, walk(before)),

    /** CODE-MINIMAX-7. */
    mostSymbols: (bits) => 2 * bits + 1,
  };
}

module.exports = { minimax };
