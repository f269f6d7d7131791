package org.robotui.api.bridge;

import java.util.Optional;
import org.robotui.data.Data;

/**
 * Makes of the values of one robot those of another one; neither robot interface knows of it. An OSGi service, which
 * configurations name by its id. Safe for all threads; must not block.
 */
public interface BridgeTransform {
  /** Which way values go. */
  enum Direction {
    /** As the bridge is written. */
    FORTH,
    /** The other way of a bridge that carries both ways. */
    BACK
  }

  /**
   * By what a configuration names it.
   *
   * @return letters, digits, {@code _} and {@code -}
   */
  String id();

  /**
   * What it does.
   *
   * @return a sentence for users
   */
  String help();

  /**
   * Transforms a value.
   *
   * @param value of the robot that says it, its frames named for the other one already
   * @param direction which way it goes
   * @return the value for the other robot, or none where this one is not to pass
   * @throws IllegalArgumentException with a reason where such values cannot be transformed
   */
  Optional<Data> apply(Data value, Direction direction);
}
