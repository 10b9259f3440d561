// ez-tree: a preset, generated as often as begins within so many seconds.
//
// Usage: TREE_PEERS_NODE_PATH=.../node_modules node ez_tree.mjs PRESET SECONDS BARK.ply
// Prints one line of JSON: seconds of the fastest run, triangles of leaves, memory. Leaves with status 3 where
// ez-tree or three is not installed. Textures are left out: node has no pictures.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [preset, within, out] = process.argv.slice(2);
const entry = join(process.env.TREE_PEERS_NODE_PATH ?? "node_modules", "@dgreenheck/ez-tree/build/ez-tree.es.js");
if (!existsSync(entry)) {
  console.error(`there is no ${entry}`);
  process.exit(3);
}

// The loader of textures asks for a picture, which never comes.
const picture = { addEventListener() {}, removeEventListener() {}, style: {} };
globalThis.document = { createElementNS: () => ({ ...picture }) };

// Imports of a package that lacks `three` fail here.
const { Tree } = await import(pathToFileURL(entry)).catch((error) => {
  console.error(error.message);
  process.exit(error.code === "ERR_MODULE_NOT_FOUND" ? 3 : 1);
});

/** Peak resident memory in bytes; null where the system does not tell. */
function peak() {
  const path = "/proc/self/status";
  const found = existsSync(path) && /VmHWM:\s+(\d+)/.exec(readFileSync(path, "utf8"));
  return found ? 1024 * Number(found[1]) : null;
}

const idle = peak();
const tree = new Tree();
tree.loadPreset(preset); // Generates it once.
const used = peak();
let seconds = Infinity;
const started = performance.now();
for (let run = 0; run < 100; run++) {
  const start = performance.now();
  if (run > 0 && start - started >= 1000 * Number(within)) break;
  tree.generate();
  seconds = Math.min(seconds, (performance.now() - start) / 1000);
}

// What a scene would draw: the attributes, with their 16-bit indices.
const bark = tree.branchesMesh.geometry;
const places = bark.getAttribute("position").array;
const indices = bark.getIndex().array;
const [n, faces] = [places.length / 3, indices.length / 3];
const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${n}\nproperty float x\nproperty float y\nproperty float z\nelement face ${faces}\nproperty list uchar int vertex_indices\nend_header\n`;
const rows = Buffer.alloc(13 * faces);
for (let face = 0; face < faces; face++) {
  rows.writeUInt8(3, 13 * face);
  for (let k = 0; k < 3; k++) rows.writeInt32LE(indices[3 * face + k], 13 * face + 1 + 4 * k);
}
const points = Buffer.from(places.buffer, places.byteOffset, places.byteLength);
writeFileSync(out, Buffer.concat([Buffer.from(header), points, rows]));

const leaf_triangles = tree.leavesMesh.geometry.getIndex().count / 3;
const peak_bytes = idle === null ? null : used - idle;
console.log(JSON.stringify({ seconds, leaf_triangles, peak_bytes }));
