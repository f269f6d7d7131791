package org.robotui.api.show;

import java.util.Optional;

/**
 * An entry of the menu of something: which view would show it, or why none does.
 *
 * @param view id of the view within its RUIC, also of one that is opened for it; empty where there can be none
 * @param title what users call the view, or its type
 * @param showing what the view would do
 * @param obstacle a few words on why it cannot be done, empty where it can
 * @param opens id of the type of the view, where the view is not open and is opened for it
 */
public record ShowChoice(String view, String title, Showing showing, String obstacle, Optional<String> opens) {
  /**
   * An entry for a view that is open, or one that cannot be done.
   *
   * @param view id of the view, or empty
   * @param title what users call the view, or its type
   * @param showing what the view would do
   * @param obstacle why it cannot be done, or empty
   */
  public ShowChoice(String view, String title, Showing showing, String obstacle) {
    this(view, title, showing, obstacle, Optional.empty());
  }

  /**
   * Whether it can be done.
   *
   * @return true where there is no obstacle
   */
  public boolean possible() {
    return obstacle.isEmpty();
  }
}
