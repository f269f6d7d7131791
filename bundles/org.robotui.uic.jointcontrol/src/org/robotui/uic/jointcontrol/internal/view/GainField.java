package org.robotui.uic.jointcontrol.internal.view;

import java.util.function.DoubleConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.PlainLabel;

/** A field for a stiffness or damping: Enter sets it, Esc and leaving give up. Display thread. */
final class GainField {
  private static final int WIDTH = 84;

  private final Theme theme;
  private final Composite root;
  private final Text text;
  private final PlainLabel label;
  private final String name;
  private final DoubleConsumer set;
  private String written = "";
  private String joint = "";

  GainField(Composite parent, Theme theme, String name, DoubleConsumer set) {
    this.theme = theme;
    this.name = name;
    this.set = set;
    root = Boxes.panel(parent, theme, 1);
    ((GridLayout) root.getLayout()).verticalSpacing = Theme.STEP / 2;
    root.setLayoutData(new GridData(SWT.END, SWT.CENTER, false, false));
    label = new PlainLabel(root, SWT.NONE, theme, Face.SMALL, Role.DIM);
    text = new Text(root, SWT.SINGLE | SWT.RIGHT);
    text.setFont(theme.font(Face.FIGURES));
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.widthHint = WIDTH;
    text.setLayoutData(data);
    text.addListener(SWT.DefaultSelection, e -> commit());
    text.addListener(SWT.FocusOut, e -> text.setText(written));
    text.addListener(SWT.Modify, e -> colour());
    text.addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        text.setText(written);
      }
    });
  }

  Control control() {
    return root;
  }

  Text text() {
    return text;
  }

  /** What the user types is not replaced by what the robot says, but for another joint. */
  void show(String key, double value, String unit, boolean enabled) {
    String shown = Double.isFinite(value) ? Figures.fixed(value, 2) : "";
    String words = name + ", " + unit;
    if (!words.equals(label.getText())) {
      label.setText(words);
      root.requestLayout();
    }
    boolean typing = text.isFocusControl() && !text.getText().equals(written) && key.equals(joint);
    joint = key;
    if (!typing && !shown.equals(text.getText())) {
      written = shown;
      text.setText(shown);
    }
    if (text.getEnabled() != enabled) {
      text.setEnabled(enabled);
    }
    colour();
  }

  private double number() throws Unreadable {
    return TypedText.within(text.getText(), 0, Double.MAX_VALUE, "at least 0");
  }

  private String fault() {
    try {
      number();
      return "";
    } catch (Unreadable fault) {
      return text.getText().isEmpty() ? "" : "'" + text.getText() + "' " + fault.getMessage();
    }
  }

  private void colour() {
    text.setBackground(theme.color(text.getEnabled() ? Role.GROUND : Role.PANEL));
    String fault = fault();
    text.setToolTipText(fault);
    text.setForeground(theme.color(!text.getEnabled() ? Role.DIM : fault.isEmpty() ? Role.TEXT : Role.BAD));
  }

  private void commit() {
    try {
      double value = number();
      written = text.getText();
      set.accept(value);
    } catch (Unreadable fault) {
      colour();
    }
  }
}
