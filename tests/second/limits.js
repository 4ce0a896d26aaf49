'use strict';
// The reader's limits (CPLX-INPUT-3, FILE-LIMIT-1), and how much this adapter takes on (ORCL-HELLO-2).

module.exports = {
  FACES: 2 ** 26,
  VERTICES: 2 ** 26,
  BYTES: 2 ** 31,
  MAX_FACES: 1_000_000,
  MAX_SYMBOLS: 1_000_000,
};
