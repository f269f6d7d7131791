package org.robotui.api;

import java.util.List;
import org.robotui.api.config.Schema;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Port;

/**
 * A type of component, registered as an OSGi service under {@link RficType}, {@link UicType} or {@link RuicType} by the
 * one bundle that implements it. It is readable without an instance, immutable and safe for all threads.
 */
public interface ComponentType {
  /**
   * All that is to be known of the type.
   *
   * @return always the same
   */
  Descriptor descriptor();

  /**
   * The word used in configurations.
   *
   * @return {@link Descriptor#id()}
   */
  default String id() {
    return descriptor().id();
  }

  /**
   * The name that users read.
   *
   * @return {@link Descriptor#label()}
   */
  default String label() {
    return descriptor().label();
  }

  /**
   * A sentence for users.
   *
   * @return {@link Descriptor#help()}
   */
  default String help() {
    return descriptor().help();
  }

  /**
   * What it can be configured with.
   *
   * @return {@link Descriptor#schema()}
   */
  default Schema schema() {
    return descriptor().schema();
  }

  /**
   * The same for forms, with what there is to choose from at present, such as kinds of layers that are installed. What
   * it allows is what {@link #schema()} allows. May start what is installed, and is called on a worker.
   *
   * @return {@link #schema()} where nothing is to be chosen
   */
  default Schema choices() {
    return schema();
  }

  /**
   * Judges settings that fit the schema: what the schema cannot say, such as whether the files that they name are
   * there. May read files, and is called on a worker whenever a configuration is read.
   *
   * @param settings checked against the schema
   * @return what is wrong; a component of this type is not made of such settings
   */
  default List<SettingFault> faults(Settings settings) {
    return List.of();
  }

  /**
   * The ports that it always has.
   *
   * @return {@link Descriptor#ports()}
   */
  default List<Port> ports() {
    return descriptor().ports();
  }
}
