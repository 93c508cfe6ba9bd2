// What each key does, and the mouse; as radiosity.viewer.Keys, Mouse and Walking.
const SPEED = 0.12, HURRY = 4, TURN = 1.2, LOOK = 0.8, PACE = 1.25, STILL = 3, NOTCH = 100;
const WALKS = /^(Arrow\w+|Page\w+|Key[WASDQE]|Shift\w+)$/;

export const HELP = `Up, Down            walk ahead, back
Left, Right         turn
Page Up, Page Down  look up, down
W, S, A, D          walk ahead, back, sideways
E, Q                rise, sink
Shift               hurry
[, ]                slower, faster
mouse drag, wheel   look around, walk
click               radiosity and irradiance there
Home                back to where it began
+, -                brighter, darker by a third of a stop
0                   automatic exposure
T                   next tone mapping: linear, reinhard, filmic
C                   luminance in colours, with a scale
X                   wireframe
U                   light of textures or of vertices
K                   walk through walls or not
P                   panel for the mouse: exposure, lamps
H                   this help
Space               no text`;

/** Steers a walk. */
export function listen(walk, picture) {
    const keys = new Set();
    let last = 0;

    function between(more, less) {
        const held = names => names.some(name => keys.has(name)) ? 1 : 0;
        return held(more) - held(less);
    }

    function tick(now) {
        const seconds = Math.max(0, Math.min(0.1, (now - last) / 1000));
        last = now;
        const way = seconds * SPEED * walk.size * walk.pace * (keys.has('ShiftLeft') || keys.has('ShiftRight') ? HURRY : 1);
        walk.turn(seconds * TURN * between(['ArrowLeft'], ['ArrowRight']), seconds * LOOK * between(['PageUp'], ['PageDown']));
        walk.step(way * between(['ArrowUp', 'KeyW'], ['ArrowDown', 'KeyS']), way * between(['KeyD'], ['KeyA']),
            way * between(['KeyE'], ['KeyQ']));
        if (keys.size > 0) {
            requestAnimationFrame(tick);
        }
    }

    const curve = () => walk.light.curve.value;
    const paced = factor => () => { walk.pace = Math.max(1 / 64, Math.min(64, walk.pace * factor)); };
    const actions = {
        '+': () => walk.tone(walk.stops() + 1 / 3, curve()),
        '=': () => walk.tone(walk.stops() + 1 / 3, curve()),
        '-': () => walk.tone(walk.stops() - 1 / 3, curve()),
        '_': () => walk.tone(walk.stops() - 1 / 3, curve()),
        '0': () => walk.tone(0, curve()),
        '[': paced(1 / PACE),
        ']': paced(PACE),
        't': () => walk.tone(walk.stops(), curve() + 1),
        'c': () => walk.falseColour(),
        'x': () => walk.wireframe(),
        'u': () => walk.textures(),
        'k': () => walk.walls(),
        'p': () => walk.panel.toggle(),
        'h': () => walk.help(),
        'f1': () => walk.help(),
        ' ': () => walk.quiet(),
        'home': () => walk.home(),
    };

    addEventListener('keydown', event => {
        if (event.ctrlKey || event.altKey || event.metaKey) {
            return;
        }
        const action = actions[event.key.toLowerCase()];
        if (WALKS.test(event.code)) {
            if (keys.size === 0) {
                last = performance.now();
                requestAnimationFrame(tick);
            }
            keys.add(event.code);
        } else if (action) {
            action();
        } else {
            return;
        }
        event.preventDefault();
    });
    addEventListener('keyup', event => keys.delete(event.code));
    addEventListener('blur', () => keys.clear());
    addEventListener('resize', () => walk.draw());
    let moved = 0;
    picture.addEventListener('pointerdown', () => { moved = 0; });
    picture.addEventListener('pointermove', event => {
        if (event.buttons & 1) {
            moved += Math.abs(event.movementX) + Math.abs(event.movementY);
            walk.drag(event.movementX, event.movementY);
        }
    });
    picture.addEventListener('click', event => {
        if (moved < STILL) {
            walk.probe(event.clientX, event.clientY);
        }
    });
    picture.addEventListener('wheel', event => {
        walk.wheel(event.deltaY / NOTCH);
        event.preventDefault();
    }, {passive: false});
}
