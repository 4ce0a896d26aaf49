'use strict';
// The section HEAD (FILE-HEAD-1 to FILE-HEAD-3), and what it lets a reader refuse (FILE-LIMIT-2, FILE-SECTION-5).

const { Writer } = require('./writer.js');
const limits = require('../limits.js');
const { reject } = require('../rejection.js');

const CODES = ['plain', 'golden', 'huffman', 'adaptive-1', 'adaptive-3', 'adaptive-6', 'king-rossignac', 'minimax-3',
  'minimax-8', 'context', 'enumerative', 'best'];
const CODINGS = ['none', 'exact-f32', 'exact-f64', 'lattice'];
const FIRST_SECTION = 9; // behind magic and version
const COUNTS = ['faces', 'vertices', 'boundaryComponents', 'symbols', 'records'];

function readHead(sections) {
  if (!sections.has('HEAD')) reject('bad-section', 'FILE-SECTION-5', { byte: FIRST_SECTION });
  const reader = sections.get('HEAD');
  const head = { code: reader.oneOf(CODES), coding: reader.oneOf(CODINGS) };
  const counts = reader.times(COUNTS.length, () => reader.varint(32));
  COUNTS.forEach((count, place) => { head[count] = counts[place]; });
  reader.end();
  const declared = reader.at(reader.start);
  if (Math.max(head.faces, head.symbols) > limits.FACES) reject('too-many-faces', 'FILE-LIMIT-2', declared);
  if (head.vertices > limits.VERTICES) reject('too-many-vertices', 'FILE-LIMIT-2', declared);
  checkPresence(sections, head, reader.bytes.length);
  return head;
}

/** FILE-SECTION-5. Blamed: the end of the file. */
function checkPresence(sections, head, end) {
  const asked = { WORD: true, HAND: head.records !== 0, POSN: head.coding !== 'none' };
  for (const [section, expected] of Object.entries(asked)) {
    if (sections.has(section) !== expected) reject('bad-section', 'FILE-SECTION-5', { byte: end });
  }
}

function writeHead(head) {
  const writer = new Writer();
  writer.oneOf(CODES, head.code);
  writer.oneOf(CODINGS, head.coding);
  for (const count of COUNTS) writer.varint(head[count]);
  return writer.bytes;
}

module.exports = { readHead, writeHead };
