package io.github.circles2d;

/** Something went wrong on a device or with its driver. Subclasses say what. */
public class Circles2DException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public Circles2DException(String message) {
        super(message);
    }

    public Circles2DException(String message, Throwable cause) {
        super(message, cause);
    }
}
