// Walks through a scene file in a browser; the keys are those of the window (radiosity.viewer.Keys).
import * as THREE from 'three';
import {GLTFLoader} from './three/examples/jsm/loaders/GLTFLoader.js';
import {Obstacles} from './obstacles.js';
import {Lamps} from './lamps.js';
import {panel} from './panel.js';
import {HELP, listen} from './keys.js';

const DRAG = 1.5, NOTCH = 0.02, STEEPEST = 89 * Math.PI / 180;
const CURVES = ['linear', 'reinhard', 'filmic'];
const VERTEX = `
#ifdef TEXTURES
centroid varying vec2 place;
#else
attribute vec3 shown;
centroid varying vec3 radiosity;
#endif
void main() {
#ifdef TEXTURES
    place = uv;
#else
    radiosity = shown;
#endif
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const text = document.getElementById('text');
const fetched = async (path, kind) => (await fetch(path))[kind]();

/** What is shown, and from where. */
class Walk {

    constructor(settings, fragment, gltf) {
        this.settings = settings;
        this.fragment = fragment;
        this.scene = gltf.scene;
        this.textured = gltf.scenes[1];
        this.light = {exposure: {value: settings.exposure}, curve: {value: settings.curve}, falseColour: {value: 0}};
        this.meshes = meshesOf(this.scene);
        this.lamps = new Lamps(settings.lamps, this.meshes);
        this.materials = [this.material({})];
        this.meshes.forEach(mesh => { mesh.material = this.materials[0]; });
        if (this.textured) {
            meshesOf(this.textured).forEach(mesh => { mesh.material = this.baked(mesh.material.map); });
        }
        this.scene.updateMatrixWorld(true);
        this.extent = new THREE.Box3().setFromObject(this.scene);
        this.size = this.extent.getSize(new THREE.Vector3()).length() || 1;
        this.renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
        document.body.prepend(this.renderer.domElement);
        this.camera = new THREE.PerspectiveCamera(2 * settings.verticalHalfAngle * 180 / Math.PI, 1, 1e-3 * this.size, 4 * this.size);
        this.shown = this.scene;
        this.collides = true;
        this.pace = 1;
        this.home();
        listen(this, this.renderer.domElement);
        this.panel = panel(this);
        // a large scene is shown before its walls are known
        setTimeout(() => {
            this.obstacles = new Obstacles(this.meshes, new THREE.Vector3().setFromMatrixPosition(this.scene.children[0].matrixWorld), this.size);
            document.body.dataset.ready = 'yes';
        });
    }

    material(more, defines = {}) {
        return new THREE.ShaderMaterial({vertexShader: VERTEX, fragmentShader: this.fragment, defines,
            uniforms: {...this.light, ...more}});
    }

    /** The shader makes the texture's codes linear itself. */
    baked(texture) {
        texture.colorSpace = THREE.NoColorSpace;
        const {exposure, curve} = this.settings.textures;
        const material = this.material({image: {value: texture}, bakedExposure: {value: exposure}, bakedCurve: {value: curve}},
            {TEXTURES: ''});
        this.materials.push(material);
        return material;
    }

    draw() {
        const {innerWidth: width, innerHeight: height} = window;
        this.renderer.setPixelRatio(window.devicePixelRatio);
        this.renderer.setSize(width, height);
        this.camera.aspect = width / height;
        this.camera.far = this.eye.distanceTo(this.extent.getCenter(new THREE.Vector3())) + this.size;
        this.camera.updateProjectionMatrix();
        this.camera.position.copy(this.eye);
        this.camera.rotation.set(this.pitch, this.heading, 0, 'YXZ');
        this.renderer.render(this.shown, this.camera);
        this.placeMark();
        scale(document.getElementById('scale'), this.light, this.settings.units);
    }

    /** Where the probe was set, as long as what it tells is shown. */
    placeMark() {
        const mark = document.getElementById('mark');
        const at = this.mark?.clone().project(this.camera);
        mark.hidden = !at || at.z > 1 || !text.textContent.startsWith('surface ');
        if (!mark.hidden) {
            mark.style.left = `${(at.x + 1) / 2 * innerWidth}px`;
            mark.style.top = `${(1 - at.y) / 2 * innerHeight}px`;
        }
    }

    home() {
        this.eye = new THREE.Vector3(...this.settings.eye);
        const [x, y, z] = this.settings.forward;
        this.pitch = Math.asin(Math.max(-1, Math.min(1, y)));
        this.heading = Math.atan2(-x, -z);
        this.say('');
        this.draw();
    }

    say(line) {
        text.textContent = line;
        document.getElementById('hint').hidden ||= line !== '';
        this.placeMark();
    }

    /** Nothing but the picture. */
    quiet() {
        this.say('');
        document.getElementById('hint').hidden = true;
    }

    help() {
        this.say(text.textContent === HELP ? '' : HELP);
    }

    turn(left, up) {
        this.heading += left;
        this.pitch = Math.max(-STEEPEST, Math.min(STEEPEST, this.pitch + up));
    }

    drag(x, y) {
        this.turn(x * DRAG / innerHeight, y * DRAG / innerHeight);
        this.draw();
    }

    /** Scene units. */
    step(ahead, right, up) {
        const sine = Math.sin(this.heading), cosine = Math.cos(this.heading);
        const step = new THREE.Vector3(-sine * ahead + cosine * right, up, -cosine * ahead - sine * right);
        this.eye.add(this.collides && this.obstacles ? this.obstacles.allowed(this.eye, step) : step);
        this.draw();
    }

    wheel(notches) {
        this.step(-NOTCH * this.size * notches, 0, 0);
    }

    stops() {
        return Math.log2(this.light.exposure.value / this.settings.exposure);
    }

    /** Exposure in stops from the automatic one, and the number of the curve. */
    tone(stops, curve) {
        this.light.exposure.value = this.settings.exposure * 2 ** stops;
        this.light.curve.value = curve % CURVES.length;
        this.say(`exposure ${this.light.exposure.value.toPrecision(4)} per ${this.settings.units.exitance} (${stops >= 0 ? '+' : ''}${stops.toFixed(2)} EV)   ${CURVES[this.light.curve.value]}`);
        this.changed();
    }

    falseColour() {
        this.light.falseColour.value = 1 - this.light.falseColour.value;
        this.changed();
    }

    wireframe() {
        this.materials.forEach(material => { material.wireframe = !material.wireframe; });
        this.changed();
    }

    /** The light of textures is as it was rendered. */
    textures() {
        this.shown = this.textured && this.shown === this.scene ? this.textured : this.scene;
        this.say(!this.textured ? 'no textures: they are made by RadiosityRenderer -ut'
            : this.shown === this.scene ? 'vertices' : 'textures');
        this.changed();
    }

    lampsChanged() {
        this.shown = this.scene;
        this.changed();
    }

    walls() {
        this.collides = !this.collides;
        this.say(`walls ${this.collides ? 'stop you' : 'let you through'}`);
        this.changed();
    }

    changed() {
        this.panel?.refresh();
        this.draw();
    }

    /** Tells what light there is under a pixel. */
    probe(x, y) {
        const at = new THREE.Vector3(2 * (x + 0.5) / innerWidth - 1, 1 - 2 * (y + 0.5) / innerHeight, 0.5);
        const direction = at.unproject(this.camera).sub(this.eye).normalize();
        const hit = this.obstacles?.hit(this.eye, direction, 4 * this.size + this.eye.length());
        this.mark = hit && this.eye.clone().addScaledVector(direction, hit.distance);
        this.say(hit ? this.told(hit, direction) : '');
    }

    told({mesh, element, v, w, distance}, direction) {
        const corner = k => mesh.geometry.index.array[3 * element + k];
        const mean = value => [0, 1, 2].map(a => (1 - v - w) * value(3 * corner(0) + a) + v * value(3 * corner(1) + a)
            + w * value(3 * corner(2) + a));
        const {_radiosity: b, _irradiance: h} = mesh.geometry.attributes, light = mesh.userData.light;
        const line = (name, values, unit = '') => name.padEnd(13) + values.map(x => x.toPrecision(4)).join('  ') + unit;
        const units = this.settings.units, leaving = mean(i => b.array[i]), arriving = mean(i => h.array[i]);
        const place = this.eye.clone().addScaledVector(direction, distance);
        return [`surface      ${light.surface}${light.back ? ' (back)' : ''}`, line('radiosity', leaving, ` ${units.exitance}`),
            line('irradiance', arriving, ` ${units.irradiance}`),
            `luminance Y  ${weighted(leaving, units.luminancePerRadiosity)} ${units.luminance}, ${units.irradianceWord} ${weighted(arriving)} ${units.irradiance}`,
            line('reflectance', mean(light.rho)), line('exitance', this.lamps.exitance(light), ` ${units.exitance}`),
            line('at', place.toArray())].join('\n');
    }
}

/** Y of linear sRGB, times a factor. */
function weighted([r, g, b], factor = 1) {
    return (factor * (0.2126 * r + 0.7152 * g + 0.0722 * b)).toPrecision(4);
}

const WHITE = 4, DECADES = 3;

/** What the colours of false colour mean, as radiosity.viewer.Overlay. */
function scale(box, light, units) {
    box.hidden = light.falseColour.value === 0;
    if (box.hidden) {
        return;
    }
    const bar = Object.assign(document.createElement('canvas'), {width: 1, height: 100});
    const context = bar.getContext('2d');
    for (let y = 0; y < bar.height; y++) {
        context.fillStyle = `rgb(${turbo(1 - y / (bar.height - 1)).join()})`;
        context.fillRect(0, y, 1, 1);
    }
    const list = document.createElement('ol');
    for (let decade = 0; decade <= DECADES; decade++) {
        const value = WHITE / light.exposure.value * units.luminancePerRadiosity * 10 ** -decade;
        list.append(Object.assign(document.createElement('li'), {textContent: value.toPrecision(3)}));
    }
    box.replaceChildren(units.scale, document.createElement('br'), bar, list);
}

/** A. Mikhailov, Turbo, an improved rainbow colormap, 2019: its published polynomial. */
function turbo(x) {
    return [[0.13572138, 4.61539260, -42.66032258, 132.13108234, -152.94239396, 59.28637943],
        [0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604],
        [0.10667330, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973]]
        .map(p => Math.round(255 * Math.max(0, Math.min(1, p.reduceRight((y, c) => y * x + c, 0)))));
}

function meshesOf(scene) {
    const meshes = [];
    scene.traverse(node => {
        if (node.isMesh) {
            meshes.push(node);
        }
    });
    return meshes;
}

try {
    const [settings, fragment, gltf] = await Promise.all([fetched('settings.json', 'json'),
        fetched('light.frag', 'text'), new GLTFLoader().loadAsync('scene.glb')]);
    // for whoever looks into the page
    window.walk = new Walk(settings, fragment.replace(/^#version.*\n/, ''), gltf);
} catch (error) {
    text.textContent = error.message;
    throw error;
}
