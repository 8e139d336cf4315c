// Khronos' validator on glTF files: node validate.mjs FILE...   Status 1 if one has errors.
import { readFile } from 'node:fs/promises';
import { dirname, resolve } from 'node:path';
import validator from 'gltf-validator';

let failed = false;
for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(file)), {
    uri: file,
    maxIssues: 50,
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(resolve(dirname(file), decodeURIComponent(uri)))),
  });
  const { numErrors, numWarnings } = report.issues;
  const { drawCallCount, totalTriangleCount, materialCount } = report.info;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings; ${drawCallCount} draw calls, ` +
    `${totalTriangleCount} triangles, ${materialCount} materials`);
  for (const m of report.issues.messages.filter((m) => m.severity < 2))
    console.log(`  ${m.severity === 0 ? 'error' : 'warning'} ${m.code} ${m.pointer ?? ''}: ${m.message}`);
  failed ||= numErrors > 0;
}
process.exit(failed ? 1 : 0);
