package org.robotui.api.host;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.layout.Arrangement;

/**
 * How the views of one RUIC are arranged: as its configuration says, or as the user has arranged them since. What the
 * user arranges holds at once, is kept across restarts, and lies beside the configuration, which stays as it is. Safe
 * for all threads; never blocks.
 */
public interface Arranging {
  /**
   * How the views are arranged now.
   *
   * @return before the RUIC runs for the first time, what is known of it then
   */
  Arrangement now();

  /**
   * How they would be if nobody had arranged them.
   *
   * @return the layout of the configuration, else that of the RUIC's type
   */
  Arrangement written();

  /**
   * Arranges the views. Those that lie nowhere end, and those that come are started; all others go on.
   *
   * @param wanted names of views that the RUIC cannot have are left out
   */
  void arrange(Arrangement wanted);

  /** Forgets what the user has arranged, so that the configuration holds again. */
  void reset();

  /**
   * All views that have a place or could have one: those of the configuration and those that the user has added.
   *
   * @return in the order of the configuration, then in that in which they were added
   */
  List<ViewChoice> views();

  /**
   * The types of views that are installed, and how well each fits what the robots of this RUIC offer now. Looks at
   * every port.
   *
   * @return those that fit first
   */
  List<ViewFit> types();

  /**
   * An id that no view has yet.
   *
   * @param type id of the type of the view
   * @return for example {@code plot-2}
   */
  String freshId(String type);

  /**
   * The arrangements that have a name.
   *
   * @return by name, sorted
   */
  Map<String, Perspective> perspectives();

  /**
   * The perspective that was chosen or kept last.
   *
   * @return its name, or none
   */
  Optional<String> perspective();

  /**
   * Gives the present arrangement a name; one of that name before is replaced.
   *
   * @param name what users call it; not blank, at most 60 characters
   * @throws IllegalArgumentException where the name is none
   */
  void keep(String name);

  /**
   * Arranges the views as a perspective has them.
   *
   * @param name of one of {@link #perspectives}; does nothing where there is none
   */
  void choose(String name);

  /**
   * Gives a perspective that the user has kept another name.
   *
   * @param name of the perspective
   * @param next its new name; not blank, at most 60 characters
   * @throws IllegalArgumentException where the name is none, or another perspective has it
   */
  void rename(String name, String next);

  /**
   * Forgets a perspective that the user has kept; one of the configuration stays.
   *
   * @param name of the perspective
   */
  void forget(String name);

  /**
   * A perspective as a file for others: where its views lie, of which types they are, and their settings.
   *
   * @param name of one of {@link #perspectives}
   * @return YAML, or none where there is no such perspective
   */
  Optional<String> export(String name);

  /**
   * Takes a perspective from a file of another RUIC or another user, and keeps it; nothing is arranged.
   *
   * @param text as {@link #export} made it
   * @return what has become of it
   */
  PerspectiveImport take(String text);

  /**
   * A view that has a place or could have one.
   *
   * @param id within the RUIC
   * @param type id of its type
   * @param title what users call it
   * @param open whether it has a place now
   */
  record ViewChoice(String id, String type, String title, boolean open) {}

  /**
   * An arrangement that has a name.
   *
   * @param arrangement where the views lie
   * @param written whether it stands in the configuration
   */
  record Perspective(Arrangement arrangement, boolean written) {}

  /** What has become of a perspective that was read. */
  sealed interface PerspectiveImport {
    /**
     * It is kept.
     *
     * @param name its name; another than in the file where there was one of that name
     * @param missing a sentence for each view that this RUIC cannot have
     */
    record Kept(String name, List<String> missing) implements PerspectiveImport {}

    /**
     * It is not a perspective.
     *
     * @param reason a sentence for users
     */
    record Refused(String reason) implements PerspectiveImport {}
  }
}
