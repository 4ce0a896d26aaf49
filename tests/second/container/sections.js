'use strict';
// The file as sealed sections (FILE-MAGIC-1 to FILE-SECTION-4).

const { crc32 } = require('./crc32.js');
const { Reader } = require('./reader.js');
const { Writer } = require('./writer.js');
const limits = require('../limits.js');
const { reject } = require('../rejection.js');

const MAGIC = [0x89, 0x43, 0x4c, 0x45, 0x52, 0x53, 0x0d, 0x0a];
const VERSION = 1;
const TAGS = ['HEAD', 'HAND', 'WORD', 'POSN']; // FILE-SECTION-3
const HEADER = 8;

/** The payloads by tag, each a reader of its bytes. The order of checks is that of FILE-PARSE-1. */
function readSections(bytes) {
  if (bytes.length > limits.BYTES) reject('too-many-bytes', 'FILE-LIMIT-1');
  const file = new Reader(bytes, 0, bytes.length);
  readMagic(file);
  const sections = new Map();
  let last = -1;
  while (file.left > 0) {
    const start = file.offset;
    const tag = Buffer.from(file.raw(4)).toString('latin1');
    const length = file.u32();
    checkSeal(file, bytes.subarray(start, start + HEADER));
    const place = TAGS.indexOf(tag);
    if (place < 0) reject('unknown-section', 'FILE-SECTION-3', { byte: start });
    if (place <= last) reject('bad-section', 'FILE-SECTION-4', { byte: start });
    last = place;
    const payload = file.offset;
    file.section = tag;
    checkSeal(file, file.raw(length));
    file.section = undefined;
    sections.set(tag, new Reader(bytes, payload, payload + length, tag));
  }
  return sections;
}

function readMagic(file) {
  const magic = file.raw(MAGIC.length);
  if (MAGIC.some((byte, place) => magic[place] !== byte)) reject('bad-magic', 'FILE-MAGIC-1', { byte: 0 });
  const byte = file.offset;
  if (file.u8() !== VERSION) reject('unknown-version', 'FILE-MAGIC-2', { byte });
}

/** FILE-SECTION-2. */
function checkSeal(file, sealed) {
  const start = file.offset;
  if (file.u32() !== crc32(sealed)) reject('bad-checksum', 'FILE-SECTION-2', file.at(start));
}

/** The bytes of a file, from payloads by tag in their order. */
function writeSections(payloads) {
  const file = new Writer();
  file.raw(MAGIC);
  file.u8(VERSION);
  for (const [tag, payload] of payloads) {
    const header = new Writer();
    header.raw(Buffer.from(tag, 'latin1'));
    header.u32(payload.length);
    file.raw(header.bytes);
    file.u32(crc32(header.bytes));
    file.raw(payload);
    file.u32(crc32(payload));
  }
  return Uint8Array.from(file.bytes);
}

module.exports = { readSections, writeSections };
