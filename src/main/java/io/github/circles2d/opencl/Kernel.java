package io.github.circles2d.opencl;

import org.jocl.CL;
import org.jocl.Pointer;
import org.jocl.Sizeof;
import org.jocl.cl_kernel;

/**
 * One launch site: owns a {@code cl_kernel} whose arguments and range are set once, so that a launch costs one call, or two where
 * numbers in an argument have changed, and allocates nothing.
 */
final class Kernel implements AutoCloseable {
    private final Session session;
    private final String name;
    private final cl_kernel kernel;
    private final int maxGroup;
    private final long[] offset = new long[1];
    private final long[] global = new long[1];
    private final long[] local = new long[1];
    private long items;
    private long itemsPerLaunch;
    /** How many arguments {@link #arguments} set. */
    private int set;
    /** Where an argument is that changes from launch to launch. */
    private final float[] number = new float[1];

    private final Pointer toNumber = Pointer.to(number);
    private final int[] whole = new int[1];
    private final Pointer toWhole = Pointer.to(whole);
    /** What {@link #more} has set since {@link #arguments}, and whether it has: a call of the driver costs a third of a launch. */
    private float first;

    private float second;
    private boolean current;
    /** The world among the arguments, or null; where it is, and which version of it was set. */
    private WorldArgument world;

    private int worldAt;
    private int worldVersion;

    Kernel(Session session, Program program, String name) {
        this.session = session;
        this.name = name;
        int[] status = new int[1];
        kernel = session.api.createKernel(program.program(), name, status);
        Cl.check("clCreateKernel(" + name + ")", status[0]);
        session.own(this);
        // a kernel that says its size has that one, and drivers may name another as the largest
        int said = workGroup(CL.CL_KERNEL_COMPILE_WORK_GROUP_SIZE, 3);
        maxGroup = said > 0 ? said : workGroup(CL.CL_KERNEL_WORK_GROUP_SIZE, 1);
    }

    private int workGroup(int what, int numbers) {
        long[] value = new long[numbers];
        Cl.check(
                "clGetKernelWorkGroupInfo",
                session.api.getKernelWorkGroupInfo(
                        kernel, session.device.id, what, (long) Sizeof.size_t * numbers, Pointer.to(value)));
        return (int) Math.min(Integer.MAX_VALUE, value[0]);
    }

    /** Local memory of a work-group, as an argument. */
    record Local(long bytes) {}

    /**
     * Sets every argument, in order: {@link DeviceBuffer}, {@link Local}, {@code Integer}, {@code Long}, {@code Float},
     * {@code float[]} (a vector), {@link WorldArgument}, {@code Object[]} (several arguments).
     */
    Kernel arguments(Object... values) {
        set = set(0, values);
        current = false;
        return this;
    }

    /** Sets the arguments that come after those of {@link #arguments}, unless they are so already. Allocates nothing. */
    void more(float newFirst, float newSecond) {
        if (current && first == newFirst && second == newSecond) {
            return;
        }
        current = false;
        number[0] = newFirst;
        set(set, Sizeof.cl_float, toNumber);
        number[0] = newSecond;
        set(set + 1, Sizeof.cl_float, toNumber);
        first = newFirst;
        second = newSecond;
        current = true;
    }

    /** Sets the argument that comes after those of {@link #arguments}, unless it is so already. Allocates nothing. */
    void more(int value) {
        if (current && whole[0] == value) {
            return;
        }
        current = false;
        whole[0] = value;
        set(set, Sizeof.cl_int, toWhole);
        current = true;
    }

    /** Work-items of a group. */
    int group() {
        return (int) local[0];
    }

    /** Groups of a launch. */
    long groups() {
        return items / local[0];
    }

    private int set(int from, Object... values) {
        int i = from;
        for (Object value : values) {
            if (value instanceof Object[] several) {
                i = set(i, several);
                continue;
            }
            if (value instanceof DeviceBuffer buffer) {
                set(i, Sizeof.cl_mem, Pointer.to(buffer.memory()));
            } else if (value instanceof Local memory) {
                set(i, memory.bytes(), (Pointer) null);
            } else if (value instanceof Integer number) {
                set(i, Sizeof.cl_int, Pointer.to(new int[] {number}));
            } else if (value instanceof Long number) {
                set(i, Sizeof.cl_long, Pointer.to(new long[] {number}));
            } else if (value instanceof Float number) {
                set(i, Sizeof.cl_float, Pointer.to(new float[] {number}));
            } else if (value instanceof float[] vector) {
                set(i, (long) Sizeof.cl_float * vector.length, Pointer.to(vector));
            } else if (value instanceof WorldArgument argument) {
                world = argument;
                worldAt = i;
                setWorld();
            } else {
                throw new IllegalArgumentException("argument " + i + " of " + name + " = " + value);
            }
            i++;
        }
        return i;
    }

    private void setWorld() {
        set(worldAt, world.bytes(), world.pointer());
        worldVersion = world.version();
    }

    private void set(int index, long size, Pointer value) {
        int status = session.api.setKernelArg(kernel, index, size, value);
        if (status != CL.CL_SUCCESS) {
            Cl.check("clSetKernelArg(" + name + ", " + index + ")", status);
        }
    }

    /**
     * Sets what a launch covers.
     *
     * @param count work-items that have work; 0 or more
     * @param group work-items of a group; less where the kernel allows less
     */
    Kernel range(long count, int group) {
        return range(count, group, Long.MAX_VALUE);
    }

    /** As {@link #range(long, int)}, in launches of at most {@code perLaunch} work-items. */
    Kernel range(long count, int group, long perLaunch) {
        int size = Math.max(1, Math.min(group, maxGroup));
        local[0] = size;
        session.compiles = true;
        items = (count + size - 1) / size * size;
        itemsPerLaunch = Math.max(size, perLaunch / size * size);
        return this;
    }

    /** Sets that a launch covers so many work-groups, whatever their size; {@code group} as for {@link #range(long, int)}. */
    Kernel groups(long groups, int group) {
        return range(groups * Math.max(1, Math.min(group, maxGroup)), group);
    }

    void launch() {
        launchItems(items);
    }

    /** Launches at most so many groups, of a kernel that goes round for the others. */
    void launch(long groups) {
        launchItems(Math.min(items, groups * local[0]));
    }

    private void launchItems(long count) {
        if (world != null && worldVersion != world.version()) {
            setWorld();
        }
        for (offset[0] = 0; offset[0] < count; offset[0] += itemsPerLaunch) {
            global[0] = Math.min(itemsPerLaunch, count - offset[0]);
            int status = session.api.enqueueNDRangeKernel(session.queue, kernel, offset, global, local);
            if (status != CL.CL_SUCCESS) {
                Cl.check("clEnqueueNDRangeKernel(" + name + ")", status);
            }
        }
    }

    @Override
    public void close() {
        session.disown(this);
        Cl.checkRelease("clReleaseKernel(" + name + ")", session.api.releaseKernel(kernel));
    }
}
