package org.robotui.roblets.body;

import java.util.Optional;

/**
 * A message came into the bodymap. It may say the same as the one before: roblets speak whether there is something new
 * or not.
 *
 * @param roblet who said it
 * @param before what it said by this name before
 * @param now what it says
 * @param body the whole body with it
 */
public record BodyChange(String roblet, Optional<BodyEntry> before, BodyEntry now, BodySnapshot body) {
  /**
   * Whether it says something else than before.
   *
   * @return false where only time has passed
   */
  public boolean isNews() {
    return before.isEmpty() || !before.get().element().equals(now.element());
  }
}
