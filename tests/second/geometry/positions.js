'use strict';
// Positions from outside (GEOM-POSITION-1 to GEOM-POSITION-5), and exact ones in bytes (GEOM-EXACT-1, GEOM-EXACT-2).

const { reject } = require('../rejection.js');

const isBinary32 = (number) => Object.is(Math.fround(number), number);
const vertexOf = (place) => ({ vertex: Math.floor(place / 3) });
const WIDTH = { f32: 4, f64: 8 };

/** GEOM-POSITION-2 to GEOM-POSITION-4, GEOM-MESH-1. */
function checkPositions({ precision, coordinates }, vertices) {
  if (coordinates.length !== 3 * vertices) reject('count-mismatch', 'GEOM-POSITION-2');
  rejectNonFinite(coordinates);
  const bad = precision === 'f32' ? coordinates.findIndex((number) => !isBinary32(number)) : -1;
  if (bad >= 0) reject('not-representable', 'GEOM-POSITION-4', vertexOf(bad));
}

function rejectNonFinite(coordinates) {
  const bad = coordinates.findIndex((number) => !Number.isFinite(number));
  if (bad >= 0) reject('non-finite-coordinate', 'GEOM-POSITION-3', vertexOf(bad));
}

/** GEOM-POSITION-5. */
function withPrecision(coordinates) {
  return { precision: coordinates.every(isBinary32) ? 'f32' : 'f64', coordinates };
}

/** GEOM-ORDER-1. */
function inOrder({ precision, coordinates }, order) {
  return { precision, coordinates: order.flatMap((vertex) => coordinates.slice(3 * vertex, 3 * vertex + 3)) };
}

function writeExact({ precision, coordinates }) {
  const width = WIDTH[precision];
  const view = new DataView(new ArrayBuffer(width * coordinates.length));
  coordinates.forEach((number, place) => {
    if (precision === 'f32') view.setFloat32(width * place, number, true);
    else view.setFloat64(width * place, number, true);
  });
  return new Uint8Array(view.buffer);
}

/** FILE-POSN-1, GEOM-POSITION-3. */
function readExact(reader, precision, vertices) {
  const width = WIDTH[precision];
  if (reader.left !== 3 * width * vertices) reject('count-mismatch', 'GEOM-EXACT-2');
  const bytes = reader.raw(reader.left);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const coordinates = Array.from({ length: 3 * vertices }, (_, place) =>
    (precision === 'f32' ? view.getFloat32(width * place, true) : view.getFloat64(width * place, true)));
  rejectNonFinite(coordinates);
  return { precision, coordinates };
}

module.exports = { checkPositions, withPrecision, inOrder, readExact, writeExact };
