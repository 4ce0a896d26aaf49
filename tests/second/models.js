'use strict';
// Models of messages (chapter 1): which slot a symbol has in the table that it meets.
//
// A model here is an object with `total`, `slot(symbol)`, which is [low, high] or null where the symbol is not
// in the alphabet, `find(target)`, the symbol whose slot holds the target, and `advance(symbol)`.

const { reject } = require('./rejection.js');

const LARGEST_TOTAL = 2 ** 30; // INFO-MODEL-2

/** INFO-STATIC-3: what a table from outside must satisfy. Answers with its total. */
function checkedTotal(frequencies) {
  let total = 0n;
  frequencies.forEach((frequency, symbol) => {
    if (frequency < 0) reject('bad-table', 'INFO-STATIC-3', { symbol });
    total += BigInt(frequency);
  });
  if (total === 0n || total > BigInt(LARGEST_TOTAL)) reject('bad-table', 'INFO-STATIC-3');
  return Number(total);
}

/** INFO-STATIC-1: one table for every symbol. */
class Static {
  constructor(frequencies) {
    this.cumulative = [0];
    for (const frequency of frequencies) this.cumulative.push(this.cumulative.at(-1) + frequency);
    this.total = this.cumulative.at(-1);
  }

  slot(symbol) {
    if (!(symbol >= 0 && symbol < this.cumulative.length - 1)) return null;
    const low = this.cumulative[symbol];
    const high = this.cumulative[symbol + 1];
    return low < high ? [low, high] : null;
  }

  find(target) {
    let below = 0; // cumulative[below] <= target
    let above = this.cumulative.length - 1; // target < cumulative[above]
    while (above - below > 1) {
      const middle = (below + above) >> 1;
      if (this.cumulative[middle] <= target) below = middle;
      else above = middle;
    }
    return below;
  }

  advance() {}
}

/** INFO-STATIC-2: all frequencies 1. */
class Uniform {
  constructor(size) {
    this.total = size;
  }

  slot(symbol) {
    return symbol >= 0 && symbol < this.total ? [symbol, symbol + 1] : null;
  }

  find(target) {
    return target;
  }

  advance() {}
}

/** INFO-ADAPT-1, INFO-ADAPT-2: a table that counts. The sums are kept in a Fenwick tree. */
class Adaptive {
  constructor(frequencies, increment, limit) {
    this.frequencies = frequencies.map(Number);
    this.increment = increment;
    this.limit = limit;
    this.top = 1;
    while (2 * this.top <= this.frequencies.length) this.top *= 2;
    this.build();
  }

  build() {
    const size = this.frequencies.length;
    this.tree = new Float64Array(size + 1);
    this.total = 0;
    for (let place = 1; place <= size; place += 1) {
      this.tree[place] += this.frequencies[place - 1];
      this.total += this.frequencies[place - 1];
      const parent = place + (place & -place);
      if (parent <= size) this.tree[parent] += this.tree[place];
    }
  }

  below(symbol) {
    let sum = 0;
    for (let place = symbol; place > 0; place -= place & -place) sum += this.tree[place];
    return sum;
  }

  slot(symbol) {
    if (!(symbol >= 0 && symbol < this.frequencies.length) || this.frequencies[symbol] === 0) return null;
    const low = this.below(symbol);
    return [low, low + this.frequencies[symbol]];
  }

  find(target) {
    let place = 0;
    let rest = target;
    for (let step = this.top; step > 0; step >>= 1) {
      if (place + step <= this.frequencies.length && this.tree[place + step] <= rest) {
        place += step;
        rest -= this.tree[place];
      }
    }
    return place;
  }

  advance(symbol) {
    this.frequencies[symbol] += this.increment;
    this.total += this.increment;
    if (this.total > this.limit) {
      this.frequencies = this.frequencies.map((frequency) => frequency - Math.floor(frequency / 2));
      this.build();
      return;
    }
    for (let place = symbol + 1; place < this.tree.length; place += place & -place) this.tree[place] += this.increment;
  }
}

/** INFO-LEARN-1: the add-half model of so many symbols. */
function addHalf(size) {
  return new Adaptive(new Array(size).fill(1), 2, LARGEST_TOTAL);
}

/** A model as a message describes it (ORCL-OP-4). */
function modelFromOutside(form) {
  if (form.kind === 'static') {
    checkedTotal(form.frequencies);
    return new Static(form.frequencies);
  }
  if (form.kind === 'uniform') {
    if (!(form.size >= 1 && form.size <= LARGEST_TOTAL)) reject('bad-table', 'INFO-STATIC-3');
    return new Uniform(form.size);
  }
  const total = checkedTotal(form.frequencies);
  // INFO-ADAPT-3. Limit first: an increment up to the limit is a number that is exact.
  const { increment, limit } = form;
  const good = increment >= 1 && limit <= LARGEST_TOTAL && limit >= total && increment <= limit
    && limit >= increment + form.frequencies.length;
  if (!good) reject('bad-table', 'INFO-ADAPT-3');
  return new Adaptive(form.frequencies, increment, limit);
}

/** INFO-COMBINE-7: the uniform models of the pieces of a raw number of so many bits, most significant first. */
function rawPieces(width) {
  const pieces = [];
  let left = width;
  while (left > 0) {
    const piece = left % 16 || 16;
    pieces.push(piece);
    left -= piece;
  }
  return pieces;
}

module.exports = { Static, Uniform, Adaptive, addHalf, modelFromOutside, rawPieces };
