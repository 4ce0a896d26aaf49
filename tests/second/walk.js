'use strict';
// Edgebreaker's walk: from a surface to its word and handle data (chapter 5).

const { BORDER, curveFrom, faceOf, next, previous } = require('./corners.js');

class Walk {
  constructor(surface) {
    this.surface = surface;
    this.borderFrom = surface.borderFrom();
    this.marked = new Uint8Array(surface.vertices); // on a curve: whether the curve is reached
    this.tipOf = new Int32Array(surface.faces).fill(-1); // of each visited face, the corner it was entered by
    this.closingsBefore = new Int32Array(surface.faces); // of each visited face, the symbols R, L and E before it
    this.symbols = [];
    this.closings = 0; // the symbols R, L and E so far
    this.splits = 0; // the symbols S so far
    this.vertexOrder = [];
    this.tipOrder = [];
    this.records = [];
    this.entries = []; // the trace (EB-TRACE-1)
    this.component = -1;
    this.euler = 0; // of the visited part of the component, infinite faces counted (EB-TRACE-1)
  }

  visited(face) {
    return this.tipOf[face] >= 0;
  }

  run() {
    const { surface } = this;
    let boundaryComponents = 0;
    // EB-COMPONENT-1
    for (let corner = 0; corner < surface.vertex.length; corner += 1) {
      if (surface.opposite[corner] !== BORDER || this.visited(faceOf(corner))) continue;
      boundaryComponents += 1;
      this.component += 1;
      this.euler = 1; // EB-FOLD-1: the infinite face is a 0-handle
      this.traverse(corner, this.reach(surface.tail(corner)));
    }
    // EB-COMPONENT-2
    for (let face = 0; face < surface.faces; face += 1) {
      if (this.visited(face)) continue;
      this.component += 1;
      this.startAtP(face);
      this.traverse(surface.opposite[3 * face], []);
    }
    this.records.sort((one, other) => one.s - other.s); // EB-HANDLE-5
    return {
      word: this.symbols.join(''),
      records: this.records.map(({ kind, s, at, side }) => ({ kind, s, at, side })),
      boundaryComponents,
      vertexOrder: this.vertexOrder,
      tipOrder: this.tipOrder,
      trace: this.trace(),
    };
  }

  startAtP(face) {
    this.tipOf[face] = 3 * face;
    this.tipOrder.push(3 * face);
    const triangle = this.surface.triangle(3 * face);
    for (const vertex of triangle) this.mark(vertex);
    this.euler = 1; // EB-FOLD-1: a 0-handle
    this.entries.push({ i: -1, symbol: 'P', component: this.component, face, triangle, stack: 0, new: triangle,
      closes: [], euler: this.euler });
  }

  mark(vertex) {
    this.marked[vertex] = 1;
    this.vertexOrder.push(vertex);
  }

  /** EB-COMPONENT-1, EB-TRAVERSE-7: a curve is reached at one of its vertices. Answers with its vertices. */
  reach(vertex) {
    const curve = curveFrom(this.surface, this.borderFrom, vertex);
    for (const onCurve of curve) this.mark(onCurve);
    return curve;
  }

  /** EB-GATE-2, for the edge opposite to a corner. */
  closed(corner) {
    const across = this.surface.opposite[corner];
    return across === BORDER || this.visited(faceOf(across));
  }

  /** EB-TRAVERSE-1. */
  traverse(firstGate, firstCurve) {
    const { opposite } = this.surface;
    const stack = []; // gates that wait, each with its S
    let known = firstCurve;
    let gate = firstGate;
    while (gate !== BORDER) {
      const entry = this.visit(gate, known);
      const rightGate = opposite[next(gate)];
      const leftGate = opposite[previous(gate)];
      if (entry.symbol === 'E') {
        gate = this.pop(stack);
      } else if (entry.symbol === 'R') {
        gate = leftGate;
      } else {
        if (entry.symbol === 'S') stack.push({ gate: leftGate, split: this.splits - 1, entry });
        gate = rightGate;
      }
      entry.stack = stack.length;
      known = [];
    }
  }

  /** EB-TRAVERSE-5: the next gate whose triangle is not visited. Each one passed over is a record. */
  pop(stack) {
    while (stack.length > 0) {
      const { gate, split, entry } = stack.pop();
      if (!this.visited(faceOf(gate))) return gate;
      this.record(gate, split, entry);
    }
    return BORDER;
  }

  /** EB-HANDLE-1 to EB-HANDLE-4. `gate` is the closing triangle's corner opposite to the edge that was met. */
  record(gate, split, entry) {
    const closing = faceOf(gate);
    const side = gate === next(this.tipOf[closing]) ? 'right' : 'left';
    const kind = entry.reachedCurve ? 'boundary' : 'handle';
    this.records.push({ kind, s: split, at: this.closingsBefore[closing], side, opener: entry, closing });
  }

  /** EB-TRAVERSE-2 to EB-TRAVERSE-7: visits the triangle of a gate and writes its symbol. */
  visit(gate, known) {
    const { surface } = this;
    const face = faceOf(gate);
    const apex = surface.vertex[gate];
    this.tipOf[face] = gate;
    this.tipOrder.push(gate);
    this.closingsBefore[face] = this.closings;
    const symbol = this.symbolAt(gate, apex);
    const entry = { i: this.symbols.length, symbol, component: this.component, face, triangle: surface.triangle(gate),
      gate: [surface.tail(gate), surface.head(gate)], stack: 0, new: known, closes: [], euler: 0 };
    this.symbols.push(symbol);
    if (symbol === 'C') {
      this.mark(apex);
      entry.new = [...known, apex];
    } else if (symbol === 'S') {
      this.splits += 1;
      this.euler -= 1;
      if (this.borderFrom[apex] !== BORDER && !this.marked[apex]) {
        entry.new = [...known, ...this.reach(apex)];
        entry.reachedCurve = true;
        this.euler += 1;
      }
    } else {
      this.closings += 1;
      if (symbol === 'E') this.euler += 1;
    }
    entry.euler = this.euler;
    this.entries.push(entry);
    return entry;
  }

  symbolAt(gate, apex) {
    if (!this.marked[apex] && this.borderFrom[apex] === BORDER) return 'C';
    const right = this.closed(next(gate));
    const left = this.closed(previous(gate));
    if (right) return left ? 'E' : 'R';
    return left ? 'L' : 'S';
  }

  /** The entries with the records they open and close, which are known at the end only. */
  trace() {
    const entryOf = new Map(this.entries.map((entry) => [entry.face, entry]));
    this.records.forEach(({ opener, closing }, place) => {
      opener.opens = place;
      entryOf.get(closing).closes.push(place);
    });
    for (const entry of this.entries) delete entry.reachedCurve;
    return this.entries;
  }
}

/** The stream of a surface (EB-WORD-2), its orders (EB-ORDER-1, EB-ORDER-3) and its trace. */
function encodeSurface(surface) {
  return new Walk(surface).run();
}

module.exports = { encodeSurface };
