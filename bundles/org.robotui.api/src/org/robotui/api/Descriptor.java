package org.robotui.api;

import java.util.List;
import java.util.Objects;
import org.robotui.api.config.Schema;
import org.robotui.api.port.Port;

/**
 * What there is to know of a type of component without an instance.
 *
 * @param id the word used in configurations, for example {@code ros} or {@code map}; unique among types of its kind
 * @param label the name that users read
 * @param help a sentence for users: what it is for
 * @param schema what it can be configured with
 * @param ports the ports that it always has; a robot interface may offer more while it runs
 */
public record Descriptor(String id, String label, String help, Schema schema, List<Port> ports) {
  /**
   * Copies the list.
   *
   * @param id the word used in configurations
   * @param label the name that users read
   * @param help what it is for
   * @param schema what it can be configured with
   * @param ports the ports that it always has
   */
  public Descriptor {
    Objects.requireNonNull(id, "id");
    Objects.requireNonNull(label, "label");
    Objects.requireNonNull(help, "help");
    Objects.requireNonNull(schema, "schema");
    ports = List.copyOf(ports);
  }
}
