'use strict';
// The lattice (GEOM-LATTICE-1 to GEOM-LATTICE-7, GEOM-CHOICE-1, GEOM-CHOICE-2) and its box (GEOM-BOX-1, GEOM-BOX-2).

const { reject } = require('../rejection.js');

const LEAST = -1074;
const GREATEST = 971;
const LARGEST_NUMBER = 2 ** 53;
const AXES = [0, 1, 2];

/** x 2^n, where 2^n alone may be out of range. */
function scaled(x, n) {
  const half = Math.trunc(n / 2);
  return x * 2 ** half * 2 ** (n - half);
}

function checkExponent(exponent) {
  if (exponent < LEAST || exponent > GREATEST) reject('bad-lattice', 'GEOM-LATTICE-1');
}

/** GEOM-LATTICE-5. */
function latticeNumber(x, exponent) {
  const y = scaled(x, -exponent);
  const floor = Math.floor(y);
  return (y - floor >= 0.5 ? floor + 1 : floor) + 0; // -0 + 0 is 0
}

const tooLarge = (number) => !(Math.abs(number) < LARGEST_NUMBER);

function quantise(coordinates, exponent) {
  checkExponent(exponent);
  const numbers = coordinates.map((x) => latticeNumber(x, exponent));
  const bad = numbers.findIndex(tooLarge);
  if (bad >= 0) reject('not-representable', 'GEOM-LATTICE-3', { vertex: Math.floor(bad / 3) });
  return numbers;
}

/** GEOM-LATTICE-4. */
function restore(numbers, exponent) {
  return numbers.map((number) => scaled(number, exponent));
}

/** GEOM-BOX-1: for each axis the least of numbers and the greatest. */
function spans(numbers) {
  return AXES.map((axis) => {
    let [least, greatest] = [Infinity, -Infinity];
    for (let place = axis; place < numbers.length; place += 3) {
      least = Math.min(least, numbers[place]);
      greatest = Math.max(greatest, numbers[place]);
    }
    return [least, greatest];
  });
}

function boxOf(numbers) {
  const ranges = spans(numbers);
  const lows = ranges.map(([low]) => low);
  const extents = ranges.map(([low, high]) => high - low);
  if (extents.some((extent) => extent >= 2 ** 30)) reject('bad-lattice', 'GEOM-BOX-2');
  return { lows, extents };
}

/** GEOM-CHOICE-1. Lattice numbers rise with their coordinates, so the ends of each axis decide. */
function exponentForBits(coordinates, bits) {
  const ranges = spans(coordinates);
  const fits = (exponent) => ranges.every((range) => {
    const [low, high] = range.map((x) => latticeNumber(x, exponent));
    return !tooLarge(low) && !tooLarge(high) && high - low <= 2 ** bits - 1;
  });
  if (bits < 1 || bits > 30) reject('bad-lattice', 'GEOM-CHOICE-1');
  for (let exponent = LEAST; exponent <= GREATEST; exponent += 1) if (fits(exponent)) return exponent;
  return reject('bad-lattice', 'GEOM-CHOICE-1');
}

/** GEOM-CHOICE-2. */
function exponentForBound(bound) {
  if (!(bound > 0 && bound < Infinity)) reject('bad-lattice', 'GEOM-CHOICE-2');
  let exponent = GREATEST;
  while (2 ** (exponent - 1) > bound) exponent -= 1;
  return exponent;
}

module.exports = { checkExponent, quantise, restore, boxOf, exponentForBits, exponentForBound };
