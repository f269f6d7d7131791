package org.robotui.uic.plugins.internal.model;

import org.robotui.ui.Health;

/**
 * What the user is told of what was asked of a plugin.
 *
 * @param health the dot
 * @param text what became of it
 */
public record PluginNotice(Health health, String text) {
  /** Nothing. */
  public static final PluginNotice NOTHING = new PluginNotice(Health.NONE, "");
}
