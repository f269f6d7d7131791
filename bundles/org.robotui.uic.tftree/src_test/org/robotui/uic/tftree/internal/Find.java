package org.robotui.uic.tftree.internal;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Predicate;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;

/** Finds a control in a window. */
final class Find {
  private Find() {}

  static <C extends Control> Optional<C> first(Control in, Class<C> type, Predicate<C> fits) {
    if (type.isInstance(in) && fits.test(type.cast(in))) {
      return Optional.of(type.cast(in));
    }
    return in instanceof Composite box
        ? Arrays.stream(box.getChildren()).map(child -> first(child, type, fits)).flatMap(Optional::stream).findFirst() : Optional.empty();
  }
}
