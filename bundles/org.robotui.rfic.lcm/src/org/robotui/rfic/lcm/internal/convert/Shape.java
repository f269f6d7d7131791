package org.robotui.rfic.lcm.internal.convert;

import org.robotui.data.Data;
import org.robotui.rfic.lcm.internal.language.Form;
import org.robotui.rfic.lcm.internal.language.Values;

/**
 * A data type that messages may become.
 *
 * @param <D> the data type
 * @param form its fields
 * @param data the data type
 * @param make makes a value
 */
public record Shape<D extends Data>(Form form, Class<D> data, Make<D> make) {
  /**
   * Makes values.
   *
   * @param <D> the data type
   */
  @FunctionalInterface
  public interface Make<D> {
    /**
     * Makes a value.
     *
     * @param values the fields of a message
     * @param reception what else is known of it
     * @return the value
     * @throws IllegalArgumentException where the message is not what it should be
     */
    D of(Values values, Reception reception);
  }
}
