#version 120
// From radiosity to what the screen shows, as radiosity.output.image.ToneMapping does it. What varies is taken inside the
// triangle (centroid): at the middle of a pixel that a thin triangle touches, beside the triangle, it may be negative.
uniform float exposure;
uniform int curve;        // ToneMapping.Operator, by its number
uniform int falseColour;  // 1: luminance in colours, see TurboColourMap
#ifdef TEXTURES
uniform sampler2D image;       // radiosity as bakedCurve and bakedExposure made it, sRGB
uniform float bakedExposure;
uniform int bakedCurve;
centroid varying vec2 place;
#else
centroid varying vec3 radiosity;
#endif

const float WHITE = 4.0;
const float DECADES = 3.0;

float luminanceOf(vec3 light) {
    return dot(light, vec3(0.2126, 0.7152, 0.0722));
}

vec3 toneMapped(vec3 x) {
    if (curve == 1) {
        float l = luminanceOf(x);
        return x * (1.0 + l / (WHITE * WHITE)) / (1.0 + l);
    }
    if (curve == 2) {
        return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    }
    return x;
}

vec3 srgb(vec3 light) {
    vec3 x = clamp(light, 0.0, 1.0);
    return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x));
}

// A. Mikhailov, Turbo, an improved rainbow colormap, 2019: its published polynomial.
vec3 turbo(float x) {
    vec4 a = vec4(1.0, x, x * x, x * x * x);
    vec2 b = a.zw * a.z;
    return vec3(
        dot(a, vec4(0.13572138, 4.61539260, -42.66032258, 132.13108234)) + dot(b, vec2(-152.94239396, 59.28637943)),
        dot(a, vec4(0.09140261, 2.19418839, 4.84296658, -14.18503333)) + dot(b, vec2(4.27729857, 2.82956604)),
        dot(a, vec4(0.10667330, 12.64194608, -60.58204836, 110.36276771)) + dot(b, vec2(-89.90310912, 27.34824973)));
}

#ifdef TEXTURES
vec3 linear(vec3 code) {
    return mix(code / 12.92, pow((code + 0.055) / 1.055, vec3(2.4)), step(0.04045, code));
}

// The inverse of toneMapped; what was clipped to white stays there.
vec3 exposedBefore(vec3 y) {
    if (bakedCurve == 1) {
        float l = luminanceOf(y);
        float b = 0.5 * WHITE * WHITE * (1.0 - l);
        return l > 0.0 ? y * (sqrt(b * b + WHITE * WHITE * l) - b) / l : y;
    }
    if (bakedCurve == 2) {
        vec3 a = 2.51 - 2.43 * y;
        vec3 b = 0.03 - 0.59 * y;
        return (sqrt(b * b + 0.56 * a * y) - b) / (2.0 * a);
    }
    return y;
}
#endif

void main() {
#ifdef TEXTURES
    vec3 radiosity = exposedBefore(linear(texture2D(image, place).rgb)) / bakedExposure;
#endif
    vec3 exposed = clamp(radiosity * exposure, 0.0, 1e6);
    if (falseColour == 1) {
        float decades = log(max(luminanceOf(exposed), 1e-9) / WHITE) / log(10.0);
        gl_FragColor = vec4(turbo(clamp(1.0 + decades / DECADES, 0.0, 1.0)), 1.0);
    } else {
        gl_FragColor = vec4(srgb(toneMapped(exposed)), 1.0);
    }
}
