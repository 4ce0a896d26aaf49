'use strict';
// Prediction and residuals (GEOM-PREDICT-1, GEOM-PREDICT-2, GEOM-RESIDUAL-1, GEOM-RESIDUAL-2).

const { BORDER, next, previous } = require('../corners.js');
const { reject } = require('../rejection.js');

const AXES = [0, 1, 2];
const NONE = -1;

/** GEOM-PREDICT-1: the parallelogram corner of each vertex, or -1. */
function parallelogramCorners({ vertex, opposite, vertices }) {
  const corners = new Int32Array(vertices).fill(NONE);
  for (let corner = 0; corner < vertex.length; corner += 1) {
    const tip = vertex[corner];
    if (corners[tip] !== NONE || opposite[corner] === BORDER) continue;
    const [a, b, o] = [vertex[next(corner)], vertex[previous(corner)], vertex[opposite[corner]]];
    if (a < tip && b < tip && o < tip) corners[tip] = corner;
  }
  return corners;
}

/** GEOM-PREDICT-2, on one axis, from the indices of lower vertices. */
function predicted({ vertex, opposite }, corner, place, axis, indices, extent) {
  if (corner === NONE) return place === 0 ? 0 : indices[3 * (place - 1) + axis];
  const index = (at) => indices[3 * vertex[at] + axis];
  const fourth = index(next(corner)) + index(previous(corner)) - index(opposite[corner]);
  return Math.min(Math.max(fourth, 0), extent);
}

function residualsOf(surface, corners, extents, indices) {
  return indices.map((index, entry) => {
    const [place, axis] = [Math.floor(entry / 3), entry % 3];
    return index - predicted(surface, corners[place], place, axis, indices, extents[axis]);
  });
}

function indicesOf(surface, corners, extents, residuals) {
  const indices = [];
  residuals.forEach((residual, entry) => {
    const [place, axis] = [Math.floor(entry / 3), entry % 3];
    const index = residual + predicted(surface, corners[place], place, axis, indices, extents[axis]);
    if (index < 0 || index > extents[axis]) reject('bad-residual', 'GEOM-RESIDUAL-2', { vertex: place });
    indices.push(index);
  });
  for (const axis of AXES) {
    const onAxis = (value) => indices.some((index, entry) => entry % 3 === axis && index === value);
    if (!onAxis(0) || !onAxis(extents[axis])) reject('bad-residual', 'GEOM-RESIDUAL-2');
  }
  return indices;
}

module.exports = { NONE, parallelogramCorners, residualsOf, indicesOf };
