'use strict';
// Bringing equal keys together by sorting with counts: linear time whatever the keys (CPLX-INPUT-2).

const { next, previous } = require('./corners.js');

const DIGIT = 13; // binary digits in one pass

/**
 * One pass: the places in an order, put in order by a digit of their keys; equal digits keep their order. The keys are
 * below `size`: of few there are few digits.
 */
function sortByDigit(order, keys, shift, size) {
  const mask = 2 ** DIGIT - 1;
  const values = Math.min(mask, (size - 1) >> shift) + 1;
  const starts = new Int32Array(values + 1);
  for (let place = 0; place < keys.length; place += 1) starts[((keys[place] >> shift) & mask) + 1] += 1;
  for (let value = 0; value < values; value += 1) starts[value + 1] += starts[value];
  const sorted = new Int32Array(order.length);
  for (let rank = 0; rank < order.length; rank += 1) {
    const digit = (keys[order[rank]] >> shift) & mask;
    sorted[starts[digit]] = order[rank];
    starts[digit] += 1;
  }
  return sorted;
}

/**
 * Calls `visit(sorted, start, stop)` for each group of places that agree in all columns of keys. The keys are below
 * `size`. Within a group the places are in increasing order.
 */
function forEachGroup(columns, size, visit) {
  const count = columns[0].length;
  let sorted = new Int32Array(count);
  for (let place = 0; place < count; place += 1) sorted[place] = place;
  for (const keys of columns) {
    for (let shift = 0; 2 ** shift < size; shift += DIGIT) sorted = sortByDigit(sorted, keys, shift, size);
  }
  const alike = (one, other) => {
    for (const keys of columns) if (keys[one] !== keys[other]) return false;
    return true;
  };
  let start = 0;
  for (let stop = 1; stop <= count; stop += 1) {
    if (stop < count && alike(sorted[stop], sorted[start])) continue;
    visit(sorted, start, stop);
    start = stop;
  }
}

/** Groups of faces that have the same three vertices, in whatever order. */
function forEachTriangle(vertex, vertices, visit) {
  const faces = vertex.length / 3;
  const columns = [0, 1, 2].map(() => new Int32Array(faces));
  for (let face = 0; face < faces; face += 1) {
    const [a, b, c] = [vertex[3 * face], vertex[3 * face + 1], vertex[3 * face + 2]];
    columns[0][face] = Math.max(a, b, c);
    columns[2][face] = Math.min(a, b, c);
    columns[1][face] = a + b + c - columns[0][face] - columns[2][face];
  }
  forEachGroup(columns, vertices, visit);
}

/** Groups of corners whose edges have the same two ends: one is a border edge, two an inner one, three a fault. */
function forEachEdge(vertex, vertices, visit) {
  const columns = [0, 1].map(() => new Int32Array(vertex.length));
  for (let corner = 0; corner < vertex.length; corner += 1) {
    const [tail, head] = [vertex[next(corner)], vertex[previous(corner)]];
    columns[0][corner] = Math.max(tail, head);
    columns[1][corner] = Math.min(tail, head);
  }
  forEachGroup(columns, vertices, visit);
}

module.exports = { forEachEdge, forEachTriangle };
