package org.robotui.core.internal.config.model;

import java.util.List;
import org.robotui.api.config.Settings;
import org.robotui.api.host.Problem;

/** What became of written values. */
public sealed interface CheckedSettings {
  /**
   * They fit.
   *
   * @param settings the values with fallbacks
   */
  record Valid(Settings settings) implements CheckedSettings {}

  /**
   * They do not.
   *
   * @param problems at least one
   */
  record Invalid(List<Problem> problems) implements CheckedSettings {}
}
