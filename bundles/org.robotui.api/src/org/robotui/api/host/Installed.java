package org.robotui.api.host;

import java.util.List;
import java.util.Optional;
import org.robotui.api.Descriptor;
import org.robotui.api.UicType.Surface;

/**
 * A type of component that is installed.
 *
 * @param kind what it is a type of
 * @param descriptor all that is to be known of it
 * @param bundle the bundle that brings it
 * @param surface where a view can be shown; only of views
 * @param views ids of the types of views that a RUIC of it has when nothing is set; only of RUICs
 */
public record Installed(Kind kind, Descriptor descriptor, String bundle, Optional<Surface> surface,
    List<String> views) {
  /** What types there are. */
  public enum Kind {
    /** Of robot interfaces: frameworks. */
    RFIC,
    /** Of views. */
    UIC,
    /** Of RUICs. */
    RUIC
  }

  /**
   * Copies the list.
   *
   * @param kind what it is a type of
   * @param descriptor all that is to be known of it
   * @param bundle the bundle that brings it
   * @param surface where a view can be shown
   * @param views of a RUIC
   */
  public Installed {
    views = List.copyOf(views);
  }
}
