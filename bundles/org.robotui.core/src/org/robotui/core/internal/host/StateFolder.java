package org.robotui.core.internal.host;

import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.function.UnaryOperator;
import org.robotui.api.config.UserFolder;
import org.robotui.core.internal.config.Checksum;

/**
 * Where core keeps what users changed.
 *
 * @param path the folder; it need not exist
 */
public record StateFolder(Path path) {
  /** File systems hold 255 bytes, of which a character may take four. */
  private static final int LONGEST_NAME = 50;

  /** The folder by the system property {@code robotui.state}, else that of the XDG base directory specification. */
  public static StateFolder of(Properties properties, Map<String, String> environment) {
    return new StateFolder(UserFolder.state(properties, environment));
  }

  /** The file for changes to one configuration. */
  Path overlay(Path configuration) {
    return kept("overlays", configuration, name -> name.replaceFirst("\\.ya?ml$", ""));
  }

  /** The configuration that is kept for a file that was opened. */
  Path opened(Path file) {
    return kept("opened", file, name -> name.substring(0, Math.min(LONGEST_NAME, name.length())));
  }

  /** Two files of one name in two folders have two. */
  private Path kept(String folder, Path file, UnaryOperator<String> shorter) {
    Path absolute = file.toAbsolutePath().normalize();
    return path.resolve(folder).resolve(
        shorter.apply(absolute.getFileName().toString()) + "-" + Checksum.of(absolute.toString()) + ".yaml");
  }

  /** Where robot interfaces may keep files. */
  Path interfaces() {
    return path.resolve("interfaces");
  }

  /** Where running processes are reached, and what they would leave behind. */
  Path run() {
    return UserFolder.sockets(path);
  }

  /** The file that names bundles which held the display up. */
  Path suspects() {
    return path.resolve("suspect-bundles.txt");
  }
}
