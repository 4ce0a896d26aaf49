'use strict';
// rANS (ARITH-RANS-1 to ARITH-RANS-5, ARITH-BYTES-1, ARITH-BYTES-2).

const { reject } = require('./rejection.js');

const STRETCHED = 1n << 30n;
const LEAST = 1n << 48n;
const STATE_BYTES = 7;

/** ARITH-RANS-1. */
function stretch([low, high], total) {
  const start = (STRETCHED * BigInt(low)) / BigInt(total);
  return { start, size: (STRETCHED * BigInt(high)) / BigInt(total) - start };
}

function encodeMessage(model, symbols) {
  const slots = symbols.map((symbol, place) => {
    const slot = model.slot(symbol);
    if (slot === null) reject('not-in-alphabet', 'INFO-MODEL-5', { symbol: place });
    const stretched = stretch(slot, model.total);
    model.advance(symbol);
    return stretched;
  });
  const sent = [];
  let state = LEAST;
  for (const { start, size } of slots.reverse()) { // ARITH-RANS-2, ARITH-RANS-3
    while (state >= size << 26n) {
      sent.push(Number(state & 255n));
      state >>= 8n;
    }
    state = STRETCHED * (state / size) + start + (state % size);
  }
  for (let place = 0; place < STATE_BYTES; place += 1) {
    sent.push(Number(state & 255n));
    state >>= 8n;
  }
  const bytes = Uint8Array.from(sent.reverse());
  return { bytes, length: 8 * bytes.length };
}

function decodeMessage(model, bits, count) {
  let used = 0;
  let state = 0n;
  const feed = () => {
    state = (state << 8n) | BigInt(bits.bytes[used] ?? 0);
    used += 1;
  };
  while (used < STATE_BYTES) feed();
  const symbols = [];
  const checkLength = () => {
    if (8 * used > bits.length) {
      reject('truncated-bits', 'ARITH-BYTES-2', { symbol: Math.max(symbols.length - 1, 0) });
    }
  };
  checkLength();
  if (state < LEAST) reject('not-canonical', 'ARITH-RANS-5');
  while (symbols.length < count) { // ARITH-RANS-4
    const rest = state % STRETCHED;
    const symbol = model.find(Number(((rest + 1n) * BigInt(model.total) - 1n) / STRETCHED));
    const { start, size } = stretch(model.slot(symbol), model.total);
    state = size * (state / STRETCHED) + rest - start;
    while (state < LEAST) feed();
    model.advance(symbol);
    symbols.push(symbol);
    checkLength();
  }
  if (8 * used < bits.length) reject('trailing-bits', 'ARITH-BYTES-2');
  if (state !== LEAST) reject('not-canonical', 'ARITH-BYTES-2');
  return symbols;
}

module.exports = { encodeMessage, decodeMessage };
