package org.robotui.api.port;

/**
 * Which port of which component something came from or goes to.
 *
 * @param component id of the component within its RUIC, for example {@code base}
 * @param port name of the port, for example {@code scan}
 */
public record SourceId(String component, String port) {
  @Override
  public String toString() {
    return component + "." + port;
  }
}
