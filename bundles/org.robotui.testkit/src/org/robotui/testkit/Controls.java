package org.robotui.testkit;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;

/** What lies in a window. Display thread. */
public final class Controls {
  private Controls() {}

  /**
   * All controls of a kind, as they lie: each before what lies in it.
   *
   * @param <C> the kind
   * @param in a window, or a part of one; counts as well
   * @param type the kind
   * @return those that there are
   */
  public static <C extends Control> List<C> all(Control in, Class<C> type) {
    return everything(in).filter(type::isInstance).map(type::cast).toList();
  }

  private static Stream<Control> everything(Control in) {
    return in instanceof Composite box
        ? Stream.concat(Stream.of(in), Arrays.stream(box.getChildren()).flatMap(Controls::everything))
        : Stream.of(in);
  }
}
