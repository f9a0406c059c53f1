package io.github.circles2d.opencl;

import java.lang.reflect.Field;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.nio.LongBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jocl.CL;
import org.jocl.NativePointerObject;
import org.jocl.Pointer;
import org.jocl.cl_command_queue;
import org.jocl.cl_context;
import org.jocl.cl_kernel;
import org.jocl.cl_mem;
import org.jocl.cl_program;

/**
 * An OpenCL that keeps books: which handles are alive, which were misused; and that fails the call a test names. Misuse
 * is noted and never reaches the driver, which would take the JVM down.
 */
final class FaultyClApi implements InvocationHandler {
    private static final int MISUSE = CL.CL_INVALID_MEM_OBJECT;

    private final ClApi real;
    private final Map<Object, String> live = new IdentityHashMap<>();
    private final Map<Object, Map<Integer, NativePointerObject>> kernelBuffers = new IdentityHashMap<>();
    private final Map<Object, ByteBuffer> mapped = new IdentityHashMap<>();
    private final Map<Object, Boolean> unmapped = new IdentityHashMap<>();
    private final List<String> misuses = new ArrayList<>();
    private final List<String> calls = new ArrayList<>();
    /** How often each kernel was launched. */
    private final Map<String, Integer> launched = new TreeMap<>();

    private final Map<Integer, Long> limits = new HashMap<>();
    private int failFrom = Integer.MAX_VALUE;
    private int failTo;
    private int failure;

    FaultyClApi(ClApi real) {
        this.real = real;
    }

    ClApi api() {
        return (ClApi) Proxy.newProxyInstance(ClApi.class.getClassLoader(), new Class<?>[] {ClApi.class}, this);
    }

    /** Counts from 0 again; call {@code number} (the first is 0) then fails, and with {@code lost} all later ones. */
    synchronized void fail(int number, int status, boolean lost) {
        calls.clear();
        failFrom = number;
        failTo = lost ? Integer.MAX_VALUE : number;
        failure = status;
    }

    /** Counts from 0 again; nothing fails. */
    synchronized void behave() {
        fail(Integer.MAX_VALUE, 0, false);
    }

    /** Makes devices report this value for a number such as {@code CL_DEVICE_GLOBAL_MEM_SIZE}. */
    synchronized void limit(int deviceInfo, long value) {
        limits.put(deviceInfo, value);
    }

    /** Names of the calls since the count began. */
    synchronized List<String> calls() {
        return List.copyOf(calls);
    }

    /** Kernels that ran. */
    synchronized Set<String> launched() {
        return new TreeSet<>(launched.keySet());
    }

    /** How often a kernel was launched. */
    synchronized int launches(String kernel) {
        return launched.getOrDefault(kernel, 0);
    }

    /** Handles that were created and not released, and memory that was mapped and not unmapped. */
    synchronized List<String> live() {
        return List.copyOf(live.values());
    }

    /** Releases of what was released, uses of what was released. */
    synchronized List<String> misuses() {
        return List.copyOf(misuses);
    }

    @Override
    public synchronized Object invoke(Object proxy, Method method, Object[] args) throws Throwable {
        String name = method.getName();
        if (method.getDeclaringClass() == Object.class) {
            throw new UnsupportedOperationException(name);
        }
        int number = calls.size();
        calls.add(name);
        if (misused(name, args)) {
            return answer(method, args, MISUSE);
        }
        boolean fails = number >= failFrom && number <= failTo;
        // what was to be released is lost to the library either way: these happen, and then say that they failed
        boolean happens = !fails || name.startsWith("release") || name.equals("enqueueUnmapMemObject");
        Object result = happens ? call(method, args) : null;
        if (happens) {
            keepBooks(name, args, result);
        }
        return fails ? answer(method, args, failure) : result;
    }

    private Object call(Method method, Object[] args) throws Throwable {
        try {
            return method.invoke(real, args);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    private static Object answer(Method method, Object[] args, int status) {
        if (method.getReturnType() == int.class) {
            return status;
        }
        ((int[]) args[args.length - 1])[0] = status;
        return null;
    }

    private boolean misused(String name, Object[] args) {
        int before = misuses.size();
        for (Object arg : args) {
            if (isHandle(arg) && !live.containsKey(arg)) {
                misuses.add(name + " of a released " + arg.getClass().getSimpleName());
            }
        }
        if (name.equals("releaseMemObject") && mapped.containsKey(args[0])) {
            misuses.add("release of a buffer that is mapped");
        } else if (name.equals("enqueueUnmapMemObject") && mapped.get(args[1]) != args[2]) {
            misuses.add("unmap of what is not mapped");
        } else if ((name.equals("enqueueReadBuffer") || name.equals("enqueueWriteBuffer"))
                && unmapped.containsKey(field(args[4], "buffer"))) {
            misuses.add(name + " with memory that was unmapped");
        } else if (name.equals("enqueueNDRangeKernel")) {
            kernelBuffers.getOrDefault(args[1], Map.of()).forEach((index, buffer) -> {
                if (buffer == null || !live.containsKey(buffer)) {
                    misuses.add("launch of " + live.get(args[1]) + " with a released buffer as argument " + index);
                }
            });
        }
        return misuses.size() > before;
    }

    private void keepBooks(String name, Object[] args, Object result) {
        if (isHandle(result)) {
            live.put(result, result instanceof cl_kernel ? (String) args[1] : name);
        } else if (name.startsWith("release")) {
            live.remove(args[0]);
        } else if (name.equals("enqueueMapBuffer") && result != null) {
            mapped.put(args[1], (ByteBuffer) result);
            live.put(result, name);
        } else if (name.equals("enqueueUnmapMemObject")) {
            live.remove(mapped.remove(args[1]));
            unmapped.put(args[2], true);
        } else if (name.equals("enqueueNDRangeKernel")) {
            launched.merge(live.get(args[1]), 1, Integer::sum);
        } else if (name.equals("setKernelArg")
                // local memory has a size and no pointer
                && args[3] != null
                && field(args[3], "pointers") instanceof NativePointerObject[] to) {
            kernelBuffers.computeIfAbsent(args[0], kernel -> new HashMap<>()).put((Integer) args[1], to[0]);
        } else if (name.equals("getDeviceInfo") && limits.containsKey(args[1])) {
            ((LongBuffer) field(args[3], "buffer")).put(0, limits.get(args[1]));
        }
    }

    private static boolean isHandle(Object value) {
        return value instanceof cl_context
                || value instanceof cl_command_queue
                || value instanceof cl_mem
                || value instanceof cl_program
                || value instanceof cl_kernel;
    }

    /** What JOCL's pointer points to; JOCL does not tell. */
    private static Object field(Object pointer, String name) {
        try {
            Field field = NativePointerObject.class.getDeclaredField(name);
            field.setAccessible(true);
            return field.get((Pointer) pointer);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }
}
