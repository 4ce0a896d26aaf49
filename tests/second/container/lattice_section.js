'use strict';
// The payload of POSN in the coding `lattice` (FILE-POSN-2).

const { Writer } = require('./writer.js');
const { boxOf, checkExponent, quantise, restore } = require('../geometry/lattice.js');
const { withPrecision } = require('../geometry/positions.js');
const { indicesOf, parallelogramCorners, residualsOf } = require('../geometry/prediction.js');
const { decodeResiduals, encodeResiduals } = require('../geometry/residual_code.js');
const { reject } = require('../rejection.js');

const AXES = [0, 1, 2];
const LARGEST = 2n ** 53n;

/** Numbers and bits, which can be read before the surface is known (FILE-PARSE-1). */
function readLattice(reader) {
  const exponent = reader.signed(12);
  const lows = AXES.map(() => reader.bigSigned(54));
  const extents = AXES.map(() => reader.varint(30));
  const bits = reader.bits();
  reader.end();
  return { exponent, lows, extents, bits };
}

function positionsOf({ exponent, lows, extents, bits }, surface) {
  if (exponent < -1074 || exponent > 971) reject('bad-lattice', 'GEOM-LATTICE-1');
  const beyond = (number) => number >= LARGEST || -number >= LARGEST;
  const bad = AXES.some((axis) => beyond(lows[axis]) || beyond(lows[axis] + BigInt(extents[axis])));
  if (bad) reject('bad-lattice', 'GEOM-LATTICE-1');
  const corners = parallelogramCorners(surface);
  const residuals = decodeResiduals(bits, corners, extents);
  const indices = indicesOf(surface, corners, extents, residuals);
  const numbers = indices.map((index, entry) => Number(lows[entry % 3]) + index);
  return withPrecision(restore(numbers, exponent));
}

function writeLattice(surface, coordinates, exponent) {
  checkExponent(exponent);
  const numbers = quantise(coordinates, exponent);
  const { lows, extents } = boxOf(numbers);
  const corners = parallelogramCorners(surface);
  const indices = numbers.map((number, entry) => number - lows[entry % 3]);
  const writer = new Writer();
  writer.signed(exponent);
  for (const low of lows) writer.signed(low);
  for (const extent of extents) writer.varint(extent);
  writer.bits(encodeResiduals(residualsOf(surface, corners, extents, indices), corners, extents));
  return writer.bytes;
}

module.exports = { readLattice, positionsOf, writeLattice };
