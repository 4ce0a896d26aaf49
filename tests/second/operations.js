'use strict';
// The operations of the protocol (ORCL-OP-1 to ORCL-OP-8) and what this adapter says of itself (ORCL-HELLO-2).

const arithmetic = require('./arithmetic.js');
const { bitsFromOutside } = require('./bits.js');
const { checkNumbers } = require('./closings.js');
const codes = require('./codes/index.js');
const { classify } = require('./components.js');
const { decodeFile, encodeFile } = require('./container/file.js');
const { surfaceOf } = require('./face_list.js');
const limits = require('./limits.js');
const { modelFromOutside } = require('./models.js');
const range = require('./range_coder.js');
const rans = require('./rans.js');
const { Unsupported } = require('./rejection.js');
const { decodeStream } = require('./unwind.js');
const { encodeSurface } = require('./walk.js');

const bitString = ({ bytes, length }) => ({ hex: Buffer.from(bytes).toString('hex'), length });
const faceList = (surface) => ({ faces: surface.triangles(), vertices: surface.vertices });
const streamOf = (input) => (
  { word: input.word, records: input.handles, boundaryComponents: input.components_with_boundary });

const CODERS = { arithmetic, range, rans };

function checkSymbols(count) {
  if (count > limits.MAX_SYMBOLS) throw new Unsupported('max_symbols'); // ORCL-SERVE-1
}

function meshOf({ surface, positions }) {
  return positions === null ? faceList(surface) : { ...faceList(surface), positions };
}

/** Each operation takes its input, and `trace`, which is told how to make the entries of a walk (EB-TRACE-1). */
const OPERATIONS = {
  echo: (input) => input,

  'surface.classify': ({ faces, vertices }) => ({ components: classify(surfaceOf(faces, vertices)) }),

  'arithmetic.encode'({ coder, model, symbols }) {
    return bitString(CODERS[coder].encodeMessage(modelFromOutside(model), symbols));
  },

  'arithmetic.decode'({ coder, model, bits, count }) {
    const from = modelFromOutside(model); // ORCL-OP-4: before the bits
    const read = bitsFromOutside(bits.hex, bits.length);
    checkSymbols(count);
    return { symbols: CODERS[coder].decodeMessage(from, read, count) };
  },

  'word.encode'({ faces, vertices }, trace) {
    const encoded = encodeSurface(surfaceOf(faces, vertices));
    trace(() => encoded.trace);
    return {
      word: encoded.word,
      handles: encoded.records,
      components_with_boundary: encoded.boundaryComponents,
      vertex_order: encoded.vertexOrder,
    };
  },

  'word.decode'(input, trace) {
    const surface = decodeStream(streamOf(input));
    trace(() => encodeSurface(surface).trace); // EB-DECODE-1: the same walk
    return faceList(surface);
  },

  'code.encode': (input) => bitString(codes.encodeWord(input.code, streamOf(input))),

  'code.decode'({ code, bits, symbols, components_with_boundary: boundaryComponents, closings }) {
    codes.codeNamed(code);
    checkSymbols(symbols);
    checkNumbers(closings);
    const read = bitsFromOutside(bits.hex, bits.length);
    return { word: codes.decodeWord(code, read, { symbols, boundaryComponents, closings }) };
  },

  'mesh.encode'({ faces, vertices, positions, code, accuracy }) {
    codes.codeNamed(code);
    const surface = surfaceOf(faces, vertices);
    return { hex: Buffer.from(encodeFile(surface, positions, code, accuracy)).toString('hex') };
  },

  'mesh.decode': ({ hex }) => meshOf(decodeFile(hex)),

  'codec.roundtrip'({ faces, vertices, positions }) {
    return meshOf(decodeFile(encodeFile(surfaceOf(faces, vertices), positions, 'golden', { kind: 'exact' })));
  },
};

const INTRODUCTION = {
  protocol: 1,
  name: 'second',
  version: '1.0',
  language: 'javascript',
  ops: Object.keys(OPERATIONS),
  caps: {
    handles: true,
    boundaries: 'many',
    components: true,
    max_faces: limits.MAX_FACES,
    max_symbols: limits.MAX_SYMBOLS,
    trace: ['word.encode', 'word.decode'],
    codes: [...codes.CODES.keys()],
    coders: Object.keys(CODERS),
  },
};

module.exports = { OPERATIONS, INTRODUCTION };
