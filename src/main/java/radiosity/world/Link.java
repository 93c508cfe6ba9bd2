package radiosity.world;

import java.io.IOException;

/** The way to a host, before and after somebody answers there. */
interface Link {

    /** As the user calls the host. */
    String name();

    /** Looks the host up; fails in a few seconds where nobody answers. */
    RemotePartition connect() throws IOException;

    /** Ends all connections, also those on which an answer is waited for. */
    void cut();
}
