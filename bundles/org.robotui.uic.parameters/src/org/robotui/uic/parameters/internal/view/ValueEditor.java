package org.robotui.uic.parameters.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.input.Unreadable;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.PopupMenu;
import org.robotui.uic.parameters.internal.model.ParameterNotice;
import org.robotui.uic.parameters.internal.model.ParameterRow;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.model.ValueReader;
import org.robotui.uic.parameters.internal.model.ValueText;

/**
 * Edits a value where it stands: Enter sets it, Esc and leaving give up, so that nothing is set by looking away. A text
 * of several lines has a field of several, which Ctrl+Enter sets; a truth value is chosen from a menu. Display thread.
 */
final class ValueEditor {
  private static final int LONGEST = 200_000;
  private static final int LINES_HEIGHT = 168;

  private final Composite parent;
  private final Theme theme;
  private final ParametersModel model;
  private Optional<Text> field = Optional.empty();

  ValueEditor(Composite parent, Theme theme, ParametersModel model) {
    this.parent = parent;
    this.theme = theme;
    this.model = model;
  }

  void open(ParameterRow row, Rectangle at) {
    cancel();
    Object value = row.value().orElse("");
    if (value instanceof Boolean flag) {
      choose(row, flag, at);
    } else {
      type(row, value, at);
    }
  }

  Optional<Text> field() {
    return field;
  }

  void cancel() {
    Optional<Text> gone = field;
    field = Optional.empty();
    gone.ifPresent(Text::dispose);
  }

  private void choose(ParameterRow row, boolean now, Rectangle at) {
    PopupMenu menu = new PopupMenu(parent);
    for (boolean value : new boolean[]{true, false}) {
      menu.radio(Boolean.toString(value), value == now, () -> {
        if (value != now) {
          model.set(row.key(), value);
        }
      });
    }
    menu.open(parent.toDisplay(at.x, at.y + at.height));
  }

  private void type(ParameterRow row, Object value, Rectangle at) {
    String before = ValueText.of(value);
    if (before.length() > LONGEST) {
      model.tell(Health.WARNING, "It is too long to be edited here, with " + before.length() + " characters");
      return;
    }
    boolean lines = value instanceof String && before.indexOf('\n') >= 0;
    Text text = new Text(parent, lines ? SWT.MULTI | SWT.V_SCROLL | SWT.H_SCROLL : SWT.SINGLE);
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    text.setText(before);
    text.selectAll();
    place(text, at, lines);
    text.addListener(SWT.Modify, e -> check(text, value));
    text.addListener(SWT.KeyDown, e -> key(e, row, text, value));
    text.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    text.addListener(SWT.FocusOut, e -> parent.getDisplay().asyncExec(() -> left(text)));
    field = Optional.of(text);
    text.setFocus();
  }

  private void place(Text text, Rectangle at, boolean lines) {
    if (lines) {
      int room = parent.getClientArea().height;
      int height = Math.min(LINES_HEIGHT, room);
      text.setBounds(at.x - Theme.STEP, Math.clamp(at.y, 0, Math.max(0, room - height)), at.width + Theme.STEP, height);
    } else {
      int height = Math.min(at.height, text.computeSize(SWT.DEFAULT, SWT.DEFAULT).y);
      text.setBounds(at.x - Theme.STEP, at.y + (at.height - height) / 2, at.width + Theme.STEP, height);
    }
  }

  private void left(Text text) {
    if (field.filter(now -> now == text).isPresent()) {
      cancel();
    }
  }

  private void key(Event event, ParameterRow row, Text text, Object value) {
    if (event.keyCode == SWT.ESC) {
      cancel();
      parent.setFocus();
    } else if ((event.keyCode == SWT.CR || event.keyCode == SWT.KEYPAD_CR)
        && ((text.getStyle() & SWT.MULTI) == 0 || (event.stateMask & SWT.MOD1) != 0)) {
      event.doit = false;
      commit(row, text, value);
    }
  }

  private void commit(ParameterRow row, Text text, Object before) {
    try {
      Object value = ValueReader.read(text.getText(), before);
      cancel();
      parent.setFocus();
      if (!value.equals(before)) {
        model.set(row.key(), value);
      }
    } catch (Unreadable e) {
      model.tell(Health.BAD, e.getMessage());
    }
  }

  /** Says what is wrong while it is typed. */
  private void check(Text text, Object before) {
    try {
      ValueReader.read(text.getText(), before);
      text.setForeground(theme.color(Role.TEXT));
      model.tell(ParameterNotice.NOTHING.health(), ParameterNotice.NOTHING.text());
    } catch (Unreadable e) {
      text.setForeground(theme.color(Role.BAD));
      model.tell(Health.BAD, e.getMessage());
    }
  }
}
