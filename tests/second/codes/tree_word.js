'use strict';
// The tree word of a rooted sphere, and back (CODE-TREE-4 to CODE-TREE-9). A tree word is a list of bits.

const { halfEdgesOf, orientation } = require('./orientation.js');
const { surfaceOf } = require('../face_list.js');
const { reject } = require('../rejection.js');

/** CODE-TREE-4. */
function treeWord(surface) {
  const half = halfEdgesOf(surface);
  const goesOut = orientation(half);
  const cut = new Uint8Array(surface.vertex.length);
  const cameBy = new Int32Array(surface.vertices).fill(-1); // the half-edge by which the walk first came
  const bits = [];
  let edge = half.after(half.after(0));
  while (edge !== 0) {
    const back = half.reverse(edge);
    if (cameBy[half.from(edge)] === back) {
      bits.push(0);
      edge = half.after(back);
    } else if (cut[edge] || cut[back]) {
      edge = half.after(edge);
    } else if (goesOut[edge]) {
      bits.push(0);
      cut[edge] = 1;
      edge = half.after(edge);
    } else {
      bits.push(1);
      cameBy[half.to(edge)] = edge;
      edge = half.after(back);
    }
  }
  return bits;
}

const notTreeWord = (bit) => reject('not-canonical', 'CODE-TREE-6', bit === undefined ? {} : { symbol: bit });

/** CODE-TREE-5: the string about the tree. A side is [x, y], an edge, or [x], a leaf. */
function stringOf(bits) {
  const sides = [[0]];
  const parents = [-1];
  const leaves = [0];
  let here = 0;
  bits.forEach((bit, place) => {
    if (bit === 1) {
      sides.push([here, parents.length]);
      parents.push(here);
      leaves.push(0);
      here = parents.length - 1;
    } else if (here === 0) {
      notTreeWord(place);
    } else if (leaves[here] < 2) {
      leaves[here] += 1;
      sides.push([here]);
    } else {
      sides.push([here, parents[here]]);
      here = parents[here];
    }
  });
  if (here !== 0 || parents.length === 1) notTreeWord();
  sides.push([0]);
  return { sides, treeVertices: parents.length };
}

const isLeaf = (side) => side.length === 1;

/** CODE-TREE-8: closes the string, and adds the faces. */
function closed(sides, faces) {
  const stack = [];
  for (const side of sides) {
    stack.push(side);
    while (stack.length >= 3) {
      const [leaf, one, other] = stack.slice(-3);
      if (!isLeaf(leaf) || isLeaf(one) || isLeaf(other)) break;
      if (leaf[0] === 0) notTreeWord(); // CODE-TREE-6: no other vertex's leaf comes before an edge from the root
      faces.push([one[0], other[1], one[1]]);
      stack.splice(-3, 3, [one[0], other[1]]);
    }
  }
  return stack;
}

/** CODE-TREE-8, CODE-TREE-9: the sphere of a tree word. */
function sphereOf(bits) {
  const { sides, treeVertices } = stringOf(bits);
  const [v1, v2] = [treeVertices, treeVertices + 1];
  const faces = [[0, v1, v2]];
  const string = closed(sides, faces);
  let joined = v2;
  string.slice(0, -1).forEach((side, place) => {
    const behind = string[place + 1];
    if (!isLeaf(side)) return;
    const before = joined;
    if (isLeaf(behind)) {
      faces.push([side[0], v2, v1]);
      joined = v1;
    } else {
      faces.push([side[0], before, behind[1]]);
    }
  });
  return surfaceOf(faces, treeVertices + 2);
}

module.exports = { treeWord, sphereOf };
