package org.robotui.condition;

import org.robotui.api.port.SourceId;

/**
 * A port as it is named in a condition: {@code battery}, {@code /battery} or {@code base.battery}.
 *
 * @param text the name
 */
public record SourceName(String text) {
  /**
   * Whether a port is meant.
   *
   * @param id the port of a component
   * @return true where this is its name, with or without the component, and with or without the slash of a topic
   */
  public boolean fits(SourceId id) {
    String port = bare(id.port());
    String component = id.component() + ".";
    return bare(text).equals(port)
        || text.startsWith(component) && bare(text.substring(component.length())).equals(port);
  }

  private static String bare(String name) {
    return name.startsWith("/") ? name.substring(1) : name;
  }
}
