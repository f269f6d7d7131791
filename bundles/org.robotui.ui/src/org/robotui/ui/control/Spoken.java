package org.robotui.ui.control;

import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import org.eclipse.swt.accessibility.ACC;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleControlAdapter;
import org.eclipse.swt.accessibility.AccessibleControlEvent;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.widgets.Control;

/** What screen readers are told of painted controls. Display thread. */
public final class Spoken {
  private Spoken() {}

  /** A list with a name, of which the row in focus is read. */
  static void list(Control control, String name, Supplier<String> row) {
    role(control, () -> ACC.ROLE_LIST);
    name(control, () -> name, () -> row.get().replace('\t', ' '));
  }

  /**
   * A control of the platform with a name.
   *
   * @param control any
   * @param name what it is called
   */
  public static void name(Control control, String name) {
    name(control, () -> name, () -> "");
  }

  /** A box that is checked or not. */
  static void box(Control control, String name, BooleanSupplier checked) {
    name(control, name);
    control.getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = ACC.ROLE_CHECKBUTTON;
      }

      @Override
      public void getState(AccessibleControlEvent e) {
        e.detail = checked.getAsBoolean() ? ACC.STATE_CHECKED : ACC.STATE_NORMAL;
      }
    });
  }

  /** A field with a list of choices, of which one is chosen. */
  static void choice(Control control, String name, Supplier<String> chosen) {
    name(control, name);
    control.getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = ACC.ROLE_COMBOBOX;
      }

      @Override
      public void getValue(AccessibleControlEvent e) {
        e.result = chosen.get();
      }
    });
  }

  /** The thing in focus is another one. */
  static void changed(Control control) {
    control.getAccessible().sendEvent(ACC.EVENT_NAME_CHANGED, null);
  }

  private static void role(Control control, IntSupplier role) {
    control.getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = role.getAsInt();
      }
    });
  }

  private static void name(Control control, Supplier<String> name, Supplier<String> value) {
    control.getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        String shown = value.get();
        e.result = shown.isEmpty() ? name.get() : name.get() + ": " + shown;
      }
    });
  }
}
