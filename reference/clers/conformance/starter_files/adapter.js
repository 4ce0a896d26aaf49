// An adapter to begin with: it does `echo`, and says so of nothing else.
//
// One request a line comes on standard input, one reply a line goes to standard output; print
// anything else with console.error. What the operations take and give: spec/09-conformance.md.
"use strict";

const PROTOCOL = 1;

const HELLO = {
  protocol: PROTOCOL,
  name: "my mesh library",
  version: "0.1",
  language: "javascript",
  ops: ["echo"], // then "word.decode", …
  caps: {
    handles: false,
    boundaries: "none", // or "one", or "many"
    components: false,
    max_faces: 1000000,
    max_symbols: 1000000,
  },
};

/** One of ok, reject, unsupported, error. */
function answer(request) {
  switch (request.op) {
    case "hello":
      return request.protocol === PROTOCOL ? { ok: HELLO } : { unsupported: { cap: "protocol" } };
    case "echo":
      return { ok: request.in };
    // Here your operations join. Bad input is
    //   { reject: { class: "malformed", reason: "…" } }    (or "invalid", "unsupported", "limit")
    default:
      return { unsupported: { cap: request.op } };
  }
}

const lines = require("node:readline").createInterface({ input: process.stdin });
lines.on("line", (line) => {
  const request = JSON.parse(line);
  if (request.op === "bye") {
    lines.close();
    process.stdin.destroy();
    return;
  }
  process.stdout.write(JSON.stringify({ id: request.id, ...answer(request) }) + "\n");
});
