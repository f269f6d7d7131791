package org.robotui.data.command;

import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.Late;

/**
 * A command that keeps something moving, so that it can be limited and stopped without knowing what moves.
 *
 * @param <T> the type itself
 */
@Delivery(late = Late.NONE)
public interface Motion<T extends Motion<T>> extends Data {
  /**
   * The command of the same kind that stops.
   *
   * @return zero motion
   */
  T stopped();

  /**
   * The same motion, scaled down where it exceeds the limits, its direction kept.
   *
   * @param limits the limits
   * @return a motion within them
   */
  T within(MotionLimits limits);
}
