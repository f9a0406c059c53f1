package io.github.circles2d;

/**
 * A world needs more room than the device, or Java, can give; the message has the numbers. Met while circles are added or
 * uploaded, it leaves the world as it was; met while a step makes room for its contacts or puts them in order, the world has failed.
 */
public final class CapacityException extends Circles2DException {
    private static final long serialVersionUID = 1L;

    public CapacityException(String message) {
        super(message);
    }
}
