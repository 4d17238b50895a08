// What three.js finds in glTF files: a line of JSON for each, as tests/app/blender/list_scene.py says it of Blender.
//
// Run with: node list_scene.mjs FILE..., beside the node_modules that npm makes of package.json.

import { readFileSync } from "node:fs";

import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

// What a browser has, and the loader asks for where a file has pictures: none is looked at here.
globalThis.self ??= globalThis;
globalThis.createImageBitmap ??= async () => ({ width: 1, height: 1, close() {} });
globalThis.ProgressEvent ??= class extends Event {};

/** Of the primitives of an object's own mesh, in their order. */
function materialsOf(object) {
    const meshes = object.isMesh ? [object] : object.children.filter((each) => each.isMesh);
    return meshes.map(({ material }) => ({
        name: material.name,
        colour: material.color.toArray(), // in the working space of three.js, which is linear
        roughness: material.roughness,
        metallic: material.metalness,
        bumps: material.normalMap !== null,
    }));
}

function told(object) {
    const box = new THREE.Box3().setFromObject(object, true);
    return {
        name: object.userData.name ?? object.name, // three.js keeps what it cannot have in a name there
        matrix: object.matrixWorld.clone().transpose().elements, // row by row
        box: [...box.min.toArray(), ...box.max.toArray()],
        materials: materialsOf(object),
    };
}

for (const file of process.argv.slice(2)) {
    const bytes = readFileSync(file);
    const gltf = await new GLTFLoader().parseAsync(new Uint8Array(bytes).buffer, "");
    gltf.scene.updateMatrixWorld(true);
    const objects = [];
    gltf.scene.traverse((object) => {
        const { nodes: node } = gltf.parser.associations.get(object) ?? {};
        if (node !== undefined && "mesh" in gltf.parser.json.nodes[node]) objects.push(told(object));
    });
    console.log(JSON.stringify({ reader: `three.js ${THREE.REVISION}`, objects }));
}
