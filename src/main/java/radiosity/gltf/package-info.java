/**
 * What reading and writing of glTF share: a place in a file's JSON that says what is wrong there, the lists that are
 * written, a camera's rotation.
 */
package radiosity.gltf;
