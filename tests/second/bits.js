'use strict';
// Strings of bits (ARITH-BITS-1, ARITH-BITS-2): bytes and a length, the first bit the highest of the first byte.

const { reject } = require('./rejection.js');

class BitWriter {
  constructor() {
    this.bytes = new Uint8Array(64);
    this.length = 0;
  }

  push(bit) {
    const byte = this.length >> 3;
    if (byte === this.bytes.length) {
      const longer = new Uint8Array(2 * byte);
      longer.set(this.bytes);
      this.bytes = longer;
    }
    if (bit) this.bytes[byte] |= 0x80 >> (this.length & 7);
    this.length += 1;
  }

  /** The bits of a string of the characters 0 and 1. */
  write(digits) {
    for (const digit of digits) this.push(digit === '1' ? 1 : 0);
  }

  append(bits) {
    for (let place = 0; place < bits.length; place += 1) this.push(bitAt(bits, place));
  }

  done() {
    return { bytes: this.bytes.slice(0, Math.ceil(this.length / 8)), length: this.length };
  }
}

/** The bit at a place; zero where the bits are used up (ARITH-DECODE-1). */
function bitAt(bits, place) {
  return place < bits.length ? (bits.bytes[place >> 3] >> (7 - (place & 7))) & 1 : 0;
}

/** The bits from a place on, as bits of their own. */
function bitsFrom(bits, start) {
  const rest = new BitWriter();
  for (let place = start; place < bits.length; place += 1) rest.push(bitAt(bits, place));
  return rest.done();
}

/** ARITH-BITS-3: bytes and a length from outside. */
function bitsFromOutside(bytes, length) {
  const needed = Math.ceil(length / 8);
  if (length < 0 || bytes.length < needed) reject('truncated-bits', 'ARITH-BITS-3');
  if (bytes.length > needed) reject('trailing-bits', 'ARITH-BITS-3', { byte: needed });
  if (fillingIsNotZero(bytes, length)) reject('trailing-bits', 'ARITH-BITS-3', { byte: needed - 1 });
  return { bytes, length };
}

/** Whether a bit behind the last, in the last byte, is not zero. */
function fillingIsNotZero(bytes, length) {
  const used = length % 8;
  return used !== 0 && (bytes[bytes.length - 1] & (0xff >> used)) !== 0;
}

module.exports = { BitWriter, bitAt, bitsFrom, bitsFromOutside, fillingIsNotZero };
