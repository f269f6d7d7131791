package org.robotui.ros.reconfigure;

import java.util.List;
import java.util.Optional;

/**
 * All parameters of a server.
 *
 * @param groups in the order of the description; each parameter is in one of them
 */
public record ServerDescription(List<ConfigGroup> groups) {

  /** Copies the groups. */
  public ServerDescription {
    groups = List.copyOf(groups);
  }

  /**
   * The parameters of all groups.
   *
   * @return in the order of the description
   */
  public List<ConfigParameter> parameters() {
    return groups.stream().flatMap(group -> group.parameters().stream()).toList();
  }

  /**
   * One parameter.
   *
   * @param name its name
   * @return empty if the server has none of this name
   */
  public Optional<ConfigParameter> parameter(String name) {
    return groups.stream().flatMap(group -> group.parameters().stream()).filter(each -> each.name().equals(name))
        .findFirst();
  }
}
