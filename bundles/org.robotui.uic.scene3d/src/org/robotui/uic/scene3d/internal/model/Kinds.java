package org.robotui.uic.scene3d.internal.model;

import java.util.List;
import org.robotui.gl.display.DisplayType;
import org.robotui.ui.display.DisplayKind;

/** Kinds of displays, as lists know them. */
public final class Kinds {
  private Kinds() {}

  /** One of them. */
  public static DisplayKind of(DisplayType type) {
    return new DisplayKind(type.id(), type.label(), type.accepts(), type.needs(), type.automatic(), type.schema());
  }

  /** All of them. */
  public static List<DisplayKind> of(List<DisplayType> types) {
    return types.stream().map(Kinds::of).toList();
  }
}
