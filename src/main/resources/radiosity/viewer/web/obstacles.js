// All elements of a scene, to stop a step before a wall and to find what is under the mouse, as in the window
// (radiosity.viewer.Obstacles): only what faces one is met. A hierarchy of boxes over the triangles.
const MARGIN = 0.004, SLIDES = 3, LEAF = 4;

export class Obstacles {

    /** meshes: those of three.js with an index; origin: what their positions count from; size: of the scene. */
    constructor(meshes, origin, size) {
        this.meshes = meshes;
        this.origin = origin;
        this.size = size;
        this.first = [0];
        meshes.forEach(mesh => this.first.push(this.first.at(-1) + mesh.geometry.index.count / 3));
        const count = this.first.at(-1);
        this.corners = new Float32Array(9 * count);
        this.order = new Int32Array(count);
        this.gather();
        this.boxes = new Float32Array(12 * Math.max(1, count));
        // per node: first triangle and number of them, or first child and 0
        this.nodes = new Int32Array(4 * Math.max(1, count));
        this.used = 1;
        this.build(0, 0, count);
    }

    gather() {
        let at = 0;
        for (const mesh of this.meshes) {
            const index = mesh.geometry.index.array, position = mesh.geometry.attributes.position.array;
            for (const vertex of index) {
                for (let a = 0; a < 3; a++) {
                    this.corners[at++] = position[3 * vertex + a];
                }
            }
        }
        this.order.forEach((_, i) => { this.order[i] = i; });
    }

    middle(triangle, axis) {
        const at = 9 * triangle + axis;
        return (this.corners[at] + this.corners[at + 3] + this.corners[at + 6]) / 3;
    }

    build(node, from, to) {
        const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
        for (let i = from; i < to; i++) {
            for (let k = 0; k < 9; k++) {
                const x = this.corners[9 * this.order[i] + k];
                low[k % 3] = Math.min(low[k % 3], x);
                high[k % 3] = Math.max(high[k % 3], x);
            }
        }
        this.boxes.set([...low, ...high], 6 * node);
        if (to - from <= LEAF) {
            this.nodes.set([from, to - from], 2 * node);
            return;
        }
        const extent = low.map((x, a) => high[a] - x);
        const split = this.partition(from, to, extent.indexOf(Math.max(...extent)));
        const child = this.used;
        this.used += 2;
        this.nodes.set([child, 0], 2 * node);
        this.build(child, from, split);
        this.build(child + 1, split, to);
    }

    /** Those on the lower side of the mean first; halves where all are on one. */
    partition(from, to, axis) {
        let mean = 0;
        for (let i = from; i < to; i++) {
            mean += this.middle(this.order[i], axis) / (to - from);
        }
        let split = from;
        for (let i = from; i < to; i++) {
            if (this.middle(this.order[i], axis) < mean) {
                [this.order[i], this.order[split]] = [this.order[split], this.order[i]];
                split++;
            }
        }
        return split === from || split === to ? (from + to) >> 1 : split;
    }

    /** Distance at which a ray enters a node's box, or Infinity. */
    enters(node, eye, direction, far) {
        let near = 0;
        for (let a = 0; a < 3; a++) {
            const x = (this.boxes[6 * node + a] - eye[a]) / direction[a];
            const y = (this.boxes[6 * node + 3 + a] - eye[a]) / direction[a];
            near = Math.max(near, Math.min(x, y));
            far = Math.min(far, Math.max(x, y));
        }
        return near <= far * (1 + 1e-6) ? near : Infinity;
    }

    /** The nearest element that a ray meets from its visible side; eye, direction: vectors of three.js. */
    hit(eye, direction, far) {
        const from = eye.clone().sub(this.origin).toArray();
        const along = direction.toArray().map(x => x === 0 ? 1e-30 : x);
        let best = null, reach = far;
        const stack = [0];
        while (stack.length > 0) {
            const node = stack.pop();
            if (this.enters(node, from, along, reach) === Infinity) {
                continue;
            }
            const [begin, count] = this.nodes.subarray(2 * node, 2 * node + 2);
            if (count === 0 && this.order.length > LEAF) {
                stack.push(begin, begin + 1);
            }
            for (let i = begin; i < begin + count; i++) {
                const found = this.meets(this.order[i], from, along, reach);
                if (found) {
                    best = found;
                    reach = found.distance;
                }
            }
        }
        return best && this.named(best);
    }

    /** T. Moeller, B. Trumbore, Fast, minimum storage ray-triangle intersection, 1997; not from behind. */
    meets(triangle, eye, direction, far) {
        const c = this.corners, at = 9 * triangle;
        const edge = k => [0, 1, 2].map(a => c[at + 3 * k + a] - c[at + a]);
        const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
        const ab = edge(1), ac = edge(2), n = cross(ab, ac), towards = -dot(n, direction);
        if (!(towards > 0)) {
            return null;
        }
        const s = [0, 1, 2].map(a => eye[a] - c[at + a]), q = cross(s, direction);
        const v = dot(ac, q) / towards, w = -dot(ab, q) / towards, distance = dot(n, s) / towards;
        const inside = v >= 0 && w >= 0 && v + w <= 1 && distance > 0 && distance < far;
        return inside ? {triangle, v, w, distance, normal: n.map(x => x / Math.hypot(...n))} : null;
    }

    named(found) {
        let m = 0;
        while (this.first[m + 1] <= found.triangle) {
            m++;
        }
        return {...found, mesh: this.meshes[m], element: found.triangle - this.first[m]};
    }

    /** How much of a step can be taken: before a wall it goes on along it; modifies the step. */
    allowed(eye, step) {
        const margin = MARGIN * this.size;
        for (let slide = 0; slide < SLIDES; slide++) {
            const length = step.length();
            const wall = length > 0 && this.hit(eye, step.clone().divideScalar(length), length + 2 * margin);
            if (!wall) {
                return step;
            }
            const n = step.clone().fromArray(wall.normal);
            const towards = -step.dot(n);
            const room = Math.max(0, wall.distance * towards / length - margin);
            if (towards <= room) {
                return step;
            }
            step.addScaledVector(n, towards - room);
        }
        return step.set(0, 0, 0);
    }
}
