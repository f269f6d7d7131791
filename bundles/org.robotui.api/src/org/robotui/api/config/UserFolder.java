package org.robotui.api.config;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;

/** Where RobotUI keeps what belongs to one user of a machine. */
public final class UserFolder {
  private UserFolder() {}

  /**
   * The folder for what is kept from one start to the next, by the system property {@code robotui.state}, else by the
   * XDG base directory specification.
   *
   * @param properties of the system
   * @param environment of the process
   * @return the folder; it need not exist
   */
  public static Path state(Properties properties, Map<String, String> environment) {
    return Optional.ofNullable(properties.getProperty("robotui.state")).filter(s -> !s.isBlank()).map(Path::of)
        .orElseGet(() -> Optional.ofNullable(environment.get("XDG_STATE_HOME")).filter(s -> s.startsWith("/"))
            .map(Path::of).orElse(Path.of(properties.getProperty("user.home", "."), ".local", "state"))
            .resolve("robotui"));
  }

  /**
   * The folder of the sockets by which running processes of this user are reached.
   *
   * @param state as {@link #state} gives it
   * @return the folder; it need not exist
   */
  public static Path sockets(Path state) {
    return state.resolve("run");
  }
}
