package org.robotui.ros.reconfigure;

import java.util.List;

/**
 * Parameters that belong together. Groups form a tree by their numbers; what a server sends need not be one.
 *
 * @param name its name; {@code Default} for the outermost
 * @param type how a form shows it: {@code collapse}, {@code tab}, {@code hide}, {@code apply} or empty
 * @param id its number, unique at the server
 * @param parent the number of the group that holds it; its own for the outermost
 * @param parameters what is in it, in the order of the description
 */
public record ConfigGroup(String name, String type, int id, int parent, List<ConfigParameter> parameters) {

  /** Copies the parameters. */
  public ConfigGroup {
    parameters = List.copyOf(parameters);
  }
}
