package io.github.circles2d;

/** An OpenCL call failed. */
public final class OpenClException extends Circles2DException {
    private static final long serialVersionUID = 1L;

    private final String call;
    private final int status;

    /**
     * @param call name of the OpenCL function
     * @param status its status, a negative number
     * @param name the status in words, such as {@code CL_OUT_OF_RESOURCES}
     */
    public OpenClException(String call, int status, String name) {
        super(call + " failed: " + name + " (" + status + ")");
        this.call = call;
        this.status = status;
    }

    /** Name of the OpenCL function that failed. */
    public String call() {
        return call;
    }

    /** Its status, the number of the OpenCL specification; negative. */
    public int status() {
        return status;
    }
}
