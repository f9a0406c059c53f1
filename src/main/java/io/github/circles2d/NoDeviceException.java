package io.github.circles2d;

/** The device that was asked for by name is not on this machine; the message lists those that are. */
public final class NoDeviceException extends Circles2DException {
    private static final long serialVersionUID = 1L;

    public NoDeviceException(String message) {
        super(message);
    }
}
