/**
 * A campaign against the program, {@code scripts/torture}: random scenes, options and faults, and what must hold after
 * each. It starts the program in processes of its own and reads its files by its own means, so that it can be pointed
 * at any build.
 */
package radiosity.torture;
