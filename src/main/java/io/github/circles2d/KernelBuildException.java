package io.github.circles2d;

/** A driver would not compile the kernels; most often the source of a caller's own {@link IndexStrategy}. */
public final class KernelBuildException extends Circles2DException {
    private static final long serialVersionUID = 1L;
    private static final int LOG_IN_MESSAGE = 4096;

    private final String log;

    /**
     * @param device name of the device
     * @param options the build options
     * @param log what the compiler said, whole
     */
    public KernelBuildException(String device, String options, String log) {
        super("the kernels do not compile on " + device + " with options \"" + options + "\":\n"
                + log.substring(0, Math.min(log.length(), LOG_IN_MESSAGE)));
        this.log = log;
    }

    /** What the compiler said, whole; it can hold paths of this machine. */
    public String log() {
        return log;
    }
}
