package org.robotui.workbench.internal.timeline;

import java.util.function.Supplier;
import org.eclipse.swt.accessibility.ACC;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleControlAdapter;
import org.eclipse.swt.accessibility.AccessibleControlEvent;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.widgets.Control;

/** What screen readers are told of the painted parts of the timeline. Display thread only. */
final class TimeVoice {
  private TimeVoice() {}

  /** A slider with a value in words. */
  static void slider(Control control, String name, Supplier<String> value) {
    describe(control, ACC.ROLE_SLIDER, name, value);
  }

  /** A list, of which the row in focus is read. */
  static void list(Control control, String name, Supplier<String> row) {
    describe(control, ACC.ROLE_LIST, name, row);
  }

  private static void describe(Control control, int role, String name, Supplier<String> value) {
    control.getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        String now = value.get();
        e.result = now.isEmpty() ? name : name + ": " + now;
      }
    });
    control.getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = role;
      }

      @Override
      public void getValue(AccessibleControlEvent e) {
        e.result = value.get();
      }
    });
  }
}
