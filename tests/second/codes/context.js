'use strict';
// The code `context` (CODE-CONTEXT-1 to CODE-CONTEXT-8): a word from its last symbol to its first.

const { rejectUnknown } = require('./alphabet.js');
const { CountedLoops, GONE } = require('./context_loops.js');
const { Mixer } = require('./mixing.js');
const { Decoder, Encoder } = require('../arithmetic.js');
const { Static } = require('../models.js');
const { reject } = require('../rejection.js');

const ASKED = 'CRLE'; // CODE-CONTEXT-1
const NONE = 5;
const CERTAIN = 65536;

class Foreteller {
  constructor(symbols, closings) {
    this.loops = new CountedLoops(symbols, closings);
    this.mixers = [...ASKED].map(() => new Mixer());
    this.slots = Array.from({ length: 5 }, () => new Map());
    this.past = new Array(12).fill(NONE); // the symbols undone, the last first
  }

  /** CODE-CONTEXT-4, each context as one number. */
  contexts(small) {
    const { after, before } = this.loops.loops;
    const { count, gate, valences } = this.loops;
    const capped = (value) => Math.min(value, 15);
    const [a, b, x, xx] = [gate, after[gate], before[gate], before[before[gate]]].map((edge) => capped(count[edge]));
    const [v1, v2] = valences.map(capped);
    const number = (digits, base) => digits.reduce((value, digit) => value * base + digit, 0);
    return [
      number([a, b, small], 16),
      number(this.past, 6) * 16 + a,
      number(this.past.slice(0, 4), 6),
      number([a, v1, v2], 16),
      number([x, a, xx, this.past[0]], 16),
    ];
  }

  /** Undoes one symbol. `decide(P)` is asked of each decision in turn, and answers whether it is yes. */
  undo(decide) {
    const { loops } = this;
    const { gate } = loops;
    const certain = [null, null, null, null];
    let contexts = null;
    if (gate === GONE) {
      certain.splice(0, 4, 0, 0, 0, CERTAIN);
    } else {
      const short = loops.loops.shorter(gate, 4);
      if (short) certain[0] = 0;
      if (!loops.canSplit()) certain[3] = CERTAIN;
      contexts = this.contexts(short ? 0 : loops.loops.shorter(gate, 5) ? 1 : 2);
    }
    let symbol = 'S';
    for (let decision = 0; decision < 4 && symbol === 'S'; decision += 1) {
      let yes;
      if (certain[decision] !== null) {
        yes = decide(certain[decision]);
      } else {
        const mixer = this.mixers[decision];
        yes = decide(mixer.foretell(this.slotsOf(contexts, decision)));
        mixer.learn(yes);
      }
      if (yes) symbol = ASKED[decision];
    }
    loops.undo(symbol);
    this.past = ['CLERS'.indexOf(symbol), ...this.past.slice(0, 11)];
    return symbol;
  }

  slotsOf(contexts, decision) {
    return contexts.map((context, which) => {
      const key = 4 * context + decision;
      if (!this.slots[which].has(key)) this.slots[which].set(key, { p: 32768, k: 0 });
      return this.slots[which].get(key);
    });
  }
}

/** CODE-NAME-3. */
const mostSymbols = (bits) => 2070 * bits + 2;

const table = (yes) => new Static([CERTAIN - yes, yes]);

module.exports = {
  encode(word, before, stream, closings) {
    rejectUnknown(word, 'CODE-CONTEXT-1');
    const foreteller = new Foreteller(word.length, closings);
    const encoder = new Encoder();
    for (let place = word.length - 1; place >= 0; place -= 1) {
      let asked = 0;
      foreteller.undo((yes) => {
        const answer = word[place] === ASKED[asked];
        asked += 1;
        if (!encoder.put(table(yes), answer ? 1 : 0)) {
          reject('not-in-alphabet', 'CODE-CONTEXT-3', { symbol: place });
        }
        return answer;
      });
    }
    return encoder.done();
  },

  decode(bits, symbols, before, { closings }) {
    const most = Math.min(symbols, mostSymbols(bits.length)); // the bits end before there are more
    const foreteller = new Foreteller(most, closings);
    const decoder = new Decoder(bits);
    const word = []; // from its end
    while (word.length < symbols) word.push(foreteller.undo((yes) => decoder.take(table(yes)) === 1));
    decoder.finish();
    return word.reverse().join('');
  },

  mostSymbols,
};
