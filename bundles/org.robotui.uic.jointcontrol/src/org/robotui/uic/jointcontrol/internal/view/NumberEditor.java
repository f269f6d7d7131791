package org.robotui.uic.jointcontrol.internal.view;

import java.util.Optional;
import java.util.function.DoubleConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.input.Unreadable;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A number edited where it stands: Enter sets it, Esc and leaving give up, so that nothing moves by looking away.
 * Display thread.
 */
final class NumberEditor {
  private final Composite parent;
  private final Theme theme;
  private Optional<Text> field = Optional.empty();

  NumberEditor(Composite parent, Theme theme) {
    this.parent = parent;
    this.theme = theme;
  }

  /**
   * Opens it.
   *
   * @param at where
   * @param before what stands in it; all selected, unless the user has begun to type
   * @param typed what the user has begun to type, or empty
   * @param read reads a number
   * @param set what is done with it
   */
  void open(Rectangle at, String before, String typed, Reading read, DoubleConsumer set) {
    cancel();
    Text text = new Text(parent, SWT.SINGLE | SWT.RIGHT);
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    text.setText(typed.isEmpty() ? before : typed);
    if (typed.isEmpty()) {
      text.selectAll();
    } else {
      text.setSelection(typed.length());
    }
    int height = Math.min(at.height, text.computeSize(SWT.DEFAULT, SWT.DEFAULT).y);
    text.setBounds(at.x, at.y + (at.height - height) / 2, at.width, height);
    text.addListener(SWT.Modify, e -> take(text, read, value -> {}));
    text.addListener(SWT.KeyDown, e -> key(e, text, read, set));
    text.addListener(SWT.Traverse, e -> e.doit = false);
    text.addListener(SWT.FocusOut, e -> parent.getDisplay().asyncExec(() -> left(text)));
    field = Optional.of(text);
    text.setFocus();
  }

  Optional<Text> field() {
    return field;
  }

  void cancel() {
    Optional<Text> gone = field;
    field = Optional.empty();
    gone.filter(text -> !text.isDisposed()).ifPresent(Control::dispose);
  }

  private void left(Text text) {
    if (field.filter(now -> now == text).isPresent()) {
      cancel();
    }
  }

  /** The focus goes back before the field does, so that it is never seen to leave the view. */
  private void leave() {
    parent.forceFocus();
    cancel();
  }

  private void key(Event event, Text text, Reading read, DoubleConsumer set) {
    if (event.keyCode == SWT.ESC) {
      event.doit = false;
      leave();
    } else if (event.keyCode == SWT.CR || event.keyCode == SWT.KEYPAD_CR) {
      event.doit = false;
      take(text, read, value -> {
        leave();
        set.accept(value);
      });
    }
  }

  /** Hands on what can be read, and says of anything else what is wrong. */
  private void take(Text text, Reading read, DoubleConsumer set) {
    try {
      double value = read.read(text.getText());
      text.setForeground(theme.color(Role.TEXT));
      text.setToolTipText(null);
      set.accept(value);
    } catch (Unreadable fault) {
      text.setForeground(theme.color(Role.BAD));
      text.setToolTipText("'" + text.getText() + "' " + fault.getMessage());
    }
  }

  /** How a number is read. */
  interface Reading {
    double read(String typed) throws Unreadable;
  }
}
