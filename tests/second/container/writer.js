'use strict';
// Values in bytes, written (FILE-NUMBER-1 to FILE-NUMBER-5, FILE-BITS-1).

class Writer {
  constructor() {
    this.bytes = [];
  }

  raw(bytes) {
    for (const byte of bytes) this.bytes.push(byte);
  }

  u8(value) {
    this.bytes.push(value);
  }

  u32(value) {
    for (let place = 0; place < 4; place += 1) this.u8(Math.floor(value / 2 ** (8 * place)) % 256);
  }

  varint(value) {
    let rest = BigInt(value);
    for (; rest > 127n; rest >>= 7n) this.u8(Number(rest & 127n) | 0x80);
    this.u8(Number(rest));
  }

  signed(value) {
    const big = BigInt(value);
    this.varint(big < 0n ? -2n * big - 1n : 2n * big);
  }

  oneOf(choices, value) {
    this.u8(choices.indexOf(value) + 1);
  }

  bits({ bytes, length }) {
    this.varint(length);
    this.raw(bytes);
  }
}

module.exports = { Writer };
