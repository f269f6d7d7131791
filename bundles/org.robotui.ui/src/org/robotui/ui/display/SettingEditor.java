package org.robotui.ui.display;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.input.Numerals;
import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.CheckBox;
import org.robotui.ui.control.ChoiceField;
import org.robotui.ui.control.PopupMenu;

/**
 * A control for one setting.
 *
 * @param control the control
 * @param show shows a value that came from elsewhere
 */
record SettingEditor(Control control, Consumer<Object> show) {
  private static final int INSET = 6;

  /** Shows a value. */
  void show(Object value) {
    show.accept(value);
  }

  /** Makes the control that fits the type; the consumer gets values that fit. */
  static SettingEditor of(Composite parent, Theme theme, Setting setting, Consumer<Object> changed) {
    return switch (setting.type()) {
      case ValueType.Flag f -> flag(parent, theme, setting, changed);
      case ValueType.Choice c -> choice(parent, theme, setting, c, changed);
      default -> text(parent, theme, setting, changed);
    };
  }

  private static SettingEditor flag(Composite parent, Theme theme, Setting setting, Consumer<Object> changed) {
    boolean[] on = new boolean[1];
    CheckBox box = new CheckBox(parent, theme, setting.name(), () -> changed.accept(!on[0]));
    return new SettingEditor(box.control(), value -> {
      on[0] = Boolean.TRUE.equals(value);
      box.show(on[0]);
    });
  }

  private static SettingEditor choice(Composite parent, Theme theme, Setting setting, ValueType.Choice type,
      Consumer<Object> changed) {
    String[] now = {""};
    ChoiceField[] field = new ChoiceField[1];
    field[0] = new ChoiceField(parent, theme, setting.name(), () -> {
      PopupMenu menu = new PopupMenu(field[0].control());
      type.words().forEach(w -> menu.radio(w, w.equals(now[0]), () -> changed.accept(w)));
      menu.openBelow(field[0].control());
    });
    return new SettingEditor(field[0].control(), value -> {
      now[0] = value.toString();
      field[0].show(now[0]);
    });
  }

  private static SettingEditor text(Composite parent, Theme theme, Setting setting, Consumer<Object> changed) {
    Composite well = Boxes.inset(parent, theme, 1, INSET, 0);
    well.setBackground(theme.color(Role.GROUND));
    ((GridLayout) well.getLayout()).marginHeight = 0;
    Text text = new Text(well, SWT.SINGLE);
    text.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, true));
    text.setFont(theme.font(Face.BODY));
    text.setBackground(theme.color(Role.GROUND));
    String help = setting.help() + "\n" + setting.type().expected();
    text.setToolTipText(help);
    boolean[] showing = new boolean[1];
    text.addListener(SWT.Modify, e -> {
      try {
        Object value = read(setting.type(), text.getText());
        judged(text, theme, Role.TEXT, help);
        if (!showing[0]) {
          changed.accept(value);
        }
      } catch (Unreadable fault) {
        judged(text, theme, Role.BAD, "'" + text.getText() + "' " + fault.getMessage() + "\n" + help);
      }
    });
    text.setForeground(theme.color(Role.TEXT));
    return new SettingEditor(well, value -> {
      String words = words(value);
      if (!text.isFocusControl() && !text.getText().equals(words)) {
        showing[0] = true;
        text.setText(words);
        showing[0] = false;
      }
    });
  }

  private static void judged(Text text, Theme theme, Role role, String words) {
    text.setForeground(theme.color(role));
    text.setToolTipText(words);
  }

  /** A value as it is typed. */
  static String words(Object value) {
    if (value instanceof List<?> list) {
      return String.join(", ", list.stream().map(SettingEditor::words).toList());
    }
    return value instanceof Double number ? Numerals.text(number) : value.toString();
  }

  /** What was typed; the message goes on with a sentence that begins with it. */
  static Object read(ValueType type, String typed) throws Unreadable {
    return switch (type) {
      case ValueType.Text t -> fit(t, typed);
      case ValueType.Num n -> fit(n, TypedText.finite(typed));
      case ValueType.Int i -> fit(i, TypedText.whole(typed));
      case ValueType.Flag f -> TypedText.flag(typed);
      case ValueType.Choice c -> fit(c, typed.strip());
      case ValueType.ListOf l -> list(l, typed.strip());
      case ValueType.AnyOf any -> any(any, typed);
      default -> throw new Unreadable("cannot be typed in one line");
    };
  }

  private static Object fit(ValueType type, Object value) throws Unreadable {
    return type.fit(value).orElseThrow(() -> new Unreadable("must be " + type.expected()));
  }

  private static Object list(ValueType.ListOf type, String words) throws Unreadable {
    List<Object> values = new ArrayList<>();
    for (String item : words.isEmpty() ? new String[0] : words.split(",", -1)) {
      values.add(read(type.element(), item.strip()));
    }
    return List.copyOf(values);
  }

  private static Object any(ValueType.AnyOf type, String typed) throws Unreadable {
    for (ValueType alternative : type.alternatives()) {
      try {
        return read(alternative, typed);
      } catch (Unreadable e) {
        continue;
      }
    }
    throw new Unreadable("must be " + type.expected());
  }
}
