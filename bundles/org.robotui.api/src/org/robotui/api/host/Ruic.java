package org.robotui.api.host;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.robotui.api.Uic;
import org.robotui.api.command.Principal;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.layout.Layout;

/** A RUIC as an application handles it. Methods return at once; work is done on core's workers. */
public interface Ruic extends RuicView {
  /**
   * Where its views lie, and what changes that.
   *
   * @return always the same
   */
  Arranging arranging();

  /**
   * Where its views in the main window lie.
   *
   * @return the layout
   */
  default Layout layout() {
    return arranging().now().layout();
  }

  /**
   * Whether it waits until it is shown for the first time, as {@code start: when_shown} has it; until then nothing of
   * it runs.
   *
   * @return how it is configured now
   */
  boolean startsShown();

  /**
   * Shows it in a window; the RUIC that the window showed before is unselected.
   *
   * @param window names the window
   */
  void select(String window);

  /**
   * Shows it no more in a window.
   *
   * @param window names the window
   */
  void unselect(String window);

  /**
   * An instance of one of its views, while it runs.
   *
   * @param id of the view
   * @return the instance, or none where it failed or is not installed
   */
  Optional<Uic> uic(String id);

  /**
   * The settings of one of its views, while it runs. What is set there is in force at the next tick of the view and
   * kept, as if the user had changed it in the view.
   *
   * @param id of the view
   * @return its settings, or none where it failed or is not installed
   */
  Optional<SettingsStore> settings(String id);

  /**
   * How many ticks one of its views has done since it was started. What its sources gave before a tick begins is what
   * the view shows after it.
   *
   * @param id of the view
   * @return a number that only rises while the view runs; 0 where it does not
   */
  long ticks(String id);

  /**
   * What users call a view.
   *
   * @param id of the view
   * @return its configured title, else the label of its type, else its id
   */
  String title(String id);

  /**
   * Reports that the surface of a view failed on the display thread; the view becomes FAILED.
   *
   * @param id of the view
   * @param reason a sentence
   */
  void surfaceFailed(String id, String reason);

  /**
   * The ports of its robot interfaces for a program that is no view.
   *
   * @param principal as whom the program gives commands
   * @return access until it is closed
   */
  PortAccess access(Principal principal);

  /**
   * How its robot interfaces are configured now.
   *
   * @return in the order of the configuration
   */
  List<InterfaceConfig> interfaces();

  /**
   * How a robot interface stands in the file, where the user has exchanged it since.
   *
   * @param id of the robot interface
   * @return as written, or none where it runs as it is written
   */
  Optional<InterfaceConfig> written(String id);

  /**
   * Tries another robot interface beside the one with its id. Nothing changes before {@link Exchange#apply}. What is
   * exchanged is kept across restarts, in place of what the file says, until the file says something else.
   *
   * @param wanted how it shall be configured
   * @return the trial; must be closed
   * @throws IllegalArgumentException where there is no robot interface of that id
   */
  Exchange exchange(InterfaceConfig wanted);

  /**
   * Ends it and starts new instances of all components, as its configuration is written now.
   *
   * @return completes when it runs again or failed
   */
  CompletionStage<RuicState> restart();

  /**
   * Starts a new instance of one failed component.
   *
   * @param id of the component
   */
  void restart(String id);

  /**
   * Ends it and takes it away.
   *
   * @return completes when nothing of it is left
   */
  CompletionStage<RuicState> remove();
}
