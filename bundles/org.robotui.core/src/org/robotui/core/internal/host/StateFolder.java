package org.robotui.core.internal.host;

import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
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

  /** The file for changes to one configuration: two files of one name in two folders have two. */
  Path overlay(Path configuration) {
    Path absolute = configuration.toAbsolutePath().normalize();
    String name = absolute.getFileName().toString().replaceFirst("\\.ya?ml$", "");
    return path.resolve("overlays").resolve(name + "-" + Checksum.of(absolute.toString()) + ".yaml");
  }

  /** The configuration that is kept for a file that was opened: two files of one name in two folders have two. */
  Path opened(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    String name = absolute.getFileName().toString();
    return path.resolve("opened").resolve(
        name.substring(0, Math.min(LONGEST_NAME, name.length())) + "-" + Checksum.of(absolute.toString()) + ".yaml");
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
