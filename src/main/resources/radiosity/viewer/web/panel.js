// What the keys do, for the mouse, and a slider and a colour for each lamp; as radiosity.viewer.ControlPanel.
import {controls} from './lamps.js';

const STEPS = 3, MOST_STOPS = 10;

/** The panel of a walk; it gives the keys back after each use. */
export function panel(walk) {
    const box = document.getElementById('panel');
    const stops = element(`<input id="stops" type="range" min="${-STEPS * MOST_STOPS}" max="${STEPS * MOST_STOPS}" value="0">`);
    const curve = element('<select id="curve"><option>linear<option>reinhard<option>filmic</select>');
    const checks = [
        ['falseColour', 'luminance in colours', () => walk.falseColour(), () => walk.light.falseColour.value === 1],
        ['wireframe', 'wireframe', () => walk.wireframe(), () => walk.materials[0].wireframe],
        ['textures', 'light of textures', () => walk.textures(), () => walk.shown !== walk.scene],
        ['walls', 'walls stop you', () => walk.walls(), () => walk.collides],
    ].map(([id, label, toggle, is]) => {
        const part = element(`<label><input id="${id}" type="checkbox">${label}</label>`);
        part.firstChild.addEventListener('change', toggle);
        return {part, refresh: () => { part.firstChild.checked = is(); }};
    });
    stops.addEventListener('input', () => walk.tone(stops.value / STEPS, walk.light.curve.value));
    curve.addEventListener('change', () => walk.tone(walk.stops(), curve.selectedIndex));
    const exposure = element('<label id="exposure"></label>');
    box.append(exposure, stops, curve, ...checks.map(check => check.part));
    if (walk.lamps.lamps.length > 0) {
        box.append(lamps(walk));
    }
    box.addEventListener('change', () => document.activeElement.blur());

    function refresh() {
        stops.value = Math.round(STEPS * walk.stops());
        exposure.textContent = `exposure ${walk.stops() >= 0 ? '+' : ''}${walk.stops().toFixed(2)} EV`;
        curve.selectedIndex = walk.light.curve.value;
        checks.forEach(check => check.refresh());
    }

    refresh();
    return {refresh, toggle: () => { box.hidden = !box.hidden; }};
}

function element(html) {
    const template = document.createElement('template');
    template.innerHTML = html;
    return template.content.firstChild;
}

function lamps(walk) {
    const whole = document.createElement('div');
    const file = element('<input type="file" accept=".mix" hidden>');
    const button = (id, text, action) => {
        const part = element(`<button id="${id}">${text}</button>`);
        part.addEventListener('click', () => {
            action();
            part.blur();
        });
        return part;
    };
    const changed = () => {
        walk.lampsChanged();
        fill();
    };
    const last = [
        button('asRendered', 'lamps as rendered', () => {
            walk.lamps.reset();
            changed();
        }),
        button('saveMix', 'save mix', () => save(`${walk.settings.name}.mix`, walk.lamps.text())),
        button('loadMix', 'load mix', () => file.click()), file,
    ];
    const fill = () => whole.replaceChildren(controls(walk.lamps, () => walk.lampsChanged()), ...last);
    file.addEventListener('change', async () => {
        try {
            walk.lamps.read(await file.files[0].text());
            changed();
        } catch (error) {
            walk.say(`${file.files[0].name}, ${error.message}`);
        }
        file.value = '';
    });
    fill();
    return whole;
}

/** Downloads a text under a name. */
function save(name, text) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], {type: 'text/plain'}));
    link.download = name;
    link.click();
    URL.revokeObjectURL(link.href);
}
