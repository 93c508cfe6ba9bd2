// The light of each lamp, mixed anew as in the window (radiosity.viewer.Lighting): exact, on the CPU.

/** Lets lamps be dimmed and coloured; lamps: names, and whether each is a surface. */
export class Lamps {

    constructor(lamps, meshes) {
        this.lamps = lamps;
        this.meshes = meshes;
        this.factors = lamps.map(() => [1, 1, 1]);
        meshes.forEach(mesh => remember(mesh, lamps));
    }

    /** factor: what the lamp's light is multiplied with, three numbers. */
    set(lamp, factor) {
        this.factors[lamp] = factor;
        this.meshes.forEach(mesh => mix(mesh, this.factors));
    }

    /** Puts out all other lamps; one that is out itself is as it was rendered. */
    only(lamp) {
        this.factors = this.factors.map((factor, i) => i !== lamp ? [0, 0, 0]
            : Math.max(...factor) > 0 ? factor : [1, 1, 1]);
        this.meshes.forEach(mesh => mix(mesh, this.factors));
    }

    /** What a surface emits with its lamp as it is set, three numbers. */
    exitance({exitance, own}) {
        return exitance.map((e, channel) => own < 0 ? e : e * this.factors[own][channel]);
    }

    reset() {
        this.lamps.forEach((_, lamp) => { this.factors[lamp] = [1, 1, 1]; });
        this.meshes.forEach(mesh => mix(mesh, this.factors));
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

/** A slider, a colour, solo and off for each lamp; changed is called after each. */
export function controls(lamps, changed) {
    const box = document.createElement('div'), shows = [];
    lamps.lamps.forEach((lamp, i) => {
        const label = document.createElement('label'), slider = document.createElement('input');
        const colour = document.createElement('input');
        Object.assign(slider, {type: 'range', min: 0, max: 300, value: 100, id: `lamp${i}`});
        Object.assign(colour, {type: 'color', value: '#ffffff', id: `colour${i}`});
        const show = () => {
            const most = Math.max(...lamps.factors[i]);
            slider.value = Math.round(100 * most);
            if (most > 0) {
                colour.value = code(lamps.factors[i].map(x => x / most));
            }
            label.textContent = `${lamp.name} ${slider.value} %`;
        };
        const apply = () => {
            label.textContent = `${lamp.name} ${slider.value} %`;
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
