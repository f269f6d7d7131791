package org.robotui.api.port;

/**
 * A port to look at what a robot has.
 *
 * @param name unique within the component
 * @param arity how many connections a view takes
 * @param help a sentence for users
 */
public record BrowsePort(String name, Arity arity, String help) implements Port {
  @Override
  public PortKind kind() {
    return PortKind.BROWSE;
  }

  @Override
  public String typeName() {
    return "Browser";
  }
}
