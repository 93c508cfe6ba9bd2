/**
 * Reads Wavefront OBJ files and the material libraries (MTL) that they name.
 *
 * <p>{@link radiosity.input.obj.ObjReader} is the way in; no state is kept between two scenes.
 */
package radiosity.input.obj;
