'use strict';
// What an operation may answer instead of a result (CONV-RESULT-2, ORCL-REPLY-2, ORCL-REPLY-3).

// CONV-RESULT-3: each reason belongs to one class. Here are the reasons that this adapter gives.
const REASONS = {
  malformed: ['trailing-bits', 'truncated-bits', 'not-canonical', 'bad-magic', 'truncated-file', 'trailing-bytes',
    'bad-checksum', 'bad-number', 'bad-section', 'impossible-count'],
  invalid: ['empty-mesh', 'index-out-of-range', 'repeated-index', 'duplicate-face', 'edge-with-three-faces',
    'edge-twice-in-one-direction', 'pinched-vertex', 'isolated-vertex', 'non-finite-coordinate', 'unknown-symbol',
    'empty-word', 'unfinished-word', 'too-few-components', 'record-order', 'record-out-of-range', 'record-side',
    'record-outside-branch', 'edge-closed-twice', 'loop-too-short', 'loop-not-closed', 'not-a-curve',
    'repeated-vertex', 'double-edge', 'bad-table', 'not-in-alphabet', 'count-mismatch', 'not-representable',
    'bad-lattice', 'bad-residual'],
  unsupported: ['unknown-version', 'unknown-section', 'unknown-code'],
  limit: ['too-many-faces', 'too-many-vertices', 'too-many-bytes'],
};

const CLASS = new Map(Object.entries(REASONS).flatMap(([name, reasons]) => reasons.map((reason) => [reason, name])));

/** The input is bad. `at` is the smallest element to blame, or {} for the whole input. */
class Rejection extends Error {
  constructor(reason, clause, at = {}, detail = '') {
    super(`${reason} [${clause}]`);
    this.reason = reason;
    this.clause = clause;
    this.at = at;
    this.detail = detail;
  }

  get class() {
    return CLASS.get(this.reason);
  }

  form() {
    return { class: this.class, reason: this.reason, at: this.at, clause: this.clause, detail: this.detail };
  }
}

/** The input may be good, but this adapter does not do it: the capability that is missing. */
class Unsupported extends Error {
  constructor(capability) {
    super(capability);
    this.capability = capability;
  }
}

function reject(reason, clause, at, detail) {
  throw new Rejection(reason, clause, at, detail);
}

module.exports = { Rejection, Unsupported, reject };
