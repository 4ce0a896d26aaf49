'use strict';
// An adapter for the oracle: requests on standard input, replies on standard output, one a line (chapter 9).

const fs = require('node:fs');
const { FormError, INPUTS, count, isObject, plainInteger, text } = require('./forms.js');
const { INTRODUCTION, OPERATIONS } = require('./operations.js');
const { Rejection, Unsupported } = require('./rejection.js');

const PROTOCOL = 1;
const LINE_FEED = 0x0a;
const HELLO = new Map([['protocol', plainInteger], ['spec', text], ['suite', text]]); // ORCL-HELLO-1

/** ORCL-LINE-1. Written at once, so that nothing is left to be flushed. */
function say(reply) {
  const line = Buffer.from(`${JSON.stringify(reply)}\n`, 'utf8');
  for (let sent = 0; sent < line.length; ) {
    try {
      sent += fs.writeSync(1, line, sent);
    } catch (fault) {
      if (fault.code !== 'EAGAIN') throw fault;
    }
  }
}

function checkKeys(request, known) {
  const strange = Object.keys(request).find((key) => !known.includes(key));
  if (strange !== undefined) throw new FormError(`/${strange}: no such key`);
}

/** The terminal reply to a request (ORCL-REPLY-1), without its id. */
function answer(request, id) {
  if (request.op === 'hello') {
    for (const [key, form] of HELLO) form(request[key], `/${key}`);
    checkKeys(request, ['op', 'id', ...HELLO.keys()]);
    return request.protocol === PROTOCOL ? { ok: INTRODUCTION } : { unsupported: { cap: 'protocol' } }; // ORCL-HELLO-3
  }
  if (typeof request.op !== 'string') throw new FormError('a request has an op');
  if (!Object.hasOwn(OPERATIONS, request.op)) return { unsupported: { cap: request.op } }; // ORCL-REPLY-3
  checkKeys(request, ['op', 'id', 'in', 'trace']);
  const wanted = request.trace === 'full';
  if (request.trace !== undefined && !wanted && request.trace !== 'none') throw new FormError('/trace: full or none');
  const input = INPUTS[request.op](request.in, '/in');
  const trace = (entries) => { // ORCL-EVENT-1
    if (wanted) for (const entry of entries()) say({ id, ev: entry });
  };
  return { ok: OPERATIONS[request.op](input, trace) };
}

/** ORCL-REPLY-1 to ORCL-REPLY-4. */
function reply(line) {
  let id = null;
  try {
    const request = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(line));
    if (!isObject(request)) throw new FormError('a request is an object');
    if (request.op === 'bye' && Object.keys(request).length === 1) process.exit(0); // ORCL-BYE-1
    id = count(request.id, '/id');
    if (request.op === 'bye') checkKeys(request, ['op']);
    say({ id, ...answer(request, id) });
  } catch (fault) {
    if (fault instanceof Rejection) say({ id, reject: fault.form() });
    else if (fault instanceof Unsupported) say({ id, unsupported: { cap: fault.capability } });
    else say({ id, error: { message: String(fault.message) } });
  }
}

let parts = [];
process.stdin.on('data', (chunk) => {
  let rest = chunk;
  for (let end = rest.indexOf(LINE_FEED); end >= 0; end = rest.indexOf(LINE_FEED)) {
    const line = Buffer.concat([...parts, rest.subarray(0, end)]);
    parts = [];
    rest = rest.subarray(end + 1);
    reply(line);
  }
  parts.push(rest);
});
// At the end of input the process ends by itself, with exit code 0 (ORCL-BYE-1).
