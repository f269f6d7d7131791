package org.robotui.core.internal.host;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.zip.CRC32;
import org.robotui.api.config.UserFolder;

/**
 * Where core keeps what users changed.
 *
 * @param path the folder; it need not exist
 */
public record StateFolder(Path path) {
  /** The folder by the system property {@code robotui.state}, else that of the XDG base directory specification. */
  public static StateFolder of(Properties properties, Map<String, String> environment) {
    return new StateFolder(UserFolder.state(properties, environment));
  }

  /** The file for changes to one configuration: two files of one name in two folders have two. */
  Path overlay(Path configuration) {
    Path absolute = configuration.toAbsolutePath().normalize();
    CRC32 sum = new CRC32();
    sum.update(absolute.toString().getBytes(StandardCharsets.UTF_8));
    String name = absolute.getFileName().toString().replaceFirst("\\.ya?ml$", "");
    return path.resolve("overlays").resolve(name + "-" + Long.toHexString(sum.getValue()) + ".yaml");
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
