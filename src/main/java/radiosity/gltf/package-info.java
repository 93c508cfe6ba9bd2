/**
 * What readers and writers of glTF share: a cursor in a file's JSON, the lists of a written file, a camera's pose.
 */
package radiosity.gltf;
