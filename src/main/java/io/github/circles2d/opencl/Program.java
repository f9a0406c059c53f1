package io.github.circles2d.opencl;

import io.github.circles2d.KernelBuildException;
import io.github.circles2d.OpenClException;
import io.github.circles2d.pipeline.KernelSources;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.jocl.CL;
import org.jocl.cl_program;

/** A program made from kernel files: owns its {@code cl_program}. */
final class Program implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");
    private static final String OPTIONS = "-cl-std=CL1.2";
    private static final String ROUNDED = " -cl-fp32-correctly-rounded-divide-sqrt";

    private final Session session;
    private final cl_program program;

    private Program(Session session, cl_program program) {
        this.session = session;
        this.program = program;
        session.own(this);
    }

    /**
     * Compiles files of {@code kernels/} and other sources, in the order given.
     *
     * @param defines macros that go before everything
     * @param sources the text of each part by its file name, which the compiler's messages use
     * @throws KernelBuildException if they do not compile
     */
    static Program build(Session session, Map<String, Integer> defines, List<Map.Entry<String, String>> sources) {
        return build(session, "", defines, sources);
    }

    /**
     * The same with more options for the compiler, each after a space. A build that fails without an error to show is tried again, {@link
     * Tuning#BUILDS} times in all: PoCL 3.1 fails one of some sixty where a dozen processes compile at once.
     */
    static Program build(
            Session session, String more, Map<String, Integer> defines, List<Map.Entry<String, String>> sources) {
        for (int builds = 1; ; builds++) {
            try {
                return once(session, more, defines, sources);
            } catch (KernelBuildException e) {
                if (builds == Tuning.BUILDS || e.log().toLowerCase(Locale.ROOT).contains("error")) {
                    throw e;
                }
                LOG.log(System.Logger.Level.INFO, "kernels are compiled again: {0}", e.getMessage());
            }
        }
    }

    private static Program once(
            Session session, String more, Map<String, Integer> defines, List<Map.Entry<String, String>> sources) {
        List<String> parts = new ArrayList<>();
        StringBuilder head = new StringBuilder();
        // in one order, by which a driver that keeps what it has compiled knows it again
        new TreeMap<>(defines)
                .forEach((name, value) -> head.append("#define ")
                        .append(name)
                        .append(' ')
                        .append(value)
                        .append('\n'));
        parts.add(head.toString());
        sources.forEach(source -> parts.add("#line 1 \"" + source.getKey() + "\"\n" + source.getValue() + "\n"));
        int[] status = new int[1];
        cl_program created = session.api.createProgramWithSource(session.context, parts.toArray(String[]::new), status);
        Cl.check("clCreateProgramWithSource", status[0]);
        Program program = new Program(session, created);
        try {
            program.build(more);
        } catch (RuntimeException e) {
            program.close();
            throw e;
        }
        return program;
    }

    /** A file of {@code kernels/}, to be compiled. */
    static Map.Entry<String, String> file(String name) {
        return Map.entry(name, KernelSources.read(name));
    }

    /**
     * A file of {@code kernels/} whose functions other files use, without its kernels, which are functions then: what nobody calls costs
     * a compiler next to nothing.
     */
    static Map.Entry<String, String> functions(String name) {
        Map.Entry<String, String> file = file(name);
        return Map.entry(
                name, "#define __kernel static\n#line 1 \"" + name + "\"\n" + file.getValue() + "\n#undef __kernel");
    }

    private void build(String more) {
        OpenClDevice device = session.device;
        String options = OPTIONS
                + (device.correctlyRounded ? ROUNDED : "")
                + more
                + System.getProperty("circles2d.buildOptions", "");
        int status = session.api.buildProgram(program, device.id, options);
        SignalCanary.handBack();
        if (status == CL.CL_BUILD_PROGRAM_FAILURE) {
            throw new KernelBuildException(device.name(), options, log());
        }
        Cl.check("clBuildProgram", status);
    }

    private String log() {
        try {
            return OpenClDevices.text(
                    "clGetProgramBuildInfo",
                    (n, p, m) -> session.api.getProgramBuildInfo(
                            program, session.device.id, CL.CL_PROGRAM_BUILD_LOG, n, p, m));
        } catch (OpenClException e) {
            return "(no log, by an error: " + e.getMessage() + ")";
        }
    }

    cl_program program() {
        return program;
    }

    @Override
    public void close() {
        session.disown(this);
        Cl.checkRelease("clReleaseProgram", session.api.releaseProgram(program));
    }
}
