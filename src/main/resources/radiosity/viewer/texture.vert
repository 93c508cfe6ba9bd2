#version 120
// Where in the texture the vertex lies.
centroid varying vec2 place;

void main() {
    place = gl_MultiTexCoord0.st;
    gl_Position = ftransform();
}
