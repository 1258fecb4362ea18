// usage: node wasm_replay.mjs MODULE RECORDING...
// Plays recordings in the module built from game/pinball/examples/wasm_replay.rs and prints the digest of all.
import { readFileSync } from "node:fs";

const [path, ...recordings] = process.argv.slice(2);
const module = new WebAssembly.Module(readFileSync(path));
// Nothing that a game is decided by may be asked of the outside: what is imported throws when it is called.
const imports = {};
for (const { module: room, name } of WebAssembly.Module.imports(module)) {
  imports[room] ??= {};
  imports[room][name] = () => {
    throw new Error(`the game asks the outside for ${name}`);
  };
}
const { memory, recording, play, digest } = new WebAssembly.Instance(module, imports).exports;
for (const file of recordings) {
  const bytes = readFileSync(file);
  // Room may make the memory grow, which gives it another buffer.
  const room = recording(bytes.length);
  new Uint8Array(memory.buffer, room, bytes.length).set(bytes);
  if (play() < 0n) {
    throw new Error(`${file} does not play as it was recorded`);
  }
}
console.log(BigInt.asUintN(64, digest()).toString(16).padStart(16, "0"));
