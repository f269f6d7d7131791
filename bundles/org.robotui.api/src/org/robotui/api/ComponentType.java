package org.robotui.api;

import java.util.List;
import org.robotui.api.config.Schema;
import org.robotui.api.port.Port;

/**
 * A type of component, registered as an OSGi service under {@link RficType}, {@link UicType} or {@link RuicType} by the one
 * bundle that implements it. It is readable without an instance, immutable and safe for all threads.
 */
public interface ComponentType {
  /**
   * The word used in configurations, for example {@code ros} or {@code map}; unique among types of its kind.
   *
   * @return the id
   */
  String id();

  /**
   * The name that users read.
   *
   * @return the label
   */
  String label();

  /**
   * A sentence for users.
   *
   * @return what it is for
   */
  String help();

  /**
   * What it can be configured with.
   *
   * @return the schema
   */
  Schema schema();

  /**
   * The ports that it always has. A robot interface may offer more while it runs.
   *
   * @return the ports
   */
  List<Port> ports();
}
