package org.robotui.uic.parameters.internal.model;

import org.robotui.ui.Health;

/**
 * What became of the last thing that the user did.
 *
 * @param health the dot
 * @param text a sentence, empty where there is nothing to tell
 */
public record ParameterNotice(Health health, String text) {
  /** Nothing was done yet. */
  public static final ParameterNotice NOTHING = new ParameterNotice(Health.NONE, "");
}
