package org.robotui.core.internal.facts;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.WriteFailure;

/** {@code ./robotui support}: a process of its own that starts no framework, as that may be what fails. */
public final class SupportMain {
  private static final int FIRST_CONFIGURATION = 3;

  private SupportMain() {}

  /**
   * Writes the file, and says what is in it.
   *
   * @param arguments the state folder, where the product lies, the file, and any number of configurations
   */
  public static void main(String[] arguments) {
    System.exit(run(arguments, System.out, System.err));
  }

  static int run(String[] arguments, PrintStream out, PrintStream err) {
    Path file = Path.of(arguments[2]);
    List<Path> configurations = Arrays.stream(arguments).skip(FIRST_CONFIGURATION).map(Path::of).toList();
    try {
      List<String> contents = new SupportFile(Path.of(arguments[0]), Optional.of(Path.of(arguments[1])))
          .write(file, configurations, Map.of());
      contents.forEach(line -> out.println("  " + line));
      out.println("It is all in " + file + ", which only you can read.");
      out.println("Secrets are masked as far as their names tell them; read it before you give it away.");
      return 0;
    } catch (IOException e) {
      err.println("robotui: " + file + " cannot be written: " + WriteFailure.reason(e));
      return 1;
    }
  }
}
