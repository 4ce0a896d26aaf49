'use strict';
// The forms of messages (ORCL-LINE-3): what the JSON Schema says, as functions from a JSON value to a value.
// A value of another form is no request, and is answered by `error` (ORCL-REPLY-4).

class FormError extends Error {}

function wrong(path, expected) {
  throw new FormError(`${path || 'the message'}: expected ${expected}`);
}

const LARGEST = 2 ** 53;
const DIGITS = /^-?[1-9][0-9]{15,999}$/;

/** ORCL-VALUE-1: a JSON number, or beyond 2^53 a string of digits, which becomes a BigInt. */
function integer(value, path) {
  if (Number.isInteger(value) && Math.abs(value) <= LARGEST) return value + 0; // -0 + 0 is 0
  if (typeof value === 'string' && DIGITS.test(value)) {
    const big = BigInt(value);
    return big >= -BigInt(LARGEST) && big <= BigInt(LARGEST) ? Number(big) : big;
  }
  return wrong(path, 'an integer');
}

/** A number of things: no string, not negative. */
function count(value, path) {
  return Number.isInteger(value) && value >= 0 && value <= LARGEST ? value + 0 : wrong(path, 'a number from 0 to 2^53');
}

/** A small integer that is never written as a string. */
function plainInteger(value, path) {
  return Number.isInteger(value) && Math.abs(value) <= LARGEST ? value + 0 : wrong(path, 'an integer');
}

function number(value, path) {
  return typeof value === 'number' ? value : wrong(path, 'a number');
}

/** How far a coordinate may move (ORCL-CODEC-1). */
function bound(value, path) {
  return typeof value === 'number' && value >= 0 ? value : wrong(path, 'a number that is not negative');
}

function text(value, path) {
  return typeof value === 'string' ? value : wrong(path, 'a string');
}

function oneOf(...choices) {
  return (value, path) => (choices.includes(value) ? value : wrong(path, `one of ${choices.join(', ')}`));
}

/** ORCL-VALUE-2: bytes are lowercase hexadecimal digits, two a byte. */
function bytes(value, path) {
  if (typeof value !== 'string' || !/^(?:[0-9a-f]{2})*$/.test(value)) return wrong(path, 'hexadecimal digits');
  return new Uint8Array(Buffer.from(value, 'hex'));
}

function list(form) {
  return (value, path) =>
    Array.isArray(value) ? value.map((entry, place) => form(entry, `${path}/${place}`)) : wrong(path, 'a list');
}

function isObject(value) {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** An object with these keys and no others. A default makes a key optional. */
function object(fields, defaults = {}) {
  return (value, path) => {
    if (!isObject(value)) return wrong(path, 'an object');
    const result = {};
    for (const key of Object.keys(value)) {
      if (!Object.hasOwn(fields, key)) wrong(`${path}/${key}`, 'no such key');
      result[key] = fields[key](value[key], `${path}/${key}`);
    }
    for (const key of Object.keys(fields)) {
      if (Object.hasOwn(result, key)) continue;
      if (!Object.hasOwn(defaults, key)) wrong(`${path}/${key}`, 'this key');
      result[key] = defaults[key];
    }
    return result;
  };
}

/** Objects of several kinds, told apart by the value of one key. */
function byKind(kinds) {
  return (value, path) => {
    if (!isObject(value) || !Object.hasOwn(kinds, value.kind)) return wrong(path, `one of ${Object.keys(kinds)}`);
    return kinds[value.kind](value, path);
  };
}

function triple(value, path) {
  return Array.isArray(value) && value.length === 3 ? list(integer)(value, path) : wrong(path, 'three vertices');
}

const any = (value) => value;
const anyObject = (value, path) => (isObject(value) ? value : wrong(path, 'an object'));

const bits = object({ hex: bytes, length: count });
const connectivity = { faces: list(triple), vertices: integer };
const positions = object({ precision: oneOf('f32', 'f64'), coordinates: list(number) });
const sides = oneOf('left', 'right');
const kinds = oneOf('boundary', 'handle');
const handle = object({ kind: kinds, s: integer, at: integer, side: sides });
const closing = object({ passed: integer, kind: kinds, side: sides, between: integer });
const stream = { word: text, handles: list(handle), components_with_boundary: integer };

const model = byKind({
  static: object({ kind: any, frequencies: list(integer) }),
  uniform: object({ kind: any, size: integer }),
  adaptive: object({ kind: any, frequencies: list(integer), increment: integer, limit: integer }),
});
const coder = oneOf('arithmetic', 'range', 'rans');

const accuracy = byKind({
  exact: object({ kind: any }),
  lattice: object({ kind: any, exponent: plainInteger }),
  bits: object({ kind: any, bits: plainInteger }),
  error: object({ kind: any, bound: number }),
});

/** The form of `in` for each operation (ORCL-OP-1 to ORCL-OP-8). */
const INPUTS = {
  echo: anyObject,
  'surface.classify': object(connectivity),
  'arithmetic.encode': object({ coder, model, symbols: list(integer) }),
  'arithmetic.decode': object({ coder, model, bits, count }),
  'word.encode': object(connectivity),
  'word.decode': object(stream),
  'code.encode': object({ ...stream, code: text }),
  'code.decode': object(
    { code: text, bits, symbols: count, components_with_boundary: count, closings: list(closing) },
    { closings: [] },
  ),
  'mesh.encode': object({ ...connectivity, positions, code: text, accuracy }, { positions: null }),
  'mesh.decode': object({ hex: bytes }),
  'codec.roundtrip': object({ ...connectivity, positions, error: list(bound) }, { positions: null, error: null }),
};

module.exports = { FormError, INPUTS, count, isObject, plainInteger, text };
