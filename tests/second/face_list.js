'use strict';
// From a face list to a surface (CPLX-INPUT-1 to CPLX-INPUT-4). The rejections are tried in their order.

const { BORDER, Surface, faceOf, forEachCornerAround, next, previous } = require('./corners.js');
const { forEachEdge, forEachTriangle } = require('./grouping.js');
const limits = require('./limits.js');
const { reject } = require('./rejection.js');

function surfaceOf(faces, vertices) {
  if (faces.length === 0) reject('empty-mesh', 'CPLX-REJECT-1');
  if (faces.length > limits.FACES) reject('too-many-faces', 'CPLX-REJECT-2');
  if (vertices > limits.VERTICES) reject('too-many-vertices', 'CPLX-REJECT-2');
  const vertex = vertexTable(faces, vertices);
  rejectRepeatedIndices(vertex);
  rejectDuplicateFaces(vertex, vertices);
  const surface = new Surface(vertex, oppositeTable(vertex, vertices), vertices);
  rejectPinchedAndIsolated(surface);
  return surface;
}

function vertexTable(faces, vertices) {
  const vertex = new Int32Array(3 * faces.length);
  for (let face = 0; face < faces.length; face += 1) {
    for (let place = 0; place < 3; place += 1) {
      const index = faces[face][place];
      if (index < 0 || index >= vertices) reject('index-out-of-range', 'CPLX-REJECT-3', { face });
      vertex[3 * face + place] = index;
    }
  }
  return vertex;
}

function rejectRepeatedIndices(vertex) {
  for (let corner = 0; corner < vertex.length; corner += 3) {
    const [a, b, c] = [vertex[corner], vertex[corner + 1], vertex[corner + 2]];
    if (a === b || b === c || c === a) reject('repeated-index', 'CPLX-REJECT-4', { face: faceOf(corner) });
  }
}

function rejectDuplicateFaces(vertex, vertices) {
  let lowest = Infinity;
  forEachTriangle(vertex, vertices, (faces, start, stop) => {
    if (stop - start > 1) lowest = Math.min(lowest, faces[start + 1]);
  });
  if (lowest < Infinity) reject('duplicate-face', 'CPLX-REJECT-5', { face: lowest });
}

function oppositeTable(vertex, vertices) {
  const opposite = new Int32Array(vertex.length).fill(BORDER);
  let third = Infinity;
  let second = Infinity;
  forEachEdge(vertex, vertices, (corners, start, stop) => {
    if (stop - start > 2) third = Math.min(third, corners[start + 2]);
    if (stop - start !== 2) return;
    const [one, other] = [corners[start], corners[start + 1]];
    if (vertex[next(one)] === vertex[next(other)]) second = Math.min(second, other);
    opposite[one] = other;
    opposite[other] = one;
  });
  const blamed = (corner) => (
    { face: faceOf(corner), tail: vertex[next(corner)], head: vertex[previous(corner)] });
  if (third < Infinity) reject('edge-with-three-faces', 'CPLX-REJECT-6', blamed(third));
  if (second < Infinity) reject('edge-twice-in-one-direction', 'CPLX-REJECT-7', blamed(second));
  return opposite;
}

/** The fan of a corner at each vertex must hold all corners of the vertex (CPLX-SURFACE-3). */
function rejectPinchedAndIsolated({ vertex, opposite, vertices }) {
  const valence = new Int32Array(vertices);
  const first = new Int32Array(vertices).fill(-1);
  for (let corner = vertex.length - 1; corner >= 0; corner -= 1) {
    valence[vertex[corner]] += 1;
    first[vertex[corner]] = corner;
  }
  for (let place = 0; place < vertices; place += 1) {
    if (first[place] < 0) continue;
    let fan = 0;
    forEachCornerAround(opposite, first[place], () => { fan += 1; });
    if (fan < valence[place]) reject('pinched-vertex', 'CPLX-REJECT-8', { vertex: place });
  }
  const isolated = first.indexOf(-1);
  if (isolated >= 0) reject('isolated-vertex', 'CPLX-REJECT-9', { vertex: isolated });
}

module.exports = { surfaceOf };
