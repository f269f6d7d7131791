package org.robotui.uic.plugins.internal.model;

import org.robotui.ui.Health;

/**
 * What the user is told of what was asked of a plugin.
 *
 * @param health the dot
 * @param text what became of it
 */
public record Told(Health health, String text) {
  /** Nothing. */
  public static final Told NOTHING = new Told(Health.NONE, "");
}
