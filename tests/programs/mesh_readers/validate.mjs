// Prints the triangles of a glTF file, and fails where the validator of Khronos has any complaint.
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';

const report = await validator.validateBytes(new Uint8Array(readFileSync(process.argv[2])));
for (const message of report.issues.messages) console.log(message.message);
if (report.issues.messages.length > 0) process.exit(1);
console.log('triangles:', report.info.totalTriangleCount);
