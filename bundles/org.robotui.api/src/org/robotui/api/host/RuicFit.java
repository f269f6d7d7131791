package org.robotui.api.host;

import java.util.List;

/**
 * How well a type of RUIC covers what a robot offers.
 *
 * @param type its id
 * @param label the name that users read
 * @param help what it is for
 * @param views the types of the views that it brings into a window, in the order of its layout
 * @param score from 0 to 1: how many of the views that fit it brings, and how few others
 * @param reason a sentence for users
 */
public record RuicFit(String type, String label, String help, List<String> views, double score, String reason) {
  /**
   * Copies the list.
   *
   * @param type its id
   * @param label the name
   * @param help what it is for
   * @param views types of views
   * @param score from 0 to 1
   * @param reason a sentence
   */
  public RuicFit {
    views = List.copyOf(views);
  }
}
