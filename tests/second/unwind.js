'use strict';
// From a stream back to its surface: Spirale Reversi (EB-REVERSI-1 to EB-REVERSI-3) with the grammar of chapter 5.
//
// Face f has the corners 3f (its tip), 3f + 1 and 3f + 2, and an edge is named by the corner opposite to it: the
// edge of the gate is 3f, the right edge 3f + 1, the left edge 3f + 2 (EB-GATE-1, EB-ORDER-3).

const { BORDER, Surface, faceOf, forEachCornerAround, next, previous } = require('./corners.js');
const { surfaceOf } = require('./face_list.js');
const { Loops } = require('./loops.js');
const { Rejection, reject } = require('./rejection.js');
const { scan } = require('./stream.js');

const UNGLUED = -2;
const RIGHT = 1;
const LEFT = 2;

class Unwinding {
  constructor(stream) {
    const { word, records, boundaryComponents } = stream;
    Object.assign(this, { word, records, boundaryComponents }, scan(stream));
    const closed = this.starts.length - boundaryComponents;
    this.faces = word.length + closed;
    this.loops = new Loops(3 * this.faces);
    this.opposite = new Int32Array(3 * this.faces).fill(UNGLUED);
    this.waiting = new Uint8Array(3 * this.faces); // EB-REVERSI-1
    this.waitingEdge = records.map(({ side }, record) => {
      const edge = 3 * this.faceOfSymbol(this.closerOf[record]) + (side === 'right' ? RIGHT : LEFT);
      this.waiting[edge] = 1;
      return edge;
    });
    this.curveOfRecord = new Int32Array(records.length).fill(-1); // the first edge of the curve it cuts off
    this.stack = []; // gates, each with the place of the E that ends what is behind it
  }

  isClosed(component) {
    return component >= this.boundaryComponents;
  }

  /** EB-ORDER-3: a closed component has a face before its symbols. */
  faceOfSymbol(place) {
    return place + Math.max(0, this.componentOf[place] - this.boundaryComponents + 1);
  }

  /** EB-GRAMMAR-8, EB-GRAMMAR-9: the symbol of a face, or the first of its component for the triangle P. */
  symbolOfFace(face) {
    let low = 0; // the symbols' faces increase
    let high = this.word.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.faceOfSymbol(middle) < face) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  glue(one, other) {
    this.opposite[one] = other;
    this.opposite[other] = one;
  }

  run() {
    for (let place = this.word.length - 1; place >= 0; place -= 1) {
      this.undo(place);
      const component = this.componentOf[place];
      if (this.starts[component] === place) this.begin(component, place);
    }
    const surface = this.numbered();
    this.rejectDoubles(surface);
    return surface;
  }

  undo(place) {
    const gate = 3 * this.faceOfSymbol(place);
    const record = this.recordAt[place];
    switch (this.word[place]) {
      case 'E': this.undoE(gate, place); break;
      case 'R': this.undoR(gate); break;
      case 'L': this.undoL(gate); break;
      case 'C': this.undoC(gate, place); break;
      default:
        if (record < 0) this.undoSplit(gate);
        else this.undoRecord(gate, record);
    }
  }

  get top() {
    return this.stack[this.stack.length - 1];
  }

  undoE(gate, place) {
    this.loops.join(gate, gate + RIGHT);
    this.loops.join(gate + RIGHT, gate + LEFT);
    this.loops.join(gate + LEFT, gate);
    this.stack.push({ gate, end: place });
  }

  undoR(gate) {
    const { loops, top } = this;
    const entered = top.gate;
    this.glue(gate + LEFT, entered);
    const [beforeIt, afterIt] = [loops.before[entered], loops.after[entered]];
    loops.join(beforeIt, gate);
    loops.join(gate, gate + RIGHT);
    loops.join(gate + RIGHT, afterIt);
    top.gate = gate;
  }

  undoL(gate) {
    const { loops, top } = this;
    const entered = top.gate;
    this.glue(gate + RIGHT, entered);
    const [beforeIt, afterIt] = [loops.before[entered], loops.after[entered]];
    loops.join(beforeIt, gate + LEFT);
    loops.join(gate + LEFT, gate);
    loops.join(gate, afterIt);
    top.gate = gate;
  }

  undoC(gate, symbol) {
    const { loops, top } = this;
    const entered = top.gate;
    const last = loops.before[entered];
    if (loops.shorter(entered, 4)) reject('loop-too-short', 'EB-GRAMMAR-5', { symbol });
    if (this.waiting[last]) reject('edge-closed-twice', 'EB-GRAMMAR-5', { symbol });
    this.glue(gate + RIGHT, entered);
    this.glue(gate + LEFT, last);
    const [beforeIt, afterIt] = [loops.before[last], loops.after[entered]];
    loops.join(beforeIt, gate);
    loops.join(gate, afterIt);
    top.gate = gate;
  }

  undoSplit(gate) {
    const right = this.stack.pop();
    this.openEdges(gate, right.gate, this.top.gate);
    this.top.gate = gate;
  }

  undoRecord(gate, record) {
    const { loops, top } = this;
    const entered = top.gate;
    const edge = this.waitingEdge[record];
    if (this.closerOf[record] > top.end) reject('record-outside-branch', 'EB-GRAMMAR-6', { record });
    const noneLeft = loops.after[entered] === edge || loops.after[edge] === entered || loops.after[edge] === edge;
    if (noneLeft) reject('loop-too-short', 'EB-GRAMMAR-6', { record });
    this.waiting[edge] = 0;
    const rest = loops.after[edge];
    this.openEdges(gate, entered, edge);
    top.gate = gate;
    if (this.records[record].kind === 'boundary') this.cutCurve(gate, rest, record);
  }

  /**
   * EB-REVERSI-2, the last three rows, as one operation: what was before the left edge is now before the gate, what
   * was after the right one is after it, and the two that remain become neighbours.
   */
  openEdges(gate, right, left) {
    const { loops } = this;
    this.glue(gate + RIGHT, right);
    this.glue(gate + LEFT, left);
    const [beforeLeft, afterLeft] = [loops.before[left], loops.after[left]];
    const [beforeRight, afterRight] = [loops.before[right], loops.after[right]];
    loops.join(beforeRight, afterLeft);
    loops.join(beforeLeft, gate);
    loops.join(gate, afterRight);
  }

  /** EB-GRAMMAR-7. The loop that begins with an edge is a curve, if the gate is not in it. */
  cutCurve(gate, first, record) {
    let edge = first;
    let length = 0;
    do {
      if (edge === gate || this.waiting[edge]) reject('not-a-curve', 'EB-GRAMMAR-7', { record });
      this.opposite[edge] = BORDER;
      length += 1;
      edge = this.loops.after[edge];
    } while (edge !== first);
    if (length < 3) reject('loop-too-short', 'EB-GRAMMAR-7', { record });
    this.curveOfRecord[record] = first;
  }

  /** EB-REVERSI-3, EB-GRAMMAR-8: the beginning of a component. */
  begin(component, symbol) {
    const { loops } = this;
    const { gate } = this.stack.pop();
    let firstFace = this.faceOfSymbol(symbol);
    if (this.isClosed(component)) {
      firstFace -= 1;
      if (loops.shorter(gate, 3) || !loops.shorter(gate, 4)) reject('loop-not-closed', 'EB-GRAMMAR-8', { symbol });
      const tip = 3 * firstFace;
      const [second, third] = [loops.after[gate], loops.before[gate]];
      this.glue(gate, tip);
      this.glue(second, previous(tip));
      this.glue(third, next(tip));
    } else {
      if (loops.shorter(gate, 3)) reject('loop-too-short', 'EB-GRAMMAR-8', { symbol });
      let edge = gate;
      do {
        this.opposite[edge] = BORDER;
        edge = loops.after[edge];
      } while (edge !== gate);
    }
    const last = this.starts[component + 1] ?? this.word.length;
    const stop = 3 * (this.faceOfSymbol(last - 1) + 1);
    for (let edge = 3 * firstFace; edge < stop; edge += 1) {
      if (this.opposite[edge] === UNGLUED) {
        reject('loop-not-closed', 'EB-GRAMMAR-8', { symbol: this.symbolOfFace(Math.floor(edge / 3)) });
      }
    }
  }

  /** EB-REVERSI-3: the classes of corners, numbered by EB-ORDER-1. */
  numbered() {
    const vertex = new Int32Array(3 * this.faces).fill(-1);
    let vertices = 0;
    const name = (corner) => {
      if (vertex[corner] >= 0) return;
      forEachCornerAround(this.opposite, corner, (around) => { vertex[around] = vertices; });
      vertices += 1;
    };
    const nameCurve = (first) => { // by the tails of its edges
      let edge = first;
      do {
        name(next(edge));
        edge = this.loops.after[edge];
      } while (edge !== first);
    };
    for (let place = 0; place < this.word.length; place += 1) {
      const component = this.componentOf[place];
      const tip = 3 * this.faceOfSymbol(place);
      if (this.starts[component] === place) {
        if (this.isClosed(component)) [tip - 3, tip - 2, tip - 1].forEach(name);
        else nameCurve(tip);
      }
      if (this.word[place] === 'C') name(tip);
      const curve = this.recordAt[place] < 0 ? -1 : this.curveOfRecord[this.recordAt[place]];
      if (curve >= 0) nameCurve(curve);
    }
    if (vertex.includes(-1)) throw new Error('a vertex that no symbol creates');
    return new Surface(vertex, this.opposite, vertices);
  }

  /**
   * EB-GRAMMAR-9, by the face list: triangles that share two vertices share the edge and no more, exactly if the
   * list reads as a surface, and as this one.
   */
  rejectDoubles(surface) {
    const blame = (reason, face) => reject(reason, 'EB-GRAMMAR-9', { symbol: this.symbolOfFace(face) });
    let read;
    try {
      read = surfaceOf(surface.triangles(), surface.vertices);
    } catch (fault) {
      if (!(fault instanceof Rejection)) throw fault;
      return blame(fault.reason === 'repeated-index' ? 'repeated-vertex' : 'double-edge', fault.at.face ?? 0);
    }
    const other = read.opposite.findIndex((across, corner) => across !== surface.opposite[corner]);
    return other < 0 ? undefined : blame('double-edge', faceOf(other));
  }
}

/** Decodes a stream: its surface in the order of creation (EB-DECODE-1). */
function decodeStream(stream) {
  return new Unwinding(stream).run();
}

module.exports = { decodeStream };
