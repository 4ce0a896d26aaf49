'use strict';
// How the code `context` foretells a decision: slots that learn, and their mixture (CODE-CONTEXT-5 to CODE-CONTEXT-7).

// CODE-CONTEXT-6
const ODDS = [
  22, 36, 60, 98, 162, 267, 439, 720, 1179, 1921, 3108, 4971, 7812, 11955, 17625, 24743, 32768, 40793, 47911, 53581,
  57724, 60565, 62428, 63615, 64357, 64816, 65097, 65269, 65374, 65438, 65476, 65500, 65514,
];
const FARTHEST = 2047;

function probability(logit) {
  const place = logit + 2048;
  const [index, weight] = [place >> 7, place & 127];
  return (ODDS[index] * (128 - weight) + ODDS[index + 1] * weight + 64) >> 7;
}

/** The logits of probabilities by their 16ths: the least that is not below. */
const LOGITS = Int16Array.from({ length: 4096 }, (_, sixteenth) => {
  let logit = -FARTHEST;
  while (logit < FARTHEST && probability(logit) >> 4 < sixteenth) logit += 1;
  return logit;
});

/** CODE-CONTEXT-5. */
function learn(slot, yes) {
  const rate = Math.floor(131072 / (2 * slot.k + 3));
  slot.p += Math.floor(((yes ? 65535 : 0) - slot.p) * rate / 65536);
  if (slot.k < 255) slot.k += 1;
}

/** CODE-CONTEXT-7, for one of the four decisions. */
class Mixer {
  constructor() {
    this.weights = new Array(5).fill(16384);
  }

  foretell(slots) {
    this.slots = slots;
    this.logits = slots.map(({ p }) => LOGITS[p >> 4]);
    const sum = this.weights.reduce((total, weight, place) => total + weight * this.logits[place], 0);
    this.told = probability(Math.max(-FARTHEST, Math.min(FARTHEST, Math.floor(sum / 65536))));
    return this.told;
  }

  learn(yes) {
    const error = (yes ? 65536 : 0) - this.told;
    this.weights = this.weights.map((weight, place) =>
      weight + Math.floor((this.logits[place] * error + 16384) / 32768));
    for (const slot of this.slots) learn(slot, yes);
  }
}

module.exports = { Mixer };
