package io.github.circles2d.demo;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Saves pictures. */
final class Pictures {
    private Pictures() {}

    /** Creates the folder of a file that is about to be made, so that a bad path is known before the work and not after. */
    static void prepare(Path file) {
        try {
            Path folder = file.toAbsolutePath().getParent();
            if (!Files.isDirectory(folder)) {
                Files.createDirectories(folder);
            }
            if (Files.isDirectory(file) || !Files.isWritable(Files.exists(file) ? file : folder)) {
                throw new IOException("not a file that can be written");
            }
        } catch (IOException e) {
            throw unwritable(file, e);
        }
    }

    /** Writes a PNG. */
    static void save(BufferedImage picture, Path file) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageWriter png = ImageIO.getImageWritersByFormatName("png").next();
        ImageWriteParam smallest = png.getDefaultWriteParam();
        smallest.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        smallest.setCompressionQuality(0);
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            png.setOutput(out);
            png.write(null, new IIOImage(picture, null, null), smallest);
            out.flush();
            Files.write(file, bytes.toByteArray());
        } catch (IOException e) {
            throw unwritable(file, e);
        } finally {
            png.dispose();
        }
    }

    private static UncheckedIOException unwritable(Path file, IOException e) {
        return new UncheckedIOException("cannot write the picture " + file + ": " + e, e);
    }
}
