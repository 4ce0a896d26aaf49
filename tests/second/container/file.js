'use strict';
// A file and its mesh (FILE-PARSE-1, FILE-OPTION-1).

const { closingsOf, decodeClosings, encodeClosings, recordsOf } = require('../closings.js');
const codes = require('../codes/index.js');
const { exponentForBits, exponentForBound, quantise } = require('../geometry/lattice.js');
const { checkPositions, inOrder, readExact, writeExact } = require('../geometry/positions.js');
const { reject } = require('../rejection.js');
const { decodeStream } = require('../unwind.js');
const { encodeSurface } = require('../walk.js');
const { readHead, writeHead } = require('./head.js');
const { positionsOf, readLattice, writeLattice } = require('./lattice_section.js');
const { readSections, writeSections } = require('./sections.js');
const { Writer } = require('./writer.js');

/** From bytes to a surface and its positions, or null. The order of checks is that of FILE-PARSE-1. */
function decodeFile(bytes) {
  const sections = readSections(bytes);
  const head = readHead(sections);
  const handBits = head.records === 0 ? null : bitsOf(sections.get('HAND'));
  const wordBits = bitsOf(sections.get('WORD'));
  const code = codes.codeNamed(head.code);
  const startOf = (tag) => sections.get(tag).at(sections.get(tag).start);
  if (head.symbols > code.mostSymbols(wordBits.length)) reject('impossible-count', 'FILE-COUNT-2', startOf('WORD'));
  if (head.records > head.symbols) reject('impossible-count', 'FILE-COUNT-1', startOf('HAND'));
  const closings = handBits === null ? [] : decodeClosings(handBits, head.records, head.symbols);
  const word = codes.decodeWord(head.code, wordBits, { ...head, closings });
  const records = recordsOf(word, closings);
  const stored = readStored(sections.get('POSN'), head);
  const surface = decodeStream({ word, records, boundaryComponents: head.boundaryComponents });
  if (surface.faces !== head.faces || surface.vertices !== head.vertices) reject('count-mismatch', 'FILE-COUNT-3');
  return { surface, positions: head.coding === 'lattice' ? positionsOf(stored, surface) : stored };
}

/** FILE-HAND-1, FILE-WORD-1: payloads that are bits. */
function bitsOf(reader) {
  const bits = reader.bits();
  reader.end();
  return bits;
}

/** POSN as far as it can be read without the surface. */
function readStored(reader, { coding, vertices }) {
  switch (coding) {
    case 'none': return null;
    case 'exact-f32': return readExact(reader, 'f32', vertices);
    case 'exact-f64': return readExact(reader, 'f64', vertices);
    default: return readLattice(reader);
  }
}

/** From a mesh to the bytes of its file. */
function encodeFile(surface, positions, codeName, accuracy) {
  if (positions !== null) checkPositions(positions, surface.vertices);
  const stream = encodeSurface(surface);
  const [coding, posn] = storedForm(stream, positions, accuracy); // ORCL-OP-7: before the code
  const word = codes.encodeWord(codeName, stream);
  const head = { code: codeName, coding, faces: surface.faces, vertices: surface.vertices,
    boundaryComponents: stream.boundaryComponents, symbols: stream.word.length, records: stream.records.length };
  const payloads = [['HEAD', writeHead(head)]];
  if (head.records > 0) {
    payloads.push(['HAND', payloadOf(encodeClosings(closingsOf(stream.word, stream.records), head.symbols))]);
  }
  payloads.push(['WORD', payloadOf(word)]);
  if (posn !== null) payloads.push(['POSN', posn]);
  return writeSections(payloads);
}

function payloadOf(bits) {
  const writer = new Writer();
  writer.bits(bits);
  return writer.bytes;
}

/** FILE-OPTION-1. */
function storedForm(stream, positions, accuracy) {
  if (positions === null) return ['none', null];
  const stored = inOrder(positions, stream.vertexOrder);
  if (accuracy.kind === 'exact') return [`exact-${stored.precision}`, writeExact(stored)];
  const exponent = exponentFor(positions.coordinates, accuracy);
  quantise(positions.coordinates, exponent); // GEOM-LATTICE-3 blames a vertex of the mesh that was given
  const created = decodeStream(stream); // GEOM-ORDER-3
  return ['lattice', writeLattice(created, stored.coordinates, exponent)];
}

function exponentFor(coordinates, accuracy) {
  switch (accuracy.kind) {
    case 'bits': return exponentForBits(coordinates, accuracy.bits);
    case 'error': return exponentForBound(accuracy.bound);
    default: return accuracy.exponent;
  }
}

module.exports = { decodeFile, encodeFile };
