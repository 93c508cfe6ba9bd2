// The light of each lamp, mixed anew as in the window (radiosity.viewer.Lighting): exact, on the CPU.

/** Lets lamps be dimmed and coloured, those of one name together; lamps: names, and whether each is a surface. */
export class Lamps {

    constructor(lamps, meshes) {
        this.lamps = lamps;
        this.meshes = meshes;
        this.names = [...new Set(lamps.map(lamp => lamp.name))];
        this.factors = lamps.map(() => [1, 1, 1]);
        meshes.forEach(mesh => remember(mesh, lamps));
    }

    /** What the light of a group of lamps is multiplied with, three numbers. */
    factor(group) {
        return this.factors[this.lamps.findIndex(lamp => lamp.name === this.names[group])];
    }

    set(group, factor) {
        this.#mix(name => name === this.names[group] ? factor : null);
    }

    /** Puts out all other lamps; a group that is out itself is as it was rendered. */
    only(group) {
        const own = Math.max(...this.factor(group)) > 0 ? this.factor(group) : [1, 1, 1];
        this.#mix(name => name === this.names[group] ? own : [0, 0, 0]);
    }

    reset() {
        this.#mix(() => [1, 1, 1]);
    }

    /** factors: by name, for those that change. */
    #mix(factors) {
        this.factors = this.lamps.map((lamp, i) => factors(lamp.name) ?? this.factors[i]);
        this.meshes.forEach(mesh => mix(mesh, this.factors));
    }

    /** What a surface emits with its lamp as it is set, three numbers. */
    exitance({exitance, own}) {
        return exitance.map((e, channel) => own < 0 ? e : e * this.factors[own][channel]);
    }

    /** As radiosity.viewer.LampMix writes it: a line for each group, three factors and the name. */
    text() {
        return this.names.map((name, group) => `${this.factor(group).join(' ')} ${name}\n`).join('');
    }

    /** Sets what a text of text() says, and all other lamps as rendered; throws an error where it is none. */
    read(text) {
        const read = new Map(text.trimEnd().split(/\r?\n/).map((line, i) => {
            const [, ...words] = line.trim().match(/^(\S+) +(\S+) +(\S+) +(.+)$/) ?? [];
            const factor = words.slice(0, 3).map(Number);
            if (factor.length < 3 || !factor.every(x => x >= 0 && x < Infinity)) {
                throw new Error(`line ${i + 1}: expected three factors and a lamp's name, got ${line}`);
            }
            return [words[3], factor];
        }));
        this.#mix(name => read.get(name) ?? [1, 1, 1]);
    }
}

/** What a mesh was rendered with: mixtures are made of that, not of each other. */
function remember(mesh, lamps) {
    const {attributes} = mesh.geometry, {surface, back, reflectance, exitance} = mesh.material.userData;
    const own = attributes._reflectance?.array, smooth = attributes._smooth;
    mesh.userData.light = {
        surface, back, reflectance, exitance,
        radiosity: attributes._radiosity.array.slice(),
        irradiance: attributes._irradiance.array.slice(),
        layers: lamps.map((_, lamp) => attributes[`_irradiance_${lamp}`].array),
        own: lamps.findIndex(lamp => lamp.surface && lamp.name === surface),
        rho: i => own ? own[i] : reflectance[i % 3],
    };
    mesh.geometry.setAttribute('shown', smooth ? attributes._radiosity.clone() : attributes._radiosity);
    show(mesh);
    // only what is shown of the vertices' radiosity is drawn
    lamps.forEach((_, lamp) => mesh.geometry.deleteAttribute(`_irradiance_${lamp}`));
}

function mix(mesh, factors) {
    const light = mesh.userData.light, {_radiosity: to, _irradiance: h} = mesh.geometry.attributes;
    for (let i = 0; i < to.array.length; i++) {
        let sum = 0;
        for (let lamp = 0; lamp < factors.length; lamp++) {
            sum += factors[lamp][i % 3] * light.layers[lamp][i];
        }
        const emitted = light.radiosity[i] - light.rho(i) * light.irradiance[i];
        h.array[i] = sum;
        to.array[i] = light.rho(i) * sum + Math.max(0, emitted) * (light.own < 0 ? 1 : factors[light.own][i % 3]);
    }
    show(mesh);
}

/** Joined vertices show their mean irradiance, as in radiosity.output.mesh.SmoothShading. */
function show(mesh) {
    const {shown, _smooth: smooth, _radiosity: b, _irradiance: h} = mesh.geometry.attributes;
    if (smooth) {
        const means = new Float64Array(h.array.length), joined = i => 3 * smooth.getX(Math.floor(i / 3)) + i % 3;
        h.array.forEach((value, i) => { means[joined(i)] += smooth.getY(Math.floor(i / 3)) * value; });
        b.array.forEach((value, i) => {
            shown.array[i] = value + mesh.userData.light.rho(i) * (means[joined(i)] - h.array[i]);
        });
    }
    shown.needsUpdate = true;
}

/** Of a colour as #rrggbb: linear, the largest of the three 1. */
export function linear(code) {
    const rgb = [1, 3, 5].map(i => parseInt(code.slice(i, i + 2), 16) / 255)
        .map(x => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
    const most = Math.max(...rgb);
    return most > 0 ? rgb.map(x => x / most) : [1, 1, 1];
}

function code(linear) {
    const byte = x => Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
    return `#${linear.map(x => byte(Math.max(0, Math.min(1, x))).toString(16).padStart(2, '0')).join('')}`;
}

/** A slider, a colour, solo and off for each name of lamps; changed is called after each. */
export function controls(lamps, changed) {
    const box = document.createElement('div'), shows = [];
    lamps.names.forEach((name, i) => {
        const label = document.createElement('label'), slider = document.createElement('input');
        const colour = document.createElement('input');
        Object.assign(slider, {type: 'range', min: 0, max: 300, value: 100, id: `lamp${i}`});
        Object.assign(colour, {type: 'color', value: '#ffffff', id: `colour${i}`});
        const show = () => {
            const most = Math.max(...lamps.factor(i));
            slider.value = Math.round(100 * most);
            if (most > 0) {
                colour.value = code(lamps.factor(i).map(x => x / most));
            }
            label.textContent = `${name} ${slider.value} %`;
        };
        const apply = () => {
            label.textContent = `${name} ${slider.value} %`;
            lamps.set(i, linear(colour.value).map(x => x * slider.value / 100));
            changed();
        };
        slider.addEventListener('input', apply);
        colour.addEventListener('input', apply);
        const button = (text, action) => {
            const part = Object.assign(document.createElement('button'), {textContent: text, id: `${text}${i}`});
            part.addEventListener('click', () => {
                action();
                shows.forEach(one => one());
                changed();
                part.blur();
            });
            return part;
        };
        shows.push(show);
        show();
        box.append(label, slider, colour, button('solo', () => lamps.only(i)),
            button('off', () => lamps.set(i, [0, 0, 0])));
    });
    return box;
}
