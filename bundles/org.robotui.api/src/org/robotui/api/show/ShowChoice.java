package org.robotui.api.show;

/**
 * An entry of the menu of something: which view would show it, or why none does.
 *
 * @param view id of the view within its RUIC, empty where the RUIC has none of the type
 * @param title what users call the view, or its type
 * @param showing what the view would do
 * @param obstacle a few words on why it cannot be done, empty where it can
 */
public record ShowChoice(String view, String title, Showing showing, String obstacle) {
  /**
   * Whether it can be done.
   *
   * @return true where there is no obstacle
   */
  public boolean possible() {
    return obstacle.isEmpty();
  }
}
