'use strict';
// Residuals in bits (GEOM-CODE-1 to GEOM-CODE-5).

const { Decoder, Encoder } = require('../arithmetic.js');
const { Adaptive } = require('../models.js');
const { NONE } = require('./prediction.js');

const digits = (number) => (number === 0 ? 0 : number.toString(2).length);
const fold = (residual) => (residual >= 0 ? 2 * residual : -2 * residual - 1);
const unfold = (folded) => (folded % 2 === 0 ? folded / 2 : -(folded + 1) / 2);

/** GEOM-CODE-2: for an axis and whether a vertex has a parallelogram. */
function classModels(extents) {
  const fresh = (extent) => new Adaptive(new Array(digits(2 * extent) + 1).fill(1), 8, 2 ** 13);
  const models = extents.map((extent) => [fresh(extent), fresh(extent)]);
  return (axis, corner) => models[axis][corner === NONE ? 0 : 1];
}

/** GEOM-CODE-3. */
function encodeResiduals(residuals, corners, extents) {
  const encoder = new Encoder();
  const modelFor = classModels(extents);
  residuals.forEach((residual, entry) => {
    const folded = fold(residual);
    const size = digits(folded);
    encoder.put(modelFor(entry % 3, corners[Math.floor(entry / 3)]), size);
    if (size >= 2) encoder.putRaw(size - 1, folded - 2 ** (size - 1));
  });
  return encoder.done();
}

function decodeResiduals(bits, corners, extents) {
  const decoder = new Decoder(bits);
  const modelFor = classModels(extents);
  const residuals = [];
  while (residuals.length < 3 * corners.length) {
    const entry = residuals.length;
    const size = decoder.take(modelFor(entry % 3, corners[Math.floor(entry / 3)]));
    const folded = size < 2 ? size : 2 ** (size - 1) + decoder.takeRaw(size - 1);
    residuals.push(unfold(folded));
  }
  decoder.finish();
  return residuals;
}

module.exports = { encodeResiduals, decodeResiduals };
