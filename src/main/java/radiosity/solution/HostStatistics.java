package radiosity.solution;

/**
 * What a host has done.
 *
 * @param name     as the user calls it
 * @param state    {@code working}, {@code lost} or {@code left}
 * @param blocks   that it owns
 * @param elements that it owns
 * @param rounds   that it took part in
 * @param cpu      processor time of its rounds, s
 * @param idle     share of the time that it had nothing to do, if nothing took any but the hosts' processors
 * @param bytes    sent to it and received from it
 */
public record HostStatistics(String name, String state, int blocks, int elements, int rounds, double cpu, double idle,
                             long bytes) { }
