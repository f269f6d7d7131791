package org.robotui.api.host;

import org.robotui.api.show.Subject;

/** Is told of changes, where {@link Host#listen} says; must not block. */
public interface HostListener {
  /** A RUIC came or went. */
  default void ruicsChanged() {}

  /**
   * State, components or matches of a RUIC changed.
   *
   * @param ruic its name
   */
  default void ruicChanged(String ruic) {}

  /**
   * A view of a selected RUIC has something new to show. An application has it painted on its display thread, once for
   * any number of calls.
   *
   * @param ruic name of the RUIC
   * @param uic id of the view
   */
  default void frameReady(String ruic, String uic) {}

  /**
   * The user wants to see another RUIC. An application shows it where it shows the one that asks.
   *
   * @param from name of the RUIC that asks
   * @param wanted name of the RUIC to show
   */
  default void showWanted(String from, String wanted) {}

  /**
   * The user wants to see something in a view. An application that shows the RUIC brings the view to the front and
   * calls {@link org.robotui.api.Uic#show}.
   *
   * @param ruic name of the RUIC
   * @param uic id of the view
   * @param showing id of what the view shall do
   * @param subject what it shall show
   */
  default void viewWanted(String ruic, String uic, String showing, Subject subject) {}

  /**
   * Something went wrong that the user should know: a component was fenced, the memory is used up.
   *
   * @param ruic name of the RUIC, empty where it concerns all
   * @param message names the bundle and the cause
   */
  default void alert(String ruic, String message) {}

  /**
   * Something concerned the application itself and soon is over, such as a display that does not answer: worth a look
   * now, not later.
   *
   * @param message what it was
   */
  default void notice(String message) {
    alert("", message);
  }

  /**
   * The file of a configuration that runs was changed. It is told at most two seconds after the change.
   *
   * @param change what is wrong with it, and what it means
   */
  default void configurationChanged(ConfigChange change) {}
}
