/**
 * What readers and writers of glTF share: a cursor in a file's JSON that says what is wrong there, the lists of a file
 * that is written, a camera's rotation.
 */
package radiosity.gltf;
