// Walks through a scene file in a browser; the keys are those of the window (radiosity.viewer.Keys).
import * as THREE from 'three';
import {GLTFLoader} from './three/examples/jsm/loaders/GLTFLoader.js';

const SPEED = 0.12, HURRY = 4, TURN = 1.2, LOOK = 0.8, DRAG = 1.5, STEEPEST = 89 * Math.PI / 180;
const CURVES = ['linear', 'reinhard', 'filmic'];
const HELP = `Up, Down            walk ahead, back
Left, Right         turn
Page Up, Page Down  look up, down
W, S, A, D          walk ahead, back, sideways
E, Q                rise, sink
Shift               hurry
mouse drag          look around
Home                back to where it began
+, -                brighter, darker by a third of a stop
0                   automatic exposure
T                   next tone mapping
C                   luminance in colours
X                   wireframe
H                   this help`;
const VERTEX = `
attribute vec3 _radiosity;
varying vec3 radiosity;
void main() {
    radiosity = _radiosity;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const text = document.getElementById('text');
const fetched = async (path, kind) => (await fetch(path))[kind]();

try {
    const [settings, fragment, gltf] = await Promise.all([fetched('settings.json', 'json'),
        fetched('light.frag', 'text'), new GLTFLoader().loadAsync('scene.glb')]);
    start(settings, fragment.replace(/^#version.*\n/, ''), gltf);
} catch (error) {
    text.textContent = error.message;
    throw error;
}

function start(settings, fragment, gltf) {
    const material = new THREE.ShaderMaterial({vertexShader: VERTEX, fragmentShader: fragment,
        uniforms: {exposure: {value: settings.exposure}, curve: {value: settings.curve}, falseColour: {value: 0}}});
    gltf.scene.traverse(node => {
        if (node.isMesh) {
            node.material = material;
        }
    });
    gltf.scene.updateMatrixWorld(true);
    const extent = new THREE.Box3().setFromObject(gltf.scene);
    const size = extent.getSize(new THREE.Vector3()).length() || 1;
    const renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    document.body.appendChild(renderer.domElement);
    const camera = new THREE.PerspectiveCamera(2 * settings.verticalHalfAngle * 180 / Math.PI, 1, 1e-3 * size, 4 * size);
    const walker = {};
    const keys = new Set();
    let last = 0;

    function home() {
        walker.eye = new THREE.Vector3(...settings.eye);
        const [x, y, z] = settings.forward;
        walker.pitch = Math.asin(Math.max(-1, Math.min(1, y)));
        walker.heading = Math.atan2(-x, -z);
        text.textContent = '';
        draw();
    }

    function draw() {
        const {innerWidth: width, innerHeight: height} = window;
        renderer.setPixelRatio(window.devicePixelRatio);
        renderer.setSize(width, height);
        camera.aspect = width / height;
        camera.far = walker.eye.distanceTo(extent.getCenter(new THREE.Vector3())) + size;
        camera.updateProjectionMatrix();
        camera.position.copy(walker.eye);
        camera.rotation.set(walker.pitch, walker.heading, 0, 'YXZ');
        renderer.render(gltf.scene, camera);
    }

    function between(more, less) {
        const held = names => names.some(name => keys.has(name)) ? 1 : 0;
        return held(more) - held(less);
    }

    function walk(now) {
        const seconds = Math.min(0.1, (now - last) / 1000);
        last = now;
        const way = seconds * SPEED * size * (keys.has('ShiftLeft') || keys.has('ShiftRight') ? HURRY : 1);
        turn(seconds * TURN * between(['ArrowLeft'], ['ArrowRight']),
            seconds * LOOK * between(['PageUp'], ['PageDown']));
        const ahead = way * between(['ArrowUp', 'KeyW'], ['ArrowDown', 'KeyS']);
        const right = way * between(['KeyD'], ['KeyA']);
        const sine = Math.sin(walker.heading), cosine = Math.cos(walker.heading);
        walker.eye.x += -sine * ahead + cosine * right;
        walker.eye.z += -cosine * ahead - sine * right;
        walker.eye.y += way * between(['KeyE'], ['KeyQ']);
        draw();
        if (keys.size > 0) {
            requestAnimationFrame(walk);
        }
    }

    function turn(left, up) {
        walker.heading += left;
        walker.pitch = Math.max(-STEEPEST, Math.min(STEEPEST, walker.pitch + up));
    }

    function light(exposure, curve) {
        material.uniforms.exposure.value = exposure;
        material.uniforms.curve.value = curve;
        const stops = Math.log2(exposure / settings.exposure);
        text.textContent = `exposure ${exposure.toPrecision(4)} per W/m² (${stops >= 0 ? '+' : ''}${stops.toFixed(2)} EV)   ${CURVES[curve]}`;
    }

    function act(event) {
        const {exposure, curve, falseColour} = material.uniforms;
        const actions = {
            '+': () => light(exposure.value * 2 ** (1 / 3), curve.value),
            '-': () => light(exposure.value / 2 ** (1 / 3), curve.value),
            '0': () => light(settings.exposure, curve.value),
            't': () => light(exposure.value, (curve.value + 1) % CURVES.length),
            'c': () => { falseColour.value = 1 - falseColour.value; },
            'x': () => { material.wireframe = !material.wireframe; },
            'h': () => { text.textContent = text.textContent ? '' : HELP; },
            'home': home,
        };
        const action = actions[event.key === '=' ? '+' : event.key.toLowerCase()];
        if (action) {
            action();
            draw();
        }
        return action;
    }

    const WALKS = /^(Arrow\w+|Page\w+|Key[WASDQE]|Shift\w+)$/;
    addEventListener('keydown', event => {
        if (event.ctrlKey || event.altKey || event.metaKey) {
            return;
        }
        if (WALKS.test(event.code)) {
            if (keys.size === 0) {
                last = performance.now();
                requestAnimationFrame(walk);
            }
            keys.add(event.code);
            event.preventDefault();
        } else if (act(event)) {
            event.preventDefault();
        }
    });
    addEventListener('keyup', event => keys.delete(event.code));
    addEventListener('blur', () => keys.clear());
    addEventListener('resize', draw);
    addEventListener('pointermove', event => {
        if (event.buttons & 1) {
            turn(event.movementX * DRAG / innerHeight, event.movementY * DRAG / innerHeight);
            draw();
        }
    });
    home();
    document.body.dataset.ready = 'yes';
}
