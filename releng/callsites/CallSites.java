package callsites;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * Links the call sites in jars of assembled products ahead of time, for a quick start (docs/adr/0153): lambdas and
 * method references become classes, equality and hash codes of records and switches over types become plain code. What
 * it does not understand stays as it is, and is linked by the virtual machine at its first use.
 *
 * <p>{@code java callsites.CallSites NAMES JAR...} rewrites those jars whose file names match NAMES, and looks the
 * others up.
 */
public final class CallSites {
  private CallSites() {}

  public static void main(String[] arguments) throws IOException {
    String names = arguments[0];
    List<Path> jars = Stream.of(arguments).skip(1).map(Path::of).toList();
    for (List<Path> product : byFolder(jars)) {
      try (ClassIndex index = new ClassIndex(product)) {
        for (Path jar : product) {
          if (jar.getFileName().toString().matches(names)) {
            JarClasses.link(jar, index);
          }
        }
      }
    }
  }

  /** The jars of one folder see each other. */
  private static List<List<Path>> byFolder(List<Path> jars) {
    return jars.stream().map(Path::getParent).distinct()
        .map(folder -> jars.stream().filter(jar -> jar.getParent().equals(folder)).toList()).toList();
  }
}
