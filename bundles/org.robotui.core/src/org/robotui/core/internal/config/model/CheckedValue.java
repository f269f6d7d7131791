package org.robotui.core.internal.config.model;

/** What became of one value that the user chose. */
public sealed interface CheckedValue {
  /**
   * It fits.
   *
   * @param value as {@link org.robotui.api.config.Settings} holds it
   */
  record Fits(Object value) implements CheckedValue {}

  /**
   * It does not.
   *
   * @param message what was expected
   */
  record Wrong(String message) implements CheckedValue {}
}
