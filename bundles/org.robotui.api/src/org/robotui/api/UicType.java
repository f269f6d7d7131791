package org.robotui.api;

import java.util.List;
import org.robotui.api.config.Settings;
import org.robotui.api.show.Showing;

/** A type of user interface component: one view or control. */
public interface UicType extends ComponentType {
  /** Where a view can be shown. */
  enum Surface {
    /** In a window; its instances implement the contract of org.robotui.ui. */
    WINDOW,
    /** In a terminal; its instances implement {@link TextUic}. */
    TEXT,
    /** Nowhere: sound, alerts, recorders. */
    NONE
  }

  /**
   * Where its instances can be shown.
   *
   * @return the surface
   */
  Surface surface();

  /**
   * How often its instances want to be ticked at most.
   *
   * @return ticks per second
   */
  double rateHz();

  /**
   * What its instances show when a user asks for it at something in another view. It may change, for example with what
   * is installed.
   *
   * @return the entries for the menus of ports, frames and nodes; none for a view that shows only what its ports are
   * connected with
   */
  default List<Showing> showings() {
    return List.of();
  }

  /**
   * Creates an instance; must neither block nor start anything. Called on a core worker.
   *
   * @param context what core gives to the instance
   * @param settings checked against the schema
   * @return a new instance, owned by core
   */
  Uic create(UicContext context, Settings settings);
}
