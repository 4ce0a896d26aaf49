'use strict';
// The range coder (ARITH-RANGE-1 to ARITH-RANGE-7, ARITH-BYTES-1, ARITH-BYTES-2).

const { reject } = require('./rejection.js');

const SETTLED = 1n << 48n;
const START = 1n << 56n;
const FORTY = 40n;

/** The bytes of digits of up to 511, each 256 times the next (ARITH-RANGE-5). */
class CarryingBytes {
  constructor() {
    this.bytes = [];
    this.held = -1; // none
    this.waiting = 0;
  }

  digit(digit) {
    if (digit === 255) {
      this.waiting += 1;
      return;
    }
    this.release(digit >> 8);
    this.held = digit & 255;
  }

  release(carry) {
    if (this.held >= 0) this.bytes.push(this.held + carry);
    for (; this.waiting > 0; this.waiting -= 1) this.bytes.push((255 + carry) & 255);
  }

  done() {
    this.release(0);
    return Uint8Array.from(this.bytes);
  }
}

class State {
  constructor() {
    this.low = 0n;
    this.range = START;
  }

  /** ARITH-RANGE-2. Answers with what is taken from below. */
  narrow(low, high, total) {
    const unit = this.range / BigInt(total);
    const taken = unit * BigInt(low);
    this.low += taken;
    this.range = high === total ? this.range - taken : unit * BigInt(high - low);
    return taken;
  }

  /** ARITH-RANGE-3. Answers with the digit. */
  shift() {
    const digit = Number(this.low / SETTLED);
    this.low = (this.low % SETTLED) << 8n;
    this.range <<= 8n;
    return digit;
  }

  /** ARITH-RANGE-4. */
  end() {
    return (this.low + (1n << FORTY) - 1n) >> FORTY;
  }
}

function encodeMessage(model, symbols) {
  const state = new State();
  const bytes = new CarryingBytes();
  symbols.forEach((symbol, place) => {
    const slot = model.slot(symbol);
    if (slot === null) reject('not-in-alphabet', 'INFO-MODEL-5', { symbol: place });
    state.narrow(slot[0], slot[1], model.total);
    while (state.range <= SETTLED) bytes.digit(state.shift());
    model.advance(symbol);
  });
  const end = Number(state.end());
  bytes.digit(end >> 8);
  bytes.digit(end & 255);
  const done = bytes.done();
  return { bytes: done, length: 8 * done.length };
}

function decodeMessage(model, bits, count) {
  const state = new State();
  let used = 0;
  let code = 0n;
  const feed = () => {
    code = (code << 8n) | BigInt(bits.bytes[used] ?? 0);
    used += 1;
  };
  while (used < 7) feed();
  const needed = () => used - 5; // the shifts plus 2
  const symbols = [];
  const checkLength = () => {
    if (8 * needed() > bits.length) {
      reject('truncated-bits', 'ARITH-BYTES-2', { symbol: Math.max(symbols.length - 1, 0) });
    }
  };
  checkLength();
  while (symbols.length < count) {
    const target = Number(code / (state.range / BigInt(model.total)));
    const symbol = model.find(Math.min(target, model.total - 1)); // ARITH-RANGE-6
    const [low, high] = model.slot(symbol);
    code -= state.narrow(low, high, model.total);
    while (state.range <= SETTLED) {
      state.shift();
      feed();
    }
    model.advance(symbol);
    symbols.push(symbol);
    checkLength();
  }
  if (8 * needed() < bits.length) reject('trailing-bits', 'ARITH-BYTES-2');
  if ((state.low + code) >> FORTY !== state.end()) reject('not-canonical', 'ARITH-BYTES-2'); // ARITH-RANGE-7
  return symbols;
}

module.exports = { encodeMessage, decodeMessage };
