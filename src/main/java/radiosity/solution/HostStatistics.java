package radiosity.solution;

/**
 * Work done by one host.
 *
 * @param name     name by which the user calls the host
 * @param state    {@code working}, {@code lost} or {@code left}
 * @param blocks   number of blocks that the host owns
 * @param elements number of elements that the host owns
 * @param rounds   number of orders that the host has carried out
 * @param cpu      processor time of these orders, s
 * @param idle     share of time in which the host waited for others, in [0, 1], if network and master took no time
 * @param bytes    number of bytes sent to the host and received from it
 */
public record HostStatistics(String name, String state, int blocks, int elements, int rounds, double cpu, double idle,
                             long bytes) { }
