package org.robotui.uic.parameters.internal.model;

import java.util.Optional;
import org.robotui.api.port.Browser.Tunable;

/**
 * A setting as the form shows it.
 *
 * @param tunable the setting as the program has it
 * @param value the value shown: what the user last set, or what the program has
 * @param pending whether the program has not answered to it yet
 * @param problem why it could not be set, none where all is well
 */
public record Knob(Tunable tunable, Object value, boolean pending, Optional<String> problem) {
  /** Whether it has its default. */
  public boolean isDefault() {
    return value.equals(tunable.fallback());
  }
}
