import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;

/**
 * Packs the jars of assembled products for a quick start (docs/adr/0022): all uncompressed, and the launcher's and the
 * framework's without their signatures.
 */
public final class Repack {
  /** The virtual machine loads these itself, and would check signatures at each start. */
  private static final String UNSIGNED =
      "(org\\.eclipse\\.equinox\\.launcher|org\\.eclipse\\.osgi|org\\.eclipse\\.osgi\\.compatibility\\.state)_.*";
  private static final String SIGNATURE = "META-INF/[^/]*\\.(SF|RSA|DSA|EC)";

  private Repack() {}

  public static void main(String[] jars) throws IOException {
    for (String jar : jars) {
      repack(Path.of(jar));
    }
  }

  private static void repack(Path jar) throws IOException {
    boolean signed = !jar.getFileName().toString().matches(UNSIGNED);
    Path packed = jar.resolveSibling(jar.getFileName() + ".packed");
    try (ZipFile from = new ZipFile(jar.toFile()); ZipOutputStream to = new ZipOutputStream(open(packed))) {
      to.setMethod(ZipOutputStream.STORED);
      for (ZipEntry entry : entries(from)) {
        if (signed || !entry.getName().matches(SIGNATURE)) {
          copy(entry, from.getInputStream(entry).readAllBytes(), to);
        }
      }
    }
    Files.move(packed, jar, StandardCopyOption.REPLACE_EXISTING);
  }

  private static List<? extends ZipEntry> entries(ZipFile zip) {
    return zip.stream().toList();
  }

  private static OutputStream open(Path file) throws IOException {
    return new BufferedOutputStream(Files.newOutputStream(file));
  }

  private static void copy(ZipEntry entry, byte[] content, ZipOutputStream to) throws IOException {
    CRC32 check = new CRC32();
    check.update(content);
    ZipEntry stored = new ZipEntry(entry.getName());
    stored.setTime(entry.getTime());
    stored.setSize(content.length);
    stored.setCrc(check.getValue());
    to.putNextEntry(stored);
    to.write(content);
    to.closeEntry();
  }
}
