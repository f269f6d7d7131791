package org.robotui.install;

import java.util.List;

/** What an update site answers. */
public sealed interface SiteContent {
  /**
   * It can be read.
   *
   * @param features the newest version of each feature that it offers, by name
   */
  record Offered(List<SiteFeature> features) implements SiteContent {
    /**
     * Copies the list.
     *
     * @param features by name
     */
    public Offered {
      features = List.copyOf(features);
    }
  }

  /**
   * It cannot be read.
   *
   * @param sentence why, and what to do
   */
  record Unreadable(String sentence) implements SiteContent {}
}
