'use strict';
// What can be seen of a stream without undoing it (EB-GRAMMAR-1 to EB-GRAMMAR-4).

const limits = require('./limits.js');
const { reject } = require('./rejection.js');

const CLOSES = { right: 'RE', left: 'LE' }; // EB-HANDLE-4: the symbols whose edge of this side is closed

/**
 * Scans a stream forwards. Answers with, for each symbol, its component and the record it opens (or -1), for each
 * record the place of its closing symbol, and for each component the place where it begins.
 */
function scan({ word, records, boundaryComponents }) {
  if (word.length > limits.FACES) reject('too-many-faces', 'EB-DECODE-2'); // before anything else
  if (word.length === 0) reject('empty-word', 'EB-GRAMMAR-1');
  const unknown = word.search(/[^CLERS]/);
  if (unknown >= 0) reject('unknown-symbol', 'EB-GRAMMAR-1', { symbol: unknown });

  const splits = [];
  const closers = [];
  for (let place = 0; place < word.length; place += 1) {
    if (word[place] === 'S') splits.push(place);
    else if (word[place] !== 'C') closers.push(place);
  }
  checkOrder(records, splits.length);
  const recordAt = new Int32Array(word.length).fill(-1);
  records.forEach(({ s }, place) => { recordAt[splits[s]] = place; });

  const { componentOf, starts } = componentsOf(word, recordAt);
  if (boundaryComponents < 0 || boundaryComponents > starts.length) reject('too-few-components', 'EB-GRAMMAR-3');

  const closerOf = checkClosers({ word, records, boundaryComponents, splits, closers, componentOf });
  return { componentOf, starts, recordAt, closerOf };
}

/** EB-GRAMMAR-2. */
function checkOrder(records, splits) {
  records.forEach(({ s }, record) => {
    if (record > 0 && s <= records[record - 1].s) reject('record-order', 'EB-GRAMMAR-2', { record });
  });
  records.forEach(({ s }, record) => {
    if (s < 0 || s >= splits) reject('record-out-of-range', 'EB-GRAMMAR-2', { record });
  });
}

/** EB-GRAMMAR-3: where components begin and end. */
function componentsOf(word, recordAt) {
  const componentOf = new Int32Array(word.length);
  const starts = [];
  let open = 0;
  for (let place = 0; place < word.length; place += 1) {
    if (open === 0) {
      starts.push(place);
      open = 1;
    }
    componentOf[place] = starts.length - 1;
    if (word[place] === 'S' && recordAt[place] < 0) open += 1;
    if (word[place] === 'E') open -= 1;
  }
  if (open > 0) reject('unfinished-word', 'EB-GRAMMAR-3', { symbol: word.length - 1 });
  return { componentOf, starts };
}

/** EB-GRAMMAR-4. Answers with the place of each record's closing symbol. */
function checkClosers({ word, records, boundaryComponents, splits, closers, componentOf }) {
  const taken = new Uint8Array(2 * closers.length); // the right and the left edge of each closing triangle
  return records.map(({ kind, s, at, side }, record) => {
    const blamed = { record };
    if (at < 0 || at >= closers.length) reject('record-out-of-range', 'EB-GRAMMAR-4', blamed);
    const closer = closers[at];
    if (!CLOSES[side].includes(word[closer])) reject('record-side', 'EB-GRAMMAR-4', blamed);
    if (closer < splits[s]) reject('record-outside-branch', 'EB-GRAMMAR-4', blamed);
    if (kind === 'boundary' && componentOf[splits[s]] >= boundaryComponents) {
      reject('not-a-curve', 'EB-GRAMMAR-4', blamed);
    }
    const edge = 2 * at + (side === 'left' ? 1 : 0);
    if (taken[edge]) reject('edge-closed-twice', 'EB-GRAMMAR-4', blamed);
    taken[edge] = 1;
    return closer;
  });
}

module.exports = { scan };
