// Reads a mesh with a loader of three.js and writes what it has of it as binary STL.
// usage: node three_reader.mjs MESH OUTPUT.stl
import { readFileSync, writeFileSync } from 'node:fs';
import { extname } from 'node:path';
import { JSDOM } from 'jsdom';
import { Mesh, Object3D } from 'three';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { ThreeMFLoader } from 'three/addons/loaders/3MFLoader.js';
import { VTKLoader } from 'three/addons/loaders/VTKLoader.js';

globalThis.DOMParser = new JSDOM().window.DOMParser; // what a browser has
globalThis.self = globalThis;

const [input, output] = process.argv.slice(2);
const bytes = new Uint8Array(readFileSync(input)).buffer;
const readers = {
  '.stl': () => new Mesh(new STLLoader().parse(bytes)),
  '.ply': () => new Mesh(new PLYLoader().parse(bytes)),
  '.obj': () => new OBJLoader().parse(new TextDecoder().decode(bytes)),
  '.glb': async () => (await new GLTFLoader().parseAsync(bytes, '')).scene,
  '.3mf': () => new ThreeMFLoader().parse(bytes),
  '.vtp': () => new Mesh(new VTKLoader().parse(bytes)),
};
const scene = new Object3D().add(await readers[extname(input)]());
scene.updateMatrixWorld(true);
const stl = new STLExporter().parse(scene, { binary: true });
writeFileSync(output, new Uint8Array(stl.buffer));
