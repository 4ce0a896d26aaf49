'use strict';
// The arithmetic coder in 32 bits (ARITH-STATE-1 to ARITH-STRICT-4).

const { BitWriter, bitAt } = require('./bits.js');
const { Uniform, rawPieces } = require('./models.js');
const { reject } = require('./rejection.js');

const QUARTER = 2 ** 30;
const HALF = 2 * QUARTER;

/** The floor of a b / c, exactly. Products below 2^52 need no long numbers. */
function muldiv(a, b, c) {
  const product = a * b;
  return product < 2 ** 52 ? Math.floor(product / c) : Number((BigInt(a) * BigInt(b)) / BigInt(c));
}

/** The interval that encoder and decoder share (ARITH-STATE-1). */
class Interval {
  constructor() {
    this.low = 0;
    this.high = 2 ** 32 - 1;
  }

  get width() {
    return this.high - this.low + 1;
  }

  /** ARITH-NARROW-1. */
  narrow(low, high, total) {
    const { width } = this;
    this.high = this.low + muldiv(width, high, total) - 1;
    this.low += muldiv(width, low, total);
  }

  /** ARITH-SHIFT-1: what the next shift takes away, or -1 if the state is settled. */
  due() {
    if (this.high < HALF) return 0;
    if (this.low >= HALF) return HALF;
    if (this.low >= QUARTER && this.high < 3 * QUARTER) return QUARTER;
    return -1;
  }

  shift(taken) {
    this.low = 2 * (this.low - taken);
    this.high = 2 * (this.high - taken) + 1;
  }
}

class Encoder {
  constructor() {
    this.interval = new Interval();
    this.pending = 0;
    this.writer = new BitWriter();
  }

  /** ARITH-ENCODE-1, for one symbol. Answers whether the symbol is in the alphabet. */
  put(model, symbol) {
    const slot = model.slot(symbol);
    if (slot === null) return false;
    this.interval.narrow(slot[0], slot[1], model.total);
    for (let taken = this.interval.due(); taken >= 0; taken = this.interval.due()) {
      this.interval.shift(taken);
      if (taken === QUARTER) this.pending += 1;
      else this.send(taken === HALF ? 1 : 0); // ARITH-SHIFT-2
    }
    model.advance(symbol);
    return true;
  }

  /** INFO-COMBINE-7. */
  putRaw(width, value) {
    let left = width;
    for (const piece of rawPieces(width)) {
      left -= piece;
      this.put(new Uniform(2 ** piece), Math.floor(value / 2 ** left) % 2 ** piece);
    }
  }

  send(bit) {
    this.writer.push(bit);
    for (; this.pending > 0; this.pending -= 1) this.writer.push(1 - bit);
  }

  /** ARITH-END-1. */
  done() {
    this.pending += 1;
    this.send(this.interval.low < QUARTER ? 0 : 1);
    return this.writer.done();
  }
}

/** A strict reader (ARITH-STRICT-1): `take` each symbol, then `finish`. */
class Decoder {
  constructor(bits) {
    this.interval = new Interval();
    this.bits = bits;
    this.shifts = 0;
    this.symbols = 0;
    this.value = 0; // ARITH-DECODE-1
    for (let place = 0; place < 32; place += 1) this.value = 2 * this.value + bitAt(bits, place);
    this.checkLength();
  }

  /** ARITH-STRICT-2: blamed is the first symbol after which there are too few bits. */
  checkLength() {
    if (this.shifts + 2 > this.bits.length) {
      reject('truncated-bits', 'ARITH-STRICT-2', { symbol: Math.max(this.symbols - 1, 0) });
    }
  }

  /** ARITH-DECODE-2. */
  take(model) {
    const { interval } = this;
    const { total } = model;
    const product = (this.value - interval.low + 1) * total;
    const target = product < 2 ** 52
      ? Math.floor((product - 1) / interval.width)
      : Number((BigInt(this.value - interval.low + 1) * BigInt(total) - 1n) / BigInt(interval.width));
    const symbol = model.find(target);
    const [low, high] = model.slot(symbol);
    interval.narrow(low, high, total);
    for (let taken = interval.due(); taken >= 0; taken = interval.due()) {
      interval.shift(taken);
      this.value = 2 * (this.value - taken) + bitAt(this.bits, 32 + this.shifts);
      this.shifts += 1;
    }
    model.advance(symbol);
    this.symbols += 1;
    this.checkLength();
    return symbol;
  }

  takeRaw(width) {
    let value = 0;
    for (const piece of rawPieces(width)) value = value * 2 ** piece + this.take(new Uniform(2 ** piece));
    return value;
  }

  /** ARITH-STRICT-3, ARITH-STRICT-4: nothing follows, and the bits are the encoder's. */
  finish() {
    if (this.shifts + 2 < this.bits.length) reject('trailing-bits', 'ARITH-STRICT-3');
    const quarter = this.interval.low < QUARTER ? 1 : 2; // ARITH-STRICT-1
    if (Math.floor(this.value / QUARTER) !== quarter) reject('not-canonical', 'ARITH-STRICT-4');
  }
}

/** A message of one model to bits. INFO-MODEL-5: blamed is the first symbol that is not in the alphabet. */
function encodeMessage(model, symbols) {
  const encoder = new Encoder();
  symbols.forEach((symbol, place) => {
    if (!encoder.put(model, symbol)) reject('not-in-alphabet', 'INFO-MODEL-5', { symbol: place });
  });
  return encoder.done();
}

function decodeMessage(model, bits, count) {
  const decoder = new Decoder(bits);
  const symbols = [];
  while (symbols.length < count) symbols.push(decoder.take(model));
  decoder.finish();
  return symbols;
}

module.exports = { Encoder, Decoder, encodeMessage, decodeMessage };
