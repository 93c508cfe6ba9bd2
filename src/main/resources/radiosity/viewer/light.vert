#version 120
// Radiosity of the vertex, W/m2: not clamped on its way to the pixels, as a colour would be.
centroid varying vec3 radiosity;

void main() {
    radiosity = gl_Color.rgb;
    gl_Position = ftransform();
}
