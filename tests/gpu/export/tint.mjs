// Reads a list of WGSL texts, as JSON, from standard input; writes what Tint, Chrome's compiler, has against each,
// as the last line.
// The first argument is the folder that has `webgpu`, which is Dawn for node.
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const packages = createRequire(`${process.argv[2]}/`);
const { create } = await import(pathToFileURL(packages.resolve('webgpu')));
let input = '';
for await (const part of process.stdin) input += part;
// Tint comes before any driver, so Dawn needs none. It ends once node drops this.
globalThis.gpu = create(['backend=null']);
const adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();
const answers = [];
for (const code of JSON.parse(input)) {
    device.pushErrorScope('validation');
    const info = await device.createShaderModule({ code }).getCompilationInfo();
    const errors = info.messages.filter((message) => message.type === 'error');
    const told = errors.map((error) => `line ${error.lineNum}, column ${error.linePos}: ${error.message}`);
    const scope = await device.popErrorScope();
    answers.push(told.length > 0 ? told.join('\n') : (scope?.message ?? ''));
}
// Dawn writes its warnings there, too, and keeps node awake.
process.stdout.write(`\n${JSON.stringify(answers)}`, () => process.exit(0));
