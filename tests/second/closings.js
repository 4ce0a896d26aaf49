'use strict';
// The handle data as it is met from the end of the word (CODE-HAND-1 to CODE-HAND-5).

const { Decoder, Encoder } = require('./arithmetic.js');
const { addHalf } = require('./models.js');
const { reject } = require('./rejection.js');

const SIDE_SYMBOLS = { right: 'RE', left: 'LE' };
const KINDS = ['handle', 'boundary'];
const SIDES = ['right', 'left'];

/** The places in a word of the symbols whose triangle has a closed edge on a side. */
function edgesOf(word, side) {
  return placesOf(word, SIDE_SYMBOLS[side]);
}

function placesOf(word, symbols) {
  const places = [];
  for (let place = 0; place < word.length; place += 1) if (symbols.includes(word[place])) places.push(place);
  return places;
}

/** How many of some increasing places are less than one. */
function placesBefore(places, limit) {
  let low = 0;
  let high = places.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (places[middle] < limit) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** CODE-HAND-1, CODE-HAND-2: from records, by increasing s, to closings, the last record first. */
function closingsOf(word, records) {
  const splits = placesOf(word, 'S');
  const closers = placesOf(word, 'RLE');
  const edges = { right: edgesOf(word, 'right'), left: edgesOf(word, 'left') };
  const closings = [];
  let splitAfter = splits.length; // the S of the record met before, going backwards
  for (let record = records.length - 1; record >= 0; record -= 1) {
    const { kind, s, at, side } = records[record];
    const good = s >= 0 && s < splitAfter && at >= 0 && at < closers.length
      && SIDE_SYMBOLS[side].includes(word[closers[at]]) && closers[at] > splits[s];
    if (!good) reject('not-representable', 'CODE-HAND-2', { record });
    const between = placesBefore(edges[side], closers[at]) - placesBefore(edges[side], splits[s]);
    closings.push({ passed: splitAfter - 1 - s, kind, side, between });
    splitAfter = s;
  }
  return closings;
}

/** CODE-HAND-3: the numbers of closings, before anything is known of the word (ORCL-OP-6). */
function checkNumbers(closings) {
  const place = closings.findIndex(({ passed, between }) => passed < 0 || between < 0);
  if (place >= 0) reject('record-out-of-range', 'CODE-HAND-3', { record: closings.length - 1 - place });
}

/** CODE-HAND-3: from closings back to records, by increasing s. */
function recordsOf(word, closings) {
  const splits = placesOf(word, 'S');
  const closers = placesOf(word, 'RLE');
  const edges = { right: edgesOf(word, 'right'), left: edgesOf(word, 'left') };
  const records = [];
  let s = splits.length;
  closings.forEach(({ passed, kind, side, between }, place) => {
    const blamed = { record: closings.length - 1 - place };
    if (passed < 0 || passed >= s) reject('record-out-of-range', 'CODE-HAND-3', blamed);
    s -= passed + 1;
    const first = placesBefore(edges[side], splits[s]);
    if (between < 0 || between >= edges[side].length - first) reject('record-out-of-range', 'CODE-HAND-3', blamed);
    const at = placesBefore(closers, edges[side][first + between]);
    records.push({ kind, s, at, side });
  });
  return records.reverse();
}

/** CODE-HAND-4: the four fields' models, for a word of so many symbols. */
function modelsFor(symbols) {
  const sizes = symbols.toString(2).length;
  return { passed: addHalf(sizes), kind: addHalf(2), side: addHalf(2), between: addHalf(sizes) };
}

function putNumber(encoder, model, number) {
  const size = Math.floor(Math.log2(number + 1));
  encoder.put(model, size);
  encoder.putRaw(size, number + 1 - 2 ** size);
}

function takeNumber(decoder, model) {
  const size = decoder.take(model);
  return 2 ** size + decoder.takeRaw(size) - 1;
}

function encodeClosings(closings, symbols) {
  const encoder = new Encoder();
  const models = modelsFor(symbols);
  for (const { passed, kind, side, between } of closings) {
    putNumber(encoder, models.passed, passed);
    encoder.put(models.kind, KINDS.indexOf(kind));
    encoder.put(models.side, SIDES.indexOf(side));
    putNumber(encoder, models.between, between);
  }
  return encoder.done();
}

/** CODE-HAND-5: strict. */
function decodeClosings(bits, count, symbols) {
  const decoder = new Decoder(bits);
  const models = modelsFor(symbols);
  const closings = [];
  while (closings.length < count) {
    const passed = takeNumber(decoder, models.passed);
    const kind = KINDS[decoder.take(models.kind)];
    const side = SIDES[decoder.take(models.side)];
    closings.push({ passed, kind, side, between: takeNumber(decoder, models.between) });
  }
  decoder.finish();
  return closings;
}

module.exports = { checkNumbers, closingsOf, recordsOf, encodeClosings, decodeClosings };
