'use strict';
// Values in bytes, read (FILE-LAYOUT-2, FILE-LAYOUT-3, FILE-NUMBER-1 to FILE-NUMBER-5, FILE-BITS-1).

const { fillingIsNotZero } = require('../bits.js');
const { reject } = require('../rejection.js');

/** A window of a file: the bytes from `offset` to before `stop`. */
class Reader {
  constructor(bytes, offset, stop, section) {
    this.bytes = bytes;
    this.start = offset;
    this.offset = offset;
    this.stop = stop;
    this.section = section;
  }

  at(byte) {
    return this.section === undefined ? { byte } : { byte, section: this.section };
  }

  get left() {
    return this.stop - this.offset;
  }

  /** FILE-NUMBER-1. */
  raw(length) {
    if (length > this.left) reject('truncated-file', 'FILE-LAYOUT-3', this.at(this.offset));
    const start = this.offset;
    this.offset += length;
    return this.bytes.subarray(start, this.offset);
  }

  u8() {
    return this.raw(1)[0];
  }

  u32() {
    const [a, b, c, d] = this.raw(4);
    return a + 2 ** 8 * b + 2 ** 16 * c + 2 ** 24 * d;
  }

  /** FILE-NUMBER-3, as a BigInt. */
  bigVarint(width) {
    const start = this.offset;
    const most = Math.ceil(width / 7);
    let value = 0n;
    for (let group = 0; group < most; group += 1) {
      if (this.left === 0) reject('truncated-file', 'FILE-LAYOUT-3', this.at(this.offset));
      const byte = this.u8();
      value |= BigInt(byte & 0x7f) << BigInt(7 * group);
      if (byte & 0x80) continue;
      if (byte === 0 && group > 0) break; // not the shortest form
      if (value >= 1n << BigInt(width)) break;
      return value;
    }
    return reject('bad-number', 'FILE-NUMBER-3', this.at(start));
  }

  varint(width) {
    return Number(this.bigVarint(width));
  }

  /** FILE-NUMBER-4, as a BigInt. */
  bigSigned(width) {
    const folded = this.bigVarint(width);
    return folded & 1n ? -((folded + 1n) >> 1n) : folded >> 1n;
  }

  signed(width) {
    return Number(this.bigSigned(width));
  }

  /** So many values, each by `read`, which takes one byte at least (FILE-COUNT-1). */
  times(count, read) {
    if (this.left < count) reject('impossible-count', 'FILE-COUNT-1', this.at(this.offset));
    return Array.from({ length: count }, read);
  }

  /** FILE-NUMBER-5. */
  oneOf(choices) {
    const start = this.offset;
    const place = this.u8() - 1;
    if (!(place in choices)) reject('unknown-code', 'FILE-NUMBER-5', this.at(start));
    return choices[place];
  }

  /** FILE-BITS-1. */
  bits() {
    const start = this.offset;
    const length = this.varint(40);
    const bytes = this.raw(Math.ceil(length / 8));
    if (fillingIsNotZero(bytes, length)) reject('trailing-bits', 'ARITH-BITS-3', this.at(start));
    return { bytes, length };
  }

  /** FILE-LAYOUT-2. */
  end() {
    if (this.left > 0) reject('trailing-bytes', 'FILE-LAYOUT-2', this.at(this.offset));
  }
}

module.exports = { Reader };
