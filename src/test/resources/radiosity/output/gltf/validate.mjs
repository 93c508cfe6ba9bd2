// Prints the Khronos validator's report on a glTF file as JSON.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
const validator = createRequire(process.cwd() + '/package.json')('gltf-validator');
const report = await validator.validateBytes(new Uint8Array(readFileSync(process.argv[2])), { maxIssues: 0 });
console.log(JSON.stringify(report));
