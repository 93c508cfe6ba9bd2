package radiosity.cli;

/** Whether somebody wants the calculation to end after the current round. */
final class StopRequest {

    private volatile boolean made;

    void make() {
        made = true;
    }

    boolean made() {
        return made;
    }
}
