// Runs the Khronos glTF validator over GLB or glTF files.
//
//   npm install          (once, in this folder)
//   node validate.mjs tree.glb [more.glb ...]
//
// Prints one line of counts per file and one line per message. The exit code is 0 when no file has an
// error or a warning, 1 when one has, 2 when a file cannot be read or none was named.

import { readFile } from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import validator from 'gltf-validator';

const SEVERITY = ['error', 'warning', 'info', 'hint'];

async function validate(path) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(path)), {
    uri: basename(path),
    maxIssues: 1000,
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(join(dirname(path), decodeURIComponent(uri)))),
  });
  const { issues, info } = report;
  // On files too broken to be read there is no info.
  const size = info === undefined
    ? ''
    : `, ${info.totalVertexCount} vertices, ${info.totalTriangleCount} triangles, ${info.drawCallCount} draw calls`;
  console.log(
    `${path}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ` +
    `${issues.numInfos} infos, ${issues.numHints} hints${size}`,
  );
  for (const { severity, code, message, pointer } of issues.messages) {
    console.log(`  ${SEVERITY[severity]} ${code} ${pointer ?? ''}: ${message}`);
  }
  return issues.numErrors + issues.numWarnings === 0;
}

const paths = process.argv.slice(2);
if (paths.length === 0) {
  console.error('usage: node validate.mjs FILE.glb ...');
  process.exit(2);
}
let clean = true;
for (const path of paths) {
  try {
    clean = (await validate(path)) && clean;
  } catch (error) {
    console.error(`${path}: ${error.message ?? error}`);
    process.exit(2);
  }
}
process.exit(clean ? 0 : 1);
